#pragma once
// Files that changed, until they are left alone: programs write a file in several steps, and several files that belong
// together one after the other.

#include <foredraw/platform/file_facts.h>

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace foredraw::cli {

class Settling {
 public:
  using Clock = std::chrono::steady_clock;
  /// Files by their paths.
  using Seen = std::map<std::string, FileFacts>;
  /// True if a program has the file open to write.
  using IsOpen = std::function<bool(const std::string&)>;

  /// Files have settled once nothing has changed for so long, or, if something always does, they themselves have not
  /// while ten times as long went by. `seen`: the files at the beginning.
  Settling(Clock::duration quiet, Seen seen) : quiet_(quiet), seen_(std::move(seen)) {}

  /// Takes the files as they are now. A file that came, went or has other facts than before has changed.
  void look(Seen seen, Clock::time_point now);

  /// A file that is in `seen` from the next time on.
  void add(const std::string& file, const FileFacts& facts) { seen_.try_emplace(file, facts); }

  /// Returns and forgets the files that have settled, sorted. One that a program still has open stays.
  std::vector<std::string> settled(Clock::time_point now, const IsOpen& is_open);

  Clock::duration quiet() const { return quiet_; }
  bool waits_for(const std::string& file) const { return waiting_.contains(file); }

 private:
  struct Waiting {
    Clock::time_point first, last;
  };

  void changed(const std::string& file, Clock::time_point now);
  bool is_quiet(const Waiting& waiting, Clock::time_point now) const;

  Clock::duration quiet_;
  Clock::time_point last_;
  Seen seen_;
  std::map<std::string, Waiting> waiting_;
};

}  // namespace foredraw::cli
