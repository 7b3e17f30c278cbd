#pragma once
// The records of several runs over parts of a folder, put together to that of the whole.

#include <foredraw/report/batch.h>

#include <set>

namespace foredraw {

class BatchJoin {
 public:
  /// The spool lives as long.
  explicit BatchJoin(Spool& spool) : spool_(spool) {}

  /// The JSON form of a batch; `name` is what diagnostics call it. False, with an error, where it is none, or holds
  /// files that another one holds.
  bool add(const std::string& text, const std::string& name, Diagnostics& diagnostics);

  /// A warning for each part that is missing. False where there is one.
  bool is_whole(Diagnostics& diagnostics) const;

  /// Files in the sequence of one run, whichever part they came in.
  void put_into(Batch& batch) const;

  const std::string& command() const { return command_; }
  double seconds() const { return seconds_; }  ///< of all parts together

 private:
  struct File {
    std::filesystem::path path;
    Spool::Place report;
    Outcome outcome = Outcome::done;
    bool from_cache = false;
    std::string part;  ///< the name of what it came in
  };

  Spool& spool_;
  std::vector<File> files_;
  std::string command_;
  double seconds_ = 0;
  std::set<std::uint32_t> numbers_;
  std::uint32_t of_ = 0;  ///< 0: no part says
};

}  // namespace foredraw
