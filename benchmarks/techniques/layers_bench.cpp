// Judging one more order from fragment layers against drawing it: our own two ways to the same counts. The orders are
// random, the layers are there already; making them stands against drawing once.

#include "bench_meshes.h"
#include "ratio_table.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/analysis/cluster_layers.h>
#include <plugins/clusterers/linear_clusters/linear_clusters.h>

#include <fmt/format.h>

#include <functional>
#include <numeric>
#include <stdexcept>

namespace foredraw::bench {
namespace {

struct Setting {
  std::string name;
  int views;
  bool culls_back_faces;
};

std::vector<std::uint32_t> random_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  Random random(1);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

OverdrawCount drawn(const TestMesh& mesh, std::span<const std::uint32_t> indices, const Setting& setting) {
  const Views views = make_views({.views = "icosphere", .count = setting.views});
  const RasterPart part{mesh.positions, indices, setting.culls_back_faces};
  const OverdrawCounts counts = overdraw_raster({&part, 1}, views);
  OverdrawCount sum;
  for (const OverdrawCount& count : counts[0]) sum += count;
  return sum;
}

FragmentLayers captured(const TestMesh& mesh, const Setting& setting) {
  static const Executor one_thread(1);
  const Views views = make_views({.views = "icosphere", .count = setting.views});
  const RasterPart part{mesh.positions, mesh.indices, setting.culls_back_faces};
  return fragment_layers({&part, 1}, views, one_thread, std::size_t{1} << 32).value();
}

/// A mesh with an order to judge, once as owners and once as the index buffer to draw.
struct Candidate {
  Layers layers;
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> indices;
};

Candidate of_triangles(const TestMesh& mesh, const Setting& setting) {
  Candidate result;
  result.layers = captured(mesh, setting);
  result.order = random_order(result.layers.owners);
  result.indices = reordered(mesh.indices, result.order);
  return result;
}

Candidate of_clusters(const TestMesh& mesh, const Setting& setting) {
  const Clusters clusters = linear_clusters(mesh.indices, mesh.positions.size(), 16, {.growth = 1.05f});
  Candidate result;
  result.layers = cluster_layers(captured(mesh, setting), clusters, Executor(1));
  result.order = random_order(clusters.count());
  for (const std::uint32_t c : result.order) {
    result.indices.insert(result.indices.end(), mesh.indices.begin() + 3 * std::ptrdiff_t{clusters.offsets[c]},
                          mesh.indices.begin() + 3 * std::ptrdiff_t{clusters.offsets[c + 1]});
  }
  return result;
}

using Candidates = std::vector<Candidate>;
using Make = std::function<Candidate(const TestMesh&, const Setting&)>;

void add_side(RatioTable& table, const std::string& run, const MeshSet& set,
              const std::function<void(benchmark::State&)>& work) {
  table.expect(run);
  benchmark::RegisterBenchmark(run.c_str(), [&set, work](benchmark::State& state) {
    work(state);
    state.counters["triangles"] = static_cast<double>(set.triangles());
  })->Unit(benchmark::kNanosecond);
}

void add_judging(RatioTable& table, const std::string& contest, const MeshSet& set, const Setting& setting,
                 const Make& make) {
  // Made on the first ask, so that what is filtered out costs nothing.
  const auto kept = std::make_shared<Candidates>();
  const auto candidates = [kept, &set, setting, make]() -> const Candidates& {
    for (std::size_t i = kept->size(); i < set.meshes.size(); ++i) {
      kept->push_back(make(set.meshes[i], setting));
      if (count_overdraw(kept->back().layers, kept->back().order) !=
          drawn(set.meshes[i], kept->back().indices, setting)) {
        throw std::logic_error("layers count something else than drawing does");
      }
    }
    return *kept;
  };
  add_side(table, fmt::format("{}|{}|ours", contest, set.name), set, [candidates](benchmark::State& state) {
    const Candidates& all = candidates();
    double bytes = 0;
    for (const Candidate& one : all) bytes += static_cast<double>(one.layers.bytes());
    for (auto _ : state) {
      for (const Candidate& one : all) benchmark::DoNotOptimize(count_overdraw(one.layers, one.order));
    }
    state.counters["MB"] = bytes / 1e6;
  });
  add_side(table, fmt::format("{}|{}|peer", contest, set.name), set,
           [candidates, &set, setting](benchmark::State& state) {
             const Candidates& all = candidates();
             for (auto _ : state) {
               for (std::size_t i = 0; i < all.size(); ++i) {
                 benchmark::DoNotOptimize(drawn(set.meshes[i], all[i].indices, setting));
               }
             }
           });
}

void add_making(RatioTable& table, const std::string& contest, const MeshSet& set, const Setting& setting) {
  add_side(table, fmt::format("{}|{}|ours", contest, set.name), set, [&set, setting](benchmark::State& state) {
    for (auto _ : state) {
      for (const TestMesh& mesh : set.meshes) benchmark::DoNotOptimize(captured(mesh, setting).views.data());
    }
  });
  add_side(table, fmt::format("{}|{}|peer", contest, set.name), set, [&set, setting](benchmark::State& state) {
    for (auto _ : state) {
      for (const TestMesh& mesh : set.meshes) benchmark::DoNotOptimize(drawn(mesh, mesh.indices, setting));
    }
  });
}

/// Every draw of the corpus of 6,000 to 300,000 triangles.
std::vector<MeshSet> middling_draws() {
  std::vector<MeshSet> sets;
  for (TestMesh& mesh : corpus().meshes) {
    const std::size_t triangles = mesh.indices.size() / 3;
    if (triangles >= 6000 && triangles <= 300000) {
      sets.push_back({fmt::format("draw {} of {} triangles", sets.size(), triangles), {std::move(mesh)}});
    }
  }
  return sets;
}

}  // namespace

void add_layer_contests(RatioTable& table) {
  static const std::vector<MeshSet> sets = [] {
    std::vector<MeshSet> all = middling_draws();
    for (const char* model : {"static/spot.glb", "static/head.glb"}) {
      for (MeshSet& size : subdivisions(model, {0, 2})) all.push_back(std::move(size));
    }
    return all;
  }();
  const std::vector<Setting> settings = {{"42 views", 42, true},
                                         {"162 views", 162, true},
                                         {"42 views, back faces drawn too", 42, false},
                                         {"162 views, back faces drawn too", 162, false}};
  for (const Setting& setting : settings) {
    for (const MeshSet& set : sets) {
      add_judging(table, "an order of triangles from layers against drawing it, " + setting.name, set, setting,
                  of_triangles);
      add_judging(table, "an order of clusters from layers against drawing it, " + setting.name, set, setting,
                  of_clusters);
      add_making(table, "making layers against drawing once, " + setting.name, set, setting);
    }
  }
}

}  // namespace foredraw::bench
