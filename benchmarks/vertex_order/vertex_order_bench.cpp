// Quality against run time of every vertex-cache orderer at every setting, ours and the peers', in one run. The
// repetitions are mixed, so that a noisy moment hits all alike, and the median counts. All raw figures go to a file,
// which vertex_orders_page.py makes a page of.
//
//     vertex-order-bench --tsv=FILE [--quick] [Google Benchmark's options, such as --benchmark_filter=tipsify]

#include "contestants.h"
#include "grid_strips.h"
#include "order_figures.h"
#include "order_tasks.h"

#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <map>

namespace foredraw::bench {
namespace {

struct Arguments {
  std::string tsv;
  bool is_quick = false;
  std::vector<char*> rest;  // Google Benchmark's
};

std::string run_name(const Contestant& contestant, const OrderTask& task) {
  return fmt::format("{}|{}|{}", contestant.name(), task.set.name, task.arrangement);
}

struct Time {
  double nanoseconds;
  std::int64_t repetitions;  // that it is the median of
};

/// The median time of each run.
class MedianTimes final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const bool counts = run.run_type == Run::RT_Aggregate ? run.aggregate_name == "median" : run.repetitions <= 1;
      if (counts) times[run.run_name.function_name] = {run.GetAdjustedRealTime(), run.repetitions};
    }
  }
  std::map<std::string, Time> times;
};

/// What a run's orders are worth is counted once, of what its first iteration made.
void register_all(const std::vector<Contestant>& all, const std::vector<OrderTask>& tasks,
                  std::map<std::string, OrderFigures>& figures) {
  for (const Contestant& contestant : all) {
    for (const OrderTask& task : tasks) {
      const std::string name = run_name(contestant, task);
      benchmark::RegisterBenchmark(name.c_str(), [&, name](benchmark::State& state) {
        const std::size_t wanted = figures.contains(name) ? 0 : task.set.meshes.size();
        std::vector<Indices> first;
        first.reserve(wanted);
        for (auto _ : state) {
          for (const TestMesh& mesh : task.set.meshes) {
            Indices result = contestant.work(mesh.indices, mesh.positions.size());
            benchmark::DoNotOptimize(result);
            if (first.size() < wanted) first.push_back(std::move(result));
          }
        }
        if (wanted > 0) figures[name] = figures_of(task.set, first);
      })->Unit(benchmark::kNanosecond);
    }
  }
}

/// One line for each order of a task.
class Table {
 public:
  explicit Table(std::ostream& out) : out_(out) {
    out_ << "order\tsetting\tsize\tmeshes\tarrangement\ttriangles\trepetitions\tns a triangle";
    for (const std::string& cache : cache_names()) out_ << "\tACMR " << cache;
    out_ << "\tATVR\tOVR\n";
  }
  void add(const std::string& order, const std::string& setting, const OrderTask& task, std::optional<Time> time,
           const OrderFigures& figures) {
    const auto triangles = task.set.triangles();
    out_ << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t", order, setting, task.size, task.set.name, task.arrangement,
                        triangles);
    out_ << (time ? fmt::format("{}\t{:.2f}", time->repetitions, time->nanoseconds / static_cast<double>(triangles))
                  : "\t");
    for (const double acmr : figures.acmr) out_ << fmt::format("\t{:.5f}", acmr);
    out_ << fmt::format("\t{:.5f}\t", figures.atvr) << (figures.ovr ? fmt::format("{:.5f}", *figures.ovr) : "") << '\n';
  }

 private:
  std::ostream& out_;
};

/// What stands beside the contestants: the triangles as they come, and the best known strips on grids.
void add_references(Table& table, const OrderTask& task) {
  std::vector<Indices> as_they_come;
  for (const TestMesh& mesh : task.set.meshes) as_they_come.push_back(mesh.indices);
  table.add("as it comes", "", task, std::nullopt, figures_of(task.set, as_they_come));
  if (task.arrangement != "own") return;  // strips know a grid by its numbers
  for (const Grid& grid : grids) {
    if (task.set.name != grid.name()) continue;
    for (const auto& [setting, width] : {std::pair{"plain", plain_strips(16)}, {"primed", primed_strips(16)}}) {
      const Indices strips = reordered(task.set.meshes[0].indices, grid_strips(grid.columns, grid.rows, width));
      table.add("strips", setting, task, std::nullopt, figures_of(task.set, {strips}));
    }
  }
}

void write_table(std::ostream& out, const std::vector<Contestant>& all, const std::vector<OrderTask>& tasks,
                 const std::map<std::string, Time>& times, const std::map<std::string, OrderFigures>& figures) {
  Table table(out);
  for (const OrderTask& task : tasks) {
    const auto was_timed = [&](const Contestant& contestant) { return times.contains(run_name(contestant, task)); };
    if (!std::ranges::any_of(all, was_timed)) continue;  // --benchmark_filter
    add_references(table, task);
    for (const Contestant& contestant : all) {
      if (!was_timed(contestant)) continue;
      const std::string name = run_name(contestant, task);
      table.add(contestant.order, contestant.setting, task, times.at(name), figures.at(name));
    }
  }
}

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 0; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with("--tsv=")) {
      arguments.tsv = word.substr(6);
    } else if (word == "--quick") {
      arguments.is_quick = true;
    } else {
      arguments.rest.push_back(argv[i]);
    }
  }
  return arguments;
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  Arguments arguments = read_arguments(argc, argv);
  std::string defaults[] = {arguments.is_quick ? "--benchmark_repetitions=3" : "--benchmark_repetitions=7",
                            "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.05"};
  for (std::string& argument : defaults) arguments.rest.insert(arguments.rest.begin() + 1, argument.data());
  int count = static_cast<int>(arguments.rest.size());
  benchmark::Initialize(&count, arguments.rest.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.rest.data())) return 1;
  if (arguments.tsv.empty()) {
    std::cerr << argv[0] << ": no output file; --tsv=FILE sets where the figures go\n";
    return 1;
  }
  std::ofstream out(arguments.tsv);  // before the minutes that the run takes
  if (!out) {
    std::cerr << arguments.tsv << ": cannot be written\n";
    return 1;
  }
  const std::vector<Contestant> all = contestants();
  const std::vector<OrderTask> tasks = order_tasks(arguments.is_quick ? 300'000 : 2'000'000);
  std::map<std::string, OrderFigures> figures;
  register_all(all, tasks, figures);
  MedianTimes reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  write_table(out, all, tasks, reporter.times, figures);
  if (!out.flush()) {
    std::cerr << arguments.tsv << ": cannot be written to the end\n";
    return 1;
  }
}
