#pragma once
// Google Benchmark's results as the tables of docs/results/benchmarks.md: ours beside the peer, as ratios.

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace foredraw::bench {

/// Takes runs named "contest|set|side", the side being `ours` or `peer`, with the counter `triangles`; prints a table
/// for each contest when all are done. Medians where runs were repeated; further counters are shown as they are, a side
/// each.
class RatioTable final : public benchmark::BenchmarkReporter {
 public:
  /// Says that such a run will come: rows stand in the sequence in which they were expected, whatever comes first.
  void expect(const std::string& run) { row_of(run); }

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  struct Side {
    double nanoseconds = 0;
    std::map<std::string, double> counters;
  };
  struct Row {
    std::string set;
    std::map<std::string, Side> sides;
  };
  struct Contest {
    std::string name;
    std::vector<Row> rows;
  };
  Row& row_of(const std::string& run);

  std::vector<Contest> contests_;
};

}  // namespace foredraw::bench
