#include <foredraw/pipeline/eligible.h>

#include "support/meshes.h"
#include "support/test_plugins.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>

#include <gtest/gtest.h>

namespace foredraw::eligible_test {
namespace {

struct Seals {
  static constexpr std::string_view product = "seals";
  std::vector<DrawId> draws;
  friend bool operator==(const Seals&, const Seals&) = default;
};

/// Of a product that holds draws and does nothing else.
class SealsRow final : public ProductRow {
 public:
  SealsRow() : ProductRow({.name = "seals", .title = "seals", .extension = "FOREDRAW_seals"}) {}
  std::string read(ExtensionReader&, Scene&) const override { return {}; }
  void write(const Scene&, ExtensionWriter&) const override {}
  std::vector<DrawId> held(const Scene& scene) const override { return scene.products.find<Seals>()->draws; }
  ProductText told(const Scene&) const override { return {}; }
};

TEST(Eligible, DrawsThatAProductHoldsAreLeftAloneByItsName) {
  Registry registry;
  Plugin plugin = testing::reverse_draw();
  plugin.products = {std::make_shared<SealsRow>()};
  registry.add(std::move(plugin));
  Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "A"), testing::draw_of(testing::grid(1, 1), "B")});
  scene.products.set(Seals{{1}});
  mark_held_draws(scene, registry.products());
  EXPECT_EQ(holders_of_draws(scene, registry.products()), (Holders{{1, "seals"}}));

  const std::string why =
      "the seals refer to its triangles and vertices by number: put this stage before the one that makes them, or "
      "first "
      "write the file with --products none";
  Diagnostics diagnostics;
  const auto planned = plan(*parse_line("reverse-draw", diagnostics), registry, scene, diagnostics);
  ASSERT_EQ(planned->stages[0].skips.size(), 1u);
  EXPECT_EQ(planned->stages[0].skips[0].code, "held");
  EXPECT_EQ(planned->stages[0].skips[0].reason, why);
  Analyses analyses;
  const Result result = optimize(*planned, scene, {Executor(2), analyses});
  ASSERT_EQ(result.report.stages[0].skipped.size(), 1u);
  EXPECT_EQ(result.report.stages[0].skipped[0].reason, why);
  EXPECT_EQ(result.report.stages[0].skipped[0].about, std::vector<std::string>{"B"});
}

}  // namespace
}  // namespace foredraw::eligible_test
