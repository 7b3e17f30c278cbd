#include "ratio_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::bench {

namespace {

/// The entry of that name, appended where there is none.
template <class Entries, class Member>
auto& entry_of(Entries& entries, const std::string& name, Member member) {
  const auto found = std::ranges::find(entries, name, member);
  if (found != entries.end()) return *found;
  entries.push_back({name, {}});
  return entries.back();
}

}  // namespace

RatioTable::Row& RatioTable::row_of(const std::string& run) {
  const std::size_t first = run.find('|');
  const std::size_t second = run.find('|', first + 1);
  Contest& contest = entry_of(contests_, run.substr(0, first), &Contest::name);
  return entry_of(contest.rows, run.substr(first + 1, second - first - 1), &Row::set);
}

void RatioTable::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) {
      fmt::print(stderr, "{}: {}\n", run.benchmark_name(), run.error_message);
      continue;
    }
    const bool counts = run.run_type == Run::RT_Aggregate ? run.aggregate_name == "median" : run.repetitions <= 1;
    if (!counts) continue;
    const std::string& name = run.run_name.function_name;
    Side& side = row_of(name).sides[name.substr(name.rfind('|') + 1)];
    side.nanoseconds = run.GetAdjustedRealTime();
    for (const auto& [counter, value] : run.counters) side.counters[counter] = value.value;
  }
}

void RatioTable::Finalize() {
  for (auto& [contest, rows] : contests_) {
    std::erase_if(rows, [](const Row& row) { return row.sides.size() < 2; });  // --benchmark_filter
    if (rows.empty()) continue;
    std::vector<std::string> counters;
    for (const auto& [counter, value] : rows[0].sides["ours"].counters) {
      if (counter != "triangles") counters.push_back(counter);
    }
    fmt::print("\n### {}\n\n| meshes | triangles | ours, ns a triangle | peer | ours / peer |", contest);
    for (const std::string& counter : counters) fmt::print(" {} ours | peer |", counter);
    fmt::print("\n|---|---:|---:|---:|---:|");
    for (std::size_t i = 0; i < counters.size(); ++i) fmt::print("---:|---:|");
    for (Row& row : rows) {
      Side& ours = row.sides["ours"];
      Side& peer = row.sides["peer"];
      const double triangles = ours.counters["triangles"];
      fmt::print("\n| {} | {:.0f} | {:.1f} | {:.1f} | **{:.2f}** |", row.set, triangles, ours.nanoseconds / triangles,
                 peer.nanoseconds / triangles, ours.nanoseconds / peer.nanoseconds);
      for (const std::string& counter : counters) {
        fmt::print(" {:.4f} | {:.4f} |", ours.counters[counter], peer.counters[counter]);
      }
    }
    fmt::print("\n");
  }
}

}  // namespace foredraw::bench
