// Techniques that ask for overdraw get what drawing would count.
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/modules/draw_overdraw.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/technique/registry.h>
#include <foredraw/viewing/view_set.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

namespace foredraw::testing::overdraw_test {
namespace {

OverdrawCount drawn(const OverdrawService& service, const Draw& draw, Run& run) {
  const Scene scene = scene_of({draw});
  OverdrawCount sum;
  const OverdrawCounts counts = service.count(scene, {"alone", {{0, {}}}}, run.views, run);
  for (const OverdrawCount& count : counts.front()) sum += count;
  return sum;
}

TEST(DrawOverdraw, CountsAnyOrderAsDrawingItDoes) {
  Registry registry;
  add_built_in_plugins(registry);
  const auto service = registry.find("overdraw-raster")->overdraw_service({});
  RunFixture fixture;
  fixture.views = make_views({.count = 12, .size = 64});
  fixture.run.overdraw = service.get();
  const Scene scene = scene_of({draw_of(grid(2, 2), "other"), draw_of(shuffled(torus(12, 9), 3), "torus")});
  DrawOverdraw overdraw({scene, 1}, fixture.run);
  const Draw& torus = scene.draws[1];
  EXPECT_EQ(overdraw.count(nullptr), drawn(*service, torus, fixture.run));
  std::vector<std::uint32_t> order(overdraw.triangle_count());
  std::iota(order.rbegin(), order.rend(), 0u);
  const OverdrawCount backwards = overdraw.count(order.data());
  EXPECT_EQ(backwards, drawn(*service, with_triangle_order(torus, order), fixture.run));
  EXPECT_NE(backwards.shaded, overdraw.count(nullptr).shaded);
  EXPECT_EQ(backwards.visible, overdraw.count(nullptr).visible);
}

/// A service that can not capture, and draws every order.
class DrawsAlone final : public OverdrawService {
 public:
  explicit DrawsAlone(const OverdrawService& whole) : OverdrawService(whole.faces()), whole_(whole) {}
  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run& run) const override {
    return whole_.draw(parts, views, run);
  }

 private:
  const OverdrawService& whole_;
};

TEST(DrawOverdraw, NeedsNoLayers) {
  Registry registry;
  add_built_in_plugins(registry);
  const auto service = registry.find("overdraw-raster")->overdraw_service({});
  const DrawsAlone drawing(*service);
  RunFixture fixture;
  fixture.views = make_views({.count = 12, .size = 64});
  const Scene scene = scene_of({draw_of(shuffled(torus(12, 9), 3), "torus")});
  fixture.run.overdraw = service.get();
  DrawOverdraw captured({scene, 0}, fixture.run);
  std::vector<std::uint32_t> order(captured.triangle_count());
  std::iota(order.rbegin(), order.rend(), 0u);
  const OverdrawCount with_layers = captured.count(order.data());
  fixture.run.overdraw = &drawing;
  EXPECT_EQ(DrawOverdraw({scene, 0}, fixture.run).count(order.data()), with_layers);
}

class AskingModules : public InFolder {};

TEST_F(AskingModules, GiveTheSameBytesApartAndInside) {
  const auto written = [&](const std::string& arguments) {
    const Ended ended =
        run_program(folder_, "optimize '" FOREDRAW_SOURCE_DIR
                             "/benchmarks/corpus/animated/kaykit_knight.glb' -o out.glb -p 'acme-axes, "
                             "vertex-fetch' --with vertex-cache --module '" FOREDRAW_MODULES_FOLDER "/axes.so' " +
                                 arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return content(folder_ / "out.glb");
  };
  const std::string apart = written("");
  EXPECT_FALSE(apart.empty());
  EXPECT_TRUE(written("--threads 1") == apart);
  EXPECT_TRUE(written("--modules inside") == apart);
  EXPECT_TRUE(written("--modules inside --threads 7") == apart);
}

}  // namespace
}  // namespace foredraw::testing::overdraw_test
