// Orders by measured visibility against meshopt_optimizeOverdraw, on models that do not move. Every draw is ordered and
// judged alone, back faces culled, from random directions that no order was made for. The peer starts from
// meshopt_optimizeVertexCache and takes its own threshold 1.05; ours starts from lookahead and may shade as many
// vertices as 1.05 times the best of tipsify, meshopt_optimizeVertexCache and ...Fifo does. Times are of the step from
// the cache order on, on two threads. With the argument `scale`: times and memory of one model cut ever finer, to 1.1
// million triangles.

#include "bench_meshes.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/platform/memory.h>
#include <foredraw/viewing/view_set.h>
#include <plugins/orderers/lookahead/lookahead.h>
#include <plugins/orderers/occlusion_order/k_orders.h>
#include <plugins/orderers/tipsify/tipsify.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string_view>

namespace foredraw::bench {
namespace {

constexpr double budget = 1.05;
constexpr std::size_t rounds = 7;
constexpr std::array models = {"static/chess_board_notex",
                               "static/dutch_ship_medium_notex",
                               "static/flight_helmet_notex",
                               "static/head",
                               "static/spot",
                               "scenes/house"};

using Indices = std::vector<std::uint32_t>;

double milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

struct Setting {
  const char* name;
  OcclusionQuality quality;
  const char* views;
  int count;
};
constexpr std::array settings = {Setting{"fast", OcclusionQuality::fast, "icosphere", 42},
                                 Setting{"balanced", OcclusionQuality::balanced, "fibonacci", 80},
                                 Setting{"high", OcclusionQuality::high, "icosphere", 642}};

double median(std::array<double, rounds> times) {
  std::ranges::sort(times);
  return times[rounds / 2];
}

/// Sums over the draws of a model.
struct Figures {
  std::uint64_t misses = 0, triangles = 0;
  OverdrawCount fragments;
  std::array<double, rounds> times{};  // milliseconds

