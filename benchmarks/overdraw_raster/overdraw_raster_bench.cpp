// Counting overdraw by drawing against meshopt_analyzeOverdraw, which draws 6 views into 256 x 256 pixels and culls
// back faces: our 162 such views in calls of the peer. Every round does all of it one behind the other, so that a noisy
// moment hits all alike; the median of seven rounds' ratios counts.

#include "bench_meshes.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/viewing/view_set.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
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

struct Time {
  double passed, of_processor;  // milliseconds
};

Time time_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t first = std::clock();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count(),
          1e3 * static_cast<double>(std::clock() - first) / CLOCKS_PER_SEC};
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
  Figures peer, ours, calls, near_calls, gain, more;
  for (std::size_t i = 0; i < rounds; ++i) {
    OverdrawCounts alone, together;
    const Time of_peer = time_of([&] {
      meshopt_analyzeOverdraw(mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x, mesh.positions.size(),
                              sizeof(glm::vec3));
    });
    const Time of_one = time_of([&] { alone = overdraw_raster({&part, 1}, views, one); });
    const Time of_two = time_of([&] { together = overdraw_raster({&part, 1}, views, two); });
    const Time near = time_of([&] { overdraw_raster({&part, 1}, near_views, one); });
    if (alone != together) throw std::logic_error("two threads and one thread give different counts");
    peer[i] = of_peer.of_processor;
    ours[i] = of_one.of_processor;
    calls[i] = of_one.of_processor / of_peer.of_processor;
    near_calls[i] = near.of_processor / of_peer.of_processor;
    gain[i] = of_one.passed / of_two.passed;
    more[i] = of_two.of_processor / of_one.of_processor;
  }
  fmt::print("| {} | {} | {:.2f} | {:.1f} | **{:.1f}** | {:.1f} | {:.2f} | {:.2f} |\n", name, mesh.indices.size() / 3,
             median(peer), median(ours), median(calls), median(near_calls), median(gain), median(more));
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
      "| mesh | triangles | peer's call, ms | 162 views, ms | in calls | from 3 radii, in calls | two threads: faster "
      "| "
      "processor time |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const MeshSet& set : meshes()) {
    if (set.triangles() <= most_triangles) contest(set.name, set.meshes[0]);
  }
}
