// Judging one more order from fragment layers against drawing it, one thread each. The orders are random and the counts
// are held against each other. Every round does all of it one behind the other, so that a noisy moment hits all alike;
// the median of seven rounds counts.

#include "bench_meshes.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/viewing/view_set.h>
#include <plugins/clusterers/linear_clusters/linear_clusters.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 7;
constexpr std::size_t most_bytes = std::size_t{1} << 32;

using Times = std::array<double, rounds>;  // milliseconds

double median(Times times) {
  std::ranges::sort(times);
  return times[rounds / 2];
}

double milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<std::uint32_t> random_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  Random random(1);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

std::vector<std::uint32_t> triangles_of(const Clusters& clusters, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t c : order) {
    for (std::uint32_t t = clusters.offsets[c]; t < clusters.offsets[c + 1]; ++t) triangles.push_back(t);
  }
  return triangles;
}

OverdrawCount drawn(const RasterPart& part, const Views& views) {
  const OverdrawCounts counts = overdraw_raster({&part, 1}, views);
  return std::accumulate(counts[0].begin(), counts[0].end(), OverdrawCount(),
                         [](OverdrawCount sum, const OverdrawCount& count) { return sum += count; });
}

void hold(bool holds) {
  if (!holds) throw std::logic_error("layers and drawing give different counts");
}

void contest(const std::string& name, const TestMesh& mesh, int count, bool culls_back_faces) {
  const Executor one_thread(1);
  const Views views = make_views({.views = "icosphere", .count = count});
  const RasterPart part{mesh.positions, mesh.indices, culls_back_faces};
  const Clusters clusters = linear_clusters(mesh.indices, mesh.positions.size(), 16, {.growth = 1.05f});
  const std::vector<std::uint32_t> triangle_order = random_order(mesh.indices.size() / 3);
  const std::vector<std::uint32_t> cluster_order = random_order(clusters.count());
  const std::vector<std::uint32_t> indices = reordered(mesh.indices, triangle_order);
  const RasterPart ordered{mesh.positions, indices, culls_back_faces};

  FragmentLayers full;
  ClusterLayers of_clusters;
  Times making, drawing, judging, judging_clusters;
  for (std::size_t i = 0; i < rounds; ++i) {
    OverdrawCount count_drawn, count_judged;
    making[i] = milliseconds([&] { full = fragment_layers({&part, 1}, views, one_thread, most_bytes).value(); });
    if (i == 0) of_clusters = cluster_layers(full, clusters, one_thread);
    drawing[i] = milliseconds([&] { count_drawn = drawn(ordered, views); });
    judging[i] = milliseconds([&] { count_judged = count_overdraw(full, triangle_order); });
    hold(count_judged == count_drawn);
    judging_clusters[i] = milliseconds([&] { count_judged = count_overdraw(of_clusters, cluster_order); });
    if (i == 0) hold(count_judged == count_overdraw(full, triangles_of(clusters, cluster_order)));
  }
  const double draw = median(drawing);
  fmt::print("| {} | {} | {:.1f} | {:.3f} | **{:.0f}** | {:.3f} | **{:.0f}** | {:.1f} | {:.1f} | {:.1f} |\n", name,
             mesh.indices.size() / 3, draw, median(judging), draw / median(judging), median(judging_clusters),
             draw / median(judging_clusters), median(making) / draw, static_cast<double>(full.bytes()) / 1e6,
             static_cast<double>(of_clusters.bytes()) / 1e6);
  std::fflush(stdout);
}

/// Spot and head in two sizes, and the draws of the corpus of 6,000 triangles or more.
std::vector<MeshSet> meshes() {
  std::vector<MeshSet> all;
  for (const char* model : {"static/spot.glb", "static/head.glb"}) {
    for (MeshSet& size : subdivisions(model, {0, 2})) all.push_back(std::move(size));
  }
  const std::size_t models = all.size();
  const MeshSet draws = corpus();
  for (const TestMesh& mesh : draws.meshes) {
    if (mesh.indices.size() / 3 < 6000) continue;
    all.push_back({fmt::format("corpus, draw {}", all.size() - models + 1), {mesh}});
  }
  return all;
}

}  // namespace
}  // namespace foredraw::bench

int main() {
  using namespace foredraw::bench;
  const std::vector<MeshSet> sets = meshes();
  for (const bool culls_back_faces : {true, false}) {
    for (const int views : {42, 162}) {
      fmt::print("\n{} views, back faces {}\n\n", views, culls_back_faces ? "culled" : "drawn");
      fmt::print(
          "| mesh | triangles | drawing, ms | triangles judged, ms | drawing / judging | clusters judged, ms | "
          "drawing / judging | making / drawing | MB | MB of clusters |\n"
          "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
      for (const MeshSet& set : sets) contest(set.name, set.meshes[0], views, culls_back_faces);
    }
  }
}
