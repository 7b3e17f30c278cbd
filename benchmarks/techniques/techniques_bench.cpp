// Our plain functions against meshoptimizer's on the same meshes in one run, one thread each where nothing else is
// said. The repetitions of all benchmarks are mixed, so that a noisy moment hits both sides alike, and the median of
// seven counts.

#include "bench_meshes.h"
#include "ratio_table.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/base/parallel.h>
#include <foredraw/viewing/view_set.h>
#include <plugins/clusterers/linear_clusters/linear_clusters.h>
#include <plugins/orderers/dot_rule/dot_rule.h>
#include <plugins/orderers/tipsify/tipsify.h>
#include <plugins/orderers/vertex_fetch/vertex_fetch.h>
#include <plugins/processors/weld/weld.h>

#include <meshoptimizer.h>

#include <fmt/format.h>

#include <functional>

namespace foredraw::bench {
namespace {

using Indices = std::vector<std::uint32_t>;
using Counters = std::map<std::string, double>;

constexpr int cache_size = 16;
constexpr float threshold = 1.05f;  // linear-clusters.growth, and the peer's threshold

/// The corpus, and spot and head from as they are to 1.5 million triangles.
std::vector<MeshSet> mesh_sets() {
  std::vector<MeshSet> sets{corpus()};
  for (const auto& [model, levels] :
       {std::pair{"static/spot.glb", std::vector{0, 2, 4}}, {"static/head.glb", {0, 2}}}) {
    for (const MeshSet& size : subdivisions(model, levels)) {
      for (MeshSet& set : arrangements(size)) sets.push_back(std::move(set));
    }
  }
  return sets;
}

/// One side of a contest: works on a mesh and answers with the index buffer that came out, where one did.
using Side = std::function<Indices(const TestMesh&)>;
using Judge = std::function<Counters(const MeshSet&, const std::vector<Indices>&)>;

Counters judged(const MeshSet& set, const Side& side, const Judge& judge) {
  std::vector<Indices> results;
  for (const TestMesh& mesh : set.meshes) results.push_back(side(mesh));
  return judge(set, results);
}

void add_side(RatioTable& table, const std::string& name, const MeshSet& set, const Side& side, const Judge& judge) {
  table.expect(name);
  const auto verdict = std::make_shared<Counters>();  // the same in every repetition
  benchmark::RegisterBenchmark(name.c_str(), [&set, side, judge, verdict](benchmark::State& state) {
    for (auto _ : state) {
      for (const TestMesh& mesh : set.meshes) benchmark::DoNotOptimize(side(mesh));
    }
    state.counters["triangles"] = static_cast<double>(set.triangles());
    if (judge && verdict->empty()) *verdict = judged(set, side, judge);
    for (const auto& [counter, value] : *verdict) state.counters[counter] = value;
  })->Unit(benchmark::kNanosecond);
}

void add_contest(RatioTable& table, const std::string& name, const std::vector<MeshSet>& sets, const Side& ours,
                 const Side& peer, const Judge& judge = {}) {
  for (const MeshSet& set : sets) {
    add_side(table, fmt::format("{}|{}|ours", name, set.name), set, ours, judge);
    add_side(table, fmt::format("{}|{}|peer", name, set.name), set, peer, judge);
  }
}

Counters acmr(const MeshSet& set, const std::vector<Indices>& results) {
  double misses = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    misses += static_cast<double>(count_fifo(results[i], set.meshes[i].positions.size(), cache_size).misses);
  }
  return {{"ACMR", misses / static_cast<double>(set.triangles())}};
}

/// ACMR, and OVR from 42 directions with back faces culled.
Counters acmr_and_ovr(const MeshSet& set, const std::vector<Indices>& results) {
  Counters counters = acmr(set, results);
  const Views views = make_views({.views = "icosphere", .count = 42});
  OverdrawCount sum;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const RasterPart part{.positions = set.meshes[i].positions, .indices = results[i]};
    const OverdrawCounts counts = overdraw_raster({&part, 1}, views);
    for (const OverdrawCount& count : counts[0]) sum += count;
  }
  counters["OVR"] = static_cast<double>(sum.shaded) / static_cast<double>(sum.visible);
  return counters;
}

Indices our_cache_order(const TestMesh& mesh) {
  return tipsify_indices(mesh.indices, mesh.positions.size(), {.cache_size = cache_size});
}

Indices our_cache_order_in_parts(const TestMesh& mesh) {
  static const Executor executor(2);
  const auto for_each = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    executor.for_each(count, task);
  };
  return tipsify_parts_indices(mesh.indices, {&mesh.positions[0].x, 3 * mesh.positions.size()}, 8,
                               {.cache_size = cache_size}, for_each);
}

Indices peers_cache_order(const TestMesh& mesh) {
  Indices result(mesh.indices.size());
  meshopt_optimizeVertexCacheFifo(result.data(), mesh.indices.data(), result.size(), mesh.positions.size(), cache_size);
  return result;
}