  void add(const TestMesh& mesh, const Indices& indices) {
    static const Views held_out = make_views({.views = "random", .count = 300, .seed = 77});
    const CacheCount cache = count_fifo(indices, mesh.positions.size(), 16);
    misses += cache.misses;
    triangles += cache.triangles;
    const RasterPart part{mesh.positions, indices};
    const OverdrawCounts counts = overdraw_raster({&part, 1}, held_out);
    for (const OverdrawCount& view : counts[0]) fragments += view;
  }
  double acmr() const { return static_cast<double>(misses) / static_cast<double>(triangles); }
  double excess() const {
    return static_cast<double>(fragments.shaded - fragments.visible) / static_cast<double>(fragments.visible);
  }
  double time() const { return median(times); }
};

struct Contest {
  double best_acmr = 0;
  std::uint64_t best_misses = 0;
  Figures peer;
  std::array<Figures, settings.size()> ours;
};

std::uint64_t misses_of(const TestMesh& mesh, const Indices& indices) {
  return count_fifo(indices, mesh.positions.size(), 16).misses;
}

Indices occlusion_ordered(const TestMesh& mesh, const Indices& base, double acmr_budget, const Setting& setting,
                          const Executor& executor) {
  const Views views = make_views({.views = setting.views, .count = setting.count, .rotation = 1, .size = 128});
  const RasterPart part{mesh.positions, base};
  SubjectLayers subject;
  KOrdersOptions options;
  options.quality = setting.quality;
  options.acmr_budget = acmr_budget;
  const Clusters atoms = cut_atoms(base, mesh.positions.size(), 16, atom_size(options, base.size() / 3));
  static_cast<Layers&>(subject.layers) =
      cluster_layers(fragment_layers({&part, 1}, views, executor).value(), atoms, executor);
  for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) subject.owners.push_back({0, 0, atom});
  for (const View& view : views.views) {
    subject.directions.push_back(view.direction);
    subject.weights.push_back(view.weight);
  }
  subject.draws.push_back({base, mesh.positions.size(), atoms});
  const KOrders found = k_orders(subject, options, executor);
  Indices result;
  for (const std::uint32_t atom : found.orders[0][0]) {
    result.insert(result.end(), base.begin() + 3 * atoms.offsets[atom], base.begin() + 3 * atoms.offsets[atom + 1]);
  }
  return result;
}

void add_draw(Contest& contest, const TestMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  Indices cache(mesh.indices.size()), fifo(mesh.indices.size()), peer(mesh.indices.size());
  meshopt_optimizeVertexCache(cache.data(), mesh.indices.data(), cache.size(), vertices);
  meshopt_optimizeVertexCacheFifo(fifo.data(), mesh.indices.data(), fifo.size(), vertices, 16);
  const Indices tipsy = reordered(mesh.indices, tipsify(mesh.indices, vertices));
  const std::uint64_t best = std::min({misses_of(mesh, cache), misses_of(mesh, fifo), misses_of(mesh, tipsy)});
  contest.best_misses += best;
  const Indices base = reordered(mesh.indices, lookahead(mesh.indices, vertices));
  const double wanted = budget * static_cast<double>(best) / static_cast<double>(misses_of(mesh, base));

  const Executor two(2);
  std::array<Indices, settings.size()> ours;
  for (std::size_t round = 0; round < rounds; ++round) {
    contest.peer.times[round] += milliseconds([&] {
      meshopt_optimizeOverdraw(peer.data(), cache.data(), peer.size(), &mesh.positions[0].x, vertices,
                               sizeof(glm::vec3), static_cast<float>(budget));
    });
    for (std::size_t i = 0; i < settings.size(); ++i) {
      contest.ours[i].times[round] +=
          milliseconds([&] { ours[i] = occlusion_ordered(mesh, base, std::max(1.0, wanted), settings[i], two); });
    }
  }
  contest.peer.add(mesh, peer);
  for (std::size_t i = 0; i < settings.size(); ++i) contest.ours[i].add(mesh, ours[i]);
}

void contest_all() {
  fmt::print("| model | triangles | best ACMR | meshopt: ACMR, excess, ms |");
  for (const Setting& setting : settings)
    fmt::print(" {}: ACMR, excess | of meshopt's | ms | ms for 100k |", setting.name);
  fmt::print("\n|---|---:|---:|---|");
  for (std::size_t i = 0; i < settings.size(); ++i) fmt::print("---|---:|---:|---:|");
  fmt::print("\n");
  std::array<double, settings.size()> logs{}, worst{};
  for (const char* model : models) {
    Contest contest;
    for (const TestMesh& mesh : draws_of(std::string(model) + ".glb").meshes) add_draw(contest, mesh);
    const double triangles = static_cast<double>(contest.peer.triangles);
    fmt::print("| {} | {} | {:.4f} | {:.4f}, {:.4f}, {:.1f} |", model, contest.peer.triangles,
               static_cast<double>(contest.best_misses) / triangles, contest.peer.acmr(), contest.peer.excess(),
               contest.peer.time());
    for (std::size_t i = 0; i < settings.size(); ++i) {
      const Figures& ours = contest.ours[i];
      const double part = ours.excess() / contest.peer.excess();
      logs[i] += std::log(part);
      worst[i] = std::max(worst[i], part);
      fmt::print(" {:.4f}, {:.4f} | **{:.2f}** | {:.0f} | {:.0f} |", ours.acmr(), ours.excess(), part, ours.time(),
                 ours.time() / triangles * 1e5);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  fmt::print("\n");
  for (std::size_t i = 0; i < settings.size(); ++i) {
    fmt::print("{}: geometric mean {:.3f}, worst {:.3f}\n", settings[i].name,
               std::exp(logs[i] / static_cast<double>(models.size())), worst[i]);
  }
}

/// How time grows: from one size to the next there are four times the triangles. The peak is of the whole process so
/// far.
void scale() {
  const Executor two(2);
  fmt::print("| triangles | fast: ms | ms for 100k | balanced: ms | ms for 100k | peak, MB |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|\n");
  for (const MeshSet& size : subdivisions("static/head.glb", {0, 1, 2, 3})) {
    const TestMesh& mesh = size.meshes.front();
    const Indices base = reordered(mesh.indices, lookahead(mesh.indices, mesh.positions.size()));
    const double hundred_thousands = static_cast<double>(base.size()) / 3e5;
    fmt::print("| {} |", base.size() / 3);
    for (const Setting& setting : std::span(settings).first(2)) {
      std::array<double, rounds> times{};
      for (double& time : times) time = milliseconds([&] { occlusion_ordered(mesh, base, budget, setting, two); });
      fmt::print(" {:.0f} | {:.0f} |", median(times), median(times) / hundred_thousands);
    }
    fmt::print(" {:.0f} |\n", static_cast<double>(peak_memory()) / 1e6);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "scale") {
    foredraw::bench::scale();
  } else {
    foredraw::bench::contest_all();
  }
}
