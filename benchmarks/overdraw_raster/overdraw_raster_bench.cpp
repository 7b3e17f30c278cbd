#include "bench_meshes.h"
#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <fmt/format.h>
#include <meshoptimizer.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
namespace foredraw::bench {
namespace {
constexpr std::size_t rounds = 7;
double cpu(const std::function<void()>& w) {
  timespec a, b; clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a); w(); clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
  return (b.tv_sec - a.tv_sec) * 1e3 + (b.tv_nsec - a.tv_nsec) * 1e-6;
}
}
}
int main(int argc, char** argv) {
  using namespace foredraw; using namespace foredraw::bench;
  double distance = argc > 1 ? atof(argv[1]) : 0;
  std::vector<MeshSet> all;
  for (const char* model : {"static/spot.glb", "static/head.glb"})
    for (MeshSet& s : subdivisions(model, {0, 1, 2, 3})) all.push_back(std::move(s));
  for (const TestMesh& mesh : corpus().meshes) if (mesh.indices.size() / 3 >= 6000) all.push_back({fmt::format("draw"), {mesh}});
  ViewSet set; set.views = "icosphere"; set.count = 162; if (distance > 0) set.distance = distance;
  const Views views = make_views(set);
  for (auto& s : all) { if (argc > 2 && s.name.find(argv[2]) == std::string::npos) continue; if (argc > 3 && s.triangles() != (std::size_t)atoi(argv[3])) continue;
    auto& m = s.meshes[0];
    if (m.indices.size() / 3 > 1200000) continue;
    RasterPart part{m.positions, m.indices, true};
    std::array<double, rounds> ours, peer, ratio;
    OverdrawCount sum;
    for (std::size_t i = 0; i < rounds; ++i) {
      peer[i] = cpu([&] { meshopt_analyzeOverdraw(m.indices.data(), m.indices.size(), &m.positions[0].x, m.positions.size(), 12); });
      ours[i] = cpu([&] { OverdrawCounts c = overdraw_raster({&part, 1}, views); sum = {}; for (auto& x : c[0]) sum += x; });
      ratio[i] = ours[i] / peer[i];
    }
    std::ranges::sort(ours); std::ranges::sort(peer); std::ranges::sort(ratio);
    fmt::print("{:12} {:8} peer {:8.2f} ms {:5.1f} ns/tv  ours {:8.1f} ms {:6.2f} ns/tv {:6.2f} ns/frag  ratio {:5.1f}  count {} {} {}\n", s.name, m.indices.size() / 3, peer[3], peer[3] * 1e6 / 6 / (m.indices.size() / 3), ours[3],
               ours[3] * 1e6 / 162 / (m.indices.size() / 3), ours[3] * 1e6 / sum.shaded, ratio[3], sum.shaded, sum.visible, sum.ties);
    std::fflush(stdout);
  }
}