Indices our_overdraw_order(std::span<const glm::vec3> positions, const Indices& indices) {
  const Clusters clusters = linear_clusters(indices, positions.size(), cache_size, {.growth = threshold});
  Indices result;
  result.reserve(indices.size());
  for (const std::uint32_t c : dot_rule(positions, indices, clusters)) {
    result.insert(result.end(), indices.begin() + 3 * std::ptrdiff_t{clusters.offsets[c]},
                  indices.begin() + 3 * std::ptrdiff_t{clusters.offsets[c + 1]});
  }
  return result;
}

Indices peers_overdraw_order(std::span<const glm::vec3> positions, const Indices& indices) {
  Indices result(indices.size());
  meshopt_optimizeOverdraw(result.data(), indices.data(), indices.size(), &positions[0].x, positions.size(),
                           sizeof(glm::vec3), threshold);
  return result;
}

std::vector<MeshSet> cache_ordered(std::vector<MeshSet> sets) {
  for (MeshSet& set : sets) {
    for (TestMesh& mesh : set.meshes) mesh.indices = our_cache_order(mesh);
  }
  return sets;
}

void add_contests(RatioTable& table, const std::vector<MeshSet>& sets, const std::vector<MeshSet>& ordered) {
  add_contest(table, "tipsify against meshopt_optimizeVertexCacheFifo", sets, our_cache_order, peers_cache_order, acmr);
  add_contest(table, "tipsify in 8 parts on two threads against meshopt_optimizeVertexCacheFifo", sets,
              our_cache_order_in_parts, peers_cache_order, acmr);
  add_contest(
      table, "linear-clusters and dot-rule against meshopt_optimizeOverdraw", ordered,
      [](const TestMesh& mesh) { return our_overdraw_order(mesh.positions, mesh.indices); },
      [](const TestMesh& mesh) { return peers_overdraw_order(mesh.positions, mesh.indices); });
  add_contest(
      table, "tipsify, linear-clusters, dot-rule against both", sets,
      [](const TestMesh& mesh) { return our_overdraw_order(mesh.positions, our_cache_order(mesh)); },
      [](const TestMesh& mesh) { return peers_overdraw_order(mesh.positions, peers_cache_order(mesh)); }, acmr_and_ovr);
  add_contest(
      table, "vertex-fetch against meshopt_optimizeVertexFetchRemap", ordered,
      [](const TestMesh& mesh) {
        const std::span<const std::uint32_t> indices(mesh.indices);
        return vertex_fetch({&indices, 1}, mesh.positions.size());
      },
      [](const TestMesh& mesh) {
        Indices remap(mesh.positions.size());
        meshopt_optimizeVertexFetchRemap(remap.data(), mesh.indices.data(), mesh.indices.size(), remap.size());
        return remap;
      });
  add_contest(
      table, "weld against meshopt_generateVertexRemap (positions alone)", sets,
      [](const TestMesh& mesh) {
        const auto vertices = testing::vertex_streams(mesh.positions);
        const std::span<const std::uint32_t> indices(mesh.indices);
        return weld(*vertices, {&indices, 1}).destination;
      },
      [](const TestMesh& mesh) {
        Indices remap(mesh.positions.size());
        meshopt_generateVertexRemap(remap.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                    mesh.positions.size(), sizeof(glm::vec3));
        return remap;
      });
  add_contest(
      table, "vertex-cache (FIFO of 16) against meshopt_analyzeVertexCache", ordered,
      [](const TestMesh& mesh) {
        benchmark::DoNotOptimize(count_fifo(mesh.indices, mesh.positions.size(), cache_size));
        return Indices{};
      },
      [](const TestMesh& mesh) {
        benchmark::DoNotOptimize(meshopt_analyzeVertexCache(mesh.indices.data(), mesh.indices.size(),
                                                            mesh.positions.size(), cache_size, 0, 0));
        return Indices{};
      });
  add_contest(
      table, "overdraw-raster (6 views of 256 x 256) against meshopt_analyzeOverdraw", ordered,
      [](const TestMesh& mesh) {
        static const Views views = make_views({.views = "axes"});
        const RasterPart part{.positions = mesh.positions, .indices = mesh.indices};
        benchmark::DoNotOptimize(overdraw_raster({&part, 1}, views));
        return Indices{};
      },
      [](const TestMesh& mesh) {
        benchmark::DoNotOptimize(meshopt_analyzeOverdraw(mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x,
                                                         mesh.positions.size(), sizeof(glm::vec3)));
        return Indices{};
      });
}

}  // namespace

void add_file_contests(RatioTable& table);  // files_bench.cpp

}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::vector<char*> arguments{argv[0]};
  std::string defaults[] = {"--benchmark_repetitions=7", "--benchmark_enable_random_interleaving=true",
                            "--benchmark_min_time=0.05"};
  for (std::string& argument : defaults) arguments.push_back(argument.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  const std::vector<MeshSet> sets = mesh_sets();
  const std::vector<MeshSet> ordered = cache_ordered(sets);
  RatioTable table;
  add_contests(table, sets, ordered);
  add_file_contests(table);
  benchmark::RunSpecifiedBenchmarks(&table);
}
