#pragma once
// What changed since an earlier run over the same files: the worst first.

#include <foredraw/report/baseline.h>
#include <foredraw/report/batch.h>
#include <foredraw/report/metrics.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace foredraw {

class Since {
 public:
  /// A figure of a file that is another than it was.
  struct Change {
    std::string file;
    std::string figure;  ///< "vertex-cache acmr"
    std::string was, now;
    std::string change;  ///< "+4.1 %"
    double worse = 0;    ///< parts of what it was, by which it is worse; below 0: better. Infinite where it was 0
  };

  /// `name`: of the baseline's file; the baseline lives as long. `is_part`: this run is over some of the files that
  /// there are.
  Since(std::string name, const Baseline& baseline, bool is_part = false)
      : name_(std::move(name)), baseline_(baseline), is_part_(is_part) {}

  /// Figures of groups ("models.amd.acmr") are left out, and those whose change is no gain and no loss, or may be due
  /// to their errors, or is below 0.05 % and no count's.
  void add(const std::string& file, const Metrics& after);
  /// One that could not be read, planned for or written.
  void add_lost(const std::string& file);
  /// Of a batch, either of these.
  void add(const StoredReport& report, Outcome outcome);

  /// Behind all files. From the worst to the best.
  std::vector<Change> changes() const;
  std::vector<std::string> gone() const;

  /// How many figures of how many files, the worst of them, and files that are lost, new or gone.
  std::string to_text() const;
  std::string to_json() const;

 private:
  std::string name_;
  const Baseline& baseline_;
  bool is_part_ = false;
  std::vector<Change> changes_;
  std::vector<std::string> lost_, new_;
  std::set<std::string> seen_;  ///< of the baseline
  std::size_t same_ = 0;        ///< files of which no figure changed
};

}  // namespace foredraw
