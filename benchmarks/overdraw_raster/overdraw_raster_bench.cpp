// Counting overdraw by drawing against meshopt_analyzeOverdraw, which draws 6 views into 256 x 256 pixels and culls
// back faces: our 162 such views in calls of the peer. Every round does all of it one behind the other, so that a noisy
// moment hits all alike; the median of seven rounds' ratios counts.

#include "bench_meshes.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 7;
constexpr std::size_t least_triangles = 6000;
constexpr std::size_t most_triangles = 1'200'000;

using Figures = std::array<double, rounds>;

double median(Figures figures) {
  std::ranges::sort(figures);
  return figures[rounds / 2];
}

double milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

Views views_from(double distance) {
  ViewSet set;
  set.views = "icosphere";
  if (distance > 0) set.distance = distance;
  return make_views(set);
}

void contest(const std::string& name, const TestMesh& mesh) {
  const RasterPart part{mesh.positions, mesh.indices};
  const Views views = views_from(0);
  const Views near_views = views_from(3);
  const Executor one(1), two(2);
  Figures peer, ours, calls, near_calls, gain;
  for (std::size_t i = 0; i < rounds; ++i) {
    peer[i] = milliseconds([&] {
      meshopt_analyzeOverdraw(mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x, mesh.positions.size(),
                              sizeof(glm::vec3));
    });
    OverdrawCounts alone, together;
    ours[i] = milliseconds([&] { alone = overdraw_raster({&part, 1}, views, one); });
    const double both = milliseconds([&] { together = overdraw_raster({&part, 1}, views, two); });
    const double near = milliseconds([&] { overdraw_raster({&part, 1}, near_views, one); });
    if (alone != together) throw std::logic_error("two threads count something else than one does");
    calls[i] = ours[i] / peer[i];
    near_calls[i] = near / peer[i];
    gain[i] = ours[i] / both;
  }
  fmt::print("| {} | {} | {:.2f} | {:.1f} | **{:.1f}** | {:.1f} | {:.2f} |\n", name, mesh.indices.size() / 3,
             median(peer), median(ours), median(calls), median(near_calls), median(gain));
  std::fflush(stdout);
}

/// Spot and head in four sizes, and the draws of the corpus.
std::vector<MeshSet> meshes() {
  std::vector<MeshSet> all;
  for (const char* model : {"static/spot.glb", "static/head.glb"}) {
    for (MeshSet& size : subdivisions(model, {0, 1, 2, 3})) all.push_back(std::move(size));
  }
  const std::size_t models = all.size();
  for (const TestMesh& mesh : corpus().meshes) {
    if (mesh.indices.size() / 3 < least_triangles) continue;
    all.push_back({fmt::format("corpus, draw {}", all.size() - models + 1), {mesh}});
  }
  return all;
}

}  // namespace
}  // namespace foredraw::bench

int main() {
  using namespace foredraw::bench;
  fmt::print(
      "| mesh | triangles | peer's call, ms | 162 views, ms | in calls | from 3 radii, in calls | gain of a second "
      "thread |\n"
      "|---|---:|---:|---:|---:|---:|---:|\n");
  for (const MeshSet& set : meshes()) {
    if (set.triangles() <= most_triangles) contest(set.name, set.meshes[0]);
  }
}
