#include "clock_rules.h"

#include <map>
#include <regex>
#include <sstream>

namespace foredraw::architecture {

namespace {

/// Files that may read a clock, and why: none of them asserts what it reads.
const std::map<std::string, std::string>& readers() {
  static const std::map<std::string, std::string> reasons = {
      {"tests/architecture/clock_rules.cpp", "names the clocks"},
      {"tests/architecture/rules_test.cpp", "names them too"},
      {"tests/farm/processes.py", "gives up on processes that do not end"},
      {"tests/farm/slurm.py", "gives up on a cluster that does not answer"},
      {"tests/hostile/kill_test.cpp", "chooses moments at which programs are killed"},
      {"tests/long/displaced_growth_test.cpp", "prints figures of docs/benchmarks.md"},
      {"tests/python/runs_test.py", "waits until a run has begun to work"},
  };
  return reasons;
}

}  // namespace

Breaches clock_breaches(const std::string& path, const std::string& text) {
  static const std::regex clocks(
      R"(steady_clock|system_clock|high_resolution_clock|std::clock\(|clock_gettime|performance\.now|Date\.now)"
      R"(|perf_counter|time\.(time|monotonic|process_time)\(|waitForTimeout)");
  Breaches breaches;
  if (!path.starts_with("tests/") || readers().contains(path)) return breaches;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, clocks)) {
      breaches.push_back(path + ':' + std::to_string(number) + ": '" + match.str() +
                         "': no test asserts time; wait for the event or count work, or measure in benchmarks/");
    }
  }
  return breaches;
}

}  // namespace foredraw::architecture
