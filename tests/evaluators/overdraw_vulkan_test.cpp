#include "../../evaluators/overdraw_vulkan/overdraw_vulkan.h"
#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/meshes.h"
#include "support/painter.h"

#include <gtest/gtest.h>
#include <cstdio>
#include <chrono>

namespace foredraw {
namespace {
using testing::part_of;
TEST(OverdrawVulkan, first) {
  std::vector<std::string> complaints;
  {
  VulkanPainter painter({.complaints = &complaints});
  std::puts(painter.device().name().c_str());
  std::printf("subpixel %u depth %d stats %d\n", painter.device().limits().subPixelPrecisionBits, painter.device().depth_format(), painter.device().counts_vertices());
  ViewSet set; set.views = "fibonacci"; set.count = 100; set.size = 256;
  for (double distance : {0.0, 1.01, 1.5, 3.0, 1e6}) {
  if (distance > 0) set.distance = distance;
  const Views views = make_views(set);
  for (const auto& mesh : {testing::shuffled(testing::torus(100, 50), 1), testing::sphere(64, 32), testing::tangle(1, false), testing::tangle(2, true)}) {
   for (const bool culls : {true, false}) {
    const RasterPart part = part_of(mesh, culls);
    OverdrawCount g, q, a;
    auto t0 = std::chrono::steady_clock::now();
    { const auto all = overdraw_vulkan(painter, {&part, 1}, views); for (auto c : all[0]) g += c; }
    auto t1 = std::chrono::steady_clock::now();
    { const auto all = overdraw_vulkan(painter, {&part, 1}, views, CountMethod::atomics); for (auto c : all[0]) a += c; }
    auto t2 = std::chrono::steady_clock::now();
    { const auto all = overdraw_raster({&part, 1}, views); for (auto c : all[0]) q += c; }
    auto t3 = std::chrono::steady_clock::now();
    EXPECT_EQ(g, a);
    auto ms = [](auto d) { return std::chrono::duration<double, std::milli>(d).count(); };
    std::printf("d %g tris %zu cull %d: raster %lu %lu %lu  vulkan %+ld %+ld %+ld  ratio %.6f %+.2e  times %.0f %.0f %.0f ms\n", distance, mesh.indices.size() / 3, culls, q.shaded, q.visible, q.ties,
      long(g.shaded - q.shaded), long(g.visible - q.visible), long(g.ties - q.ties), double(q.shaded)/q.visible, (double(g.shaded)/g.visible)/(double(q.shaded)/q.visible)-1, ms(t1-t0), ms(t2-t1), ms(t3-t2));
    auto inv = vertex_shader_invocations(painter, {&part, 1});
    if (distance == 0) std::printf("   invocations %lu of %zu vertices\n", inv ? (*inv)[0] : 0, mesh.positions.size());
   }
  }
  }
  const auto mesh = testing::torus(100, 50);
  const RasterPart part = part_of(mesh);
  auto t = gpu_time(painter, {&part, 1}, make_views(set));
  if (t) std::printf("time light %f heavy %f\n", t->light, t->heavy);
  }
  for (auto& c : complaints) std::puts(c.c_str());
  EXPECT_TRUE(complaints.empty());
}
}
}
