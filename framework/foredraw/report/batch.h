#pragma once
// Many files, each worked on by itself: a line for every file, and their sum. Memory holds the lines alone: reports go
// into a file as they come.

#include <foredraw/platform/spool.h>
#include <foredraw/report/shard.h>
#include <foredraw/report/stored_report.h>

#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace foredraw {

enum class Outcome {
  done,
  in_part,  ///< a stage failed somewhere, and left what it found
  lost,     ///< the file could not be read, planned for or written: the report's diagnostics say why
};

class Batch {
 public:
  /// Called once for each file in their sequence, as soon as all before it are there; never twice at once.
  using Told = std::function<void(const StoredReport&, Outcome)>;

  /// `spool`: where reports wait; it lives as long. `registry` too.
  Batch(std::string command, const Registry& registry, Spool& spool, Told told = {});

  /// A file's report, in its JSON form, by the file's place in the sequence, from 0 on without gaps. From any threads,
  /// in any sequence. Throws std::invalid_argument where it is none, std::runtime_error where the spool is full.
  void add(std::size_t number, std::string_view report, Outcome outcome, bool from_cache = false);

  std::size_t size() const { return rows_.size(); }
  std::size_t from_cache() const { return from_cache_; }
  /// Whether no file was lost, nor any stage failed.
  bool is_done() const;
  /// The sum over the files that were not lost.
  const StateRecord& before() const { return before_; }
  const StateRecord& after() const { return after_; }

  /// The JSON form, piece by piece: the totals, and each file's whole report. `since`: Since::to_json() of it, or
  /// empty.
  void write_json(double seconds, const std::optional<Shard>& shard, const std::function<void(std::string_view)>& put,
                  const std::string& since = {}) const;
  /// A table with a row a file: of each evaluator its first ratio, and the bytes, before and after.
  std::string to_text(double seconds) const;

 private:
  struct Added {
    Spool::Place place;
    Outcome outcome = Outcome::done;
    bool from_cache = false;
  };
  struct Row {
    std::string path;
    std::vector<std::pair<std::size_t, std::string>> cells;  ///< by the number of their column
    std::string bytes;
    std::uint64_t read = 0, written = 0;
    Outcome outcome = Outcome::done;
  };

  void take(const Added& added);  ///< the next one
  std::size_t column(const std::string& evaluator, const std::string& metric);
  Row row_of(const StoredReport& report, Outcome outcome);

  std::string command_;
  const Registry& registry_;
  Spool& spool_;
  Told told_;

  std::mutex mutex_;
  std::map<std::size_t, Added> waiting_;  ///< for those before them
  std::size_t next_ = 0;
  bool is_taking_ = false;

  std::vector<Added> added_;
  std::vector<Row> rows_;
  std::map<std::pair<std::string, std::string>, std::size_t> columns_;
  StateRecord before_, after_;
  bool optimized_ = false;
  std::size_t from_cache_ = 0;
};

std::string_view to_text(Outcome outcome);
std::optional<Outcome> outcome_called(std::string_view word);

}  // namespace foredraw
