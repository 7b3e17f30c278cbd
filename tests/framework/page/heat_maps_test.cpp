#include <foredraw/page/heat_maps.h>

#include "support/edit_product.h"
#include "support/meshes.h"

#include <foredraw/io/image/images.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace foredraw::heat_maps_test {
namespace {

using testing::TestMesh;

/// A square that faces +Z.
TestMesh quad(float z) { return {{{-1, -1, z}, {1, -1, z}, {-1, 1, z}, {1, 1, z}}, {0, 1, 2, 2, 1, 3}}; }

/// Three squares back to front, or the other way round.
Scene stack(bool back_to_front) {
  const float first = back_to_front ? 0 : 1;
  Scene scene = testing::scene_of(testing::joined(quad(first), testing::joined(quad(0.5f), quad(1 - first))));
  scene.meshes[0].name = "Stück/1";
  return scene;
}

OverdrawOptions from_the_front() {
  OverdrawOptions options;
  options.views = "axes";
  options.size = 32;
  return options;
}

std::vector<OutputFile> drawn(const Scene& before, const Scene* after, const std::string& which) {
  Analyses analyses;
  return heat_maps(before, after, from_the_front(), which, "maps", Executor(2), analyses);
}

std::set<std::array<int, 3>> colours_in(const OutputFile& file, std::size_t first_column, std::size_t last_column) {
  Diagnostics diagnostics;
  const auto texels = decode_image(file.bytes, {}, diagnostics);
  EXPECT_TRUE(texels);
  std::set<std::array<int, 3>> colours;
  if (!texels) return colours;
  // Where the map is, without what is written above and below it.
  for (std::size_t row = 60; row < 500; ++row) {
    for (std::size_t column = first_column; column < last_column; ++column) {
      const std::byte* texel = &texels->bytes[3 * (row * texels->facts.width + column)];
      colours.insert({std::to_integer<int>(texel[0]), std::to_integer<int>(texel[1]), std::to_integer<int>(texel[2])});
    }
  }
  return colours;
}

TEST(HeatMaps, shows_the_worst_view_of_each_subject) {
  const auto maps = drawn(stack(true), nullptr, "worst");
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps.front().path.generic_string(), "maps/000-St__ck_1-view004.png");  // of +X, -X, +Y, -Y, +Z, -Z
  const auto facts = image_facts(maps.front().bytes);
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->width, 512u + 2 * 12);
  EXPECT_EQ(facts->channels, 3);
  EXPECT_EQ(colours_in(maps.front(), 12, 524), (std::set<std::array<int, 3>>{{18, 18, 22}, {53, 183, 121}}));
}

TEST(HeatMaps, shows_before_and_after_side_by_side) {
  const Scene after = stack(false);
  const auto maps = drawn(stack(true), &after, "4");
  ASSERT_EQ(maps.size(), 1u);
  const std::array<int, 3> background = {18, 18, 22};
  EXPECT_EQ(colours_in(maps.front(), 12, 524), (std::set<std::array<int, 3>>{background, {53, 183, 121}}));
  EXPECT_EQ(colours_in(maps.front(), 536, 1048), (std::set<std::array<int, 3>>{background, {52, 62, 110}}));
}

TEST(HeatMaps, shows_the_worst_pose_of_each_view) {
  // Two squares that face +Z. A joint slides the one that is drawn first from beside the other to behind it.
  Scene scene = testing::scene_of({testing::draw_of(quad(0)), testing::draw_of(quad(1))});
  Node root;
  root.children = {0, 1};
  scene.nodes.push_back(root);
  scene.nodes[0].transform.translation = {3, 0, 0};
  scene.skins.resize(1);
  scene.skins[0].joints = {2};
  scene.animations.push_back({"Slide",
                              {{0, AnimatedPath::translation, Interpolation::linear, Shared<float>({0, 1, 2}),
                                Shared<float>({3, 0, 0, 0, 0, 0, 1, 0, 0})}}});
  OverdrawOptions options = from_the_front();
  options.poses = "all";
  Analyses analyses;
  for (const std::string which : {"worst", "4", "all"}) {
    const auto maps = heat_maps(scene, nullptr, options, which, "maps", Executor(2), analyses);
    ASSERT_EQ(maps.size(), 1u);
    EXPECT_TRUE(maps[0].path.generic_string().ends_with("-Slide_1-view004.png")) << maps[0].path;
    EXPECT_TRUE(colours_in(maps[0], 12, 524).contains({42, 120, 142}));  // shaded twice
  }
}

TEST(HeatMaps, shows_the_order_that_the_table_gives) {
  Scene scene = stack(true);
  std::vector<IndexStream>& orders = scene.draws[0].levels[0].orders;
  orders.push_back(with_triangle_order(orders[0], std::vector<std::uint32_t>{4, 5, 2, 3, 0, 1}));
  testing::edit<DrawOrders>(scene)->tables = {{{0}, {}, 1, 1, {1}}};
  const auto maps = drawn(stack(true), &scene, "4");
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_TRUE(colours_in(maps.front(), 12, 524).contains({53, 183, 121}));
  EXPECT_FALSE(colours_in(maps.front(), 536, 1048).contains({53, 183, 121}));
  EXPECT_TRUE(colours_in(drawn(scene, nullptr, "4").front(), 12, 524).contains({52, 62, 110}));
}

TEST(HeatMaps, leaves_out_views_that_show_nothing) {
  EXPECT_EQ(drawn(stack(true), nullptr, "all").size(), 1u);  // the others see edges, or culled backs
  EXPECT_TRUE(drawn(stack(true), nullptr, "5").empty());
  EXPECT_TRUE(drawn(Scene(), nullptr, "worst").empty());
}

TEST(HeatMaps, a_view_that_there_is_not_is_refused) {
  for (const std::string which : {"worst", "all", "0", "5"}) {
    Diagnostics diagnostics;
    EXPECT_TRUE(are_views(which, from_the_front(), diagnostics)) << which;
    EXPECT_TRUE(diagnostics.all().empty());
  }
  for (const std::string which : {"6", "-1", "best", "", "1x"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(are_views(which, from_the_front(), diagnostics)) << which;
    EXPECT_TRUE(diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace foredraw::heat_maps_test
