// Overdraw of subjects that have several orders and a table.

#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/edit_product.h"
#include "support/overdraw.h"

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace foredraw::overdraw_raster_orders_test {
namespace {

using Numbers = std::vector<std::uint32_t>;
using testing::TestMesh;

constexpr std::uint32_t floors = 5;

/// Squares one above the other, from the highest to the lowest. Drawn so, nothing is shaded twice from above, and all
/// of them from below.
Draw tower() {
  TestMesh mesh;
  for (std::uint32_t floor = 0; floor < floors; ++floor) {
    TestMesh square = testing::quad(0);
    for (glm::vec3& p : square.positions) p = {p.x, 0.1f * static_cast<float>(floors - floor), -p.y};
    mesh = testing::joined(mesh, square);
  }
  Draw draw = testing::draw_of(mesh, "tower");
  Numbers backwards(2 * floors);
  std::iota(backwards.rbegin(), backwards.rend(), 0u);
  draw.levels[0].orders.push_back(with_triangle_order(draw.levels[0].orders[0], backwards));
  return draw;
}

Scene scene_with(std::vector<std::uint8_t> order, std::uint32_t theta_steps) {
  Scene scene = testing::scene_of({tower()});
  scene.materials.emplace_back().double_sided = true;
  scene.draws[0].material = 0;
  testing::edit<DrawOrders>(scene)->tables.push_back({{0}, {}, theta_steps, 1, std::move(order)});
  return scene;
}

Findings evaluate(const Scene& scene, Settings settings = {}) {
  settings.insert({{"views", std::string("axes")}, {"size", std::int64_t{32}}});
  return testing::evaluate(overdraw_raster_plugin(), scene, settings);
}

double ratio(const Findings& findings) {
  const Measured& ratio = *testing::find(findings, "ratio", {});
  return ratio.numerator / *ratio.denominator;
}

TEST(OverdrawOrders, each_view_is_drawn_in_the_order_of_the_table) {
  EXPECT_EQ(ratio(evaluate(scene_with({0, 1}, 2))), 1);
  EXPECT_EQ(ratio(evaluate(scene_with({1, 0}, 2))), floors) << "of the two views that show anything the worst";
  EXPECT_EQ(ratio(evaluate(scene_with({0, 0}, 2))), (1.0 + floors) / 2);
  EXPECT_EQ(ratio(evaluate(scene_with({1}, 1))), (1.0 + floors) / 2);
}

TEST(OverdrawOrders, figures_are_those_of_the_orders_drawn_alone) {
  // Slanted views, so that both orders shade something twice.
  const Settings views = {{"views", std::string("random")}, {"count", std::int64_t{40}}};
  const Findings both = evaluate(scene_with({0, 1, 0, 1}, 4), views);
  Scene alone = scene_with({0}, 1);
  double shaded = 0;
  ViewSet set;
  set.views = "random";
  set.count = 40;
  set.size = 32;
  const auto positions = decode_vec3(*alone.draws[0].levels[0].vertices->find("POSITION"));
  for (const View& view : make_views(set).views) {
    const auto cell = static_cast<std::size_t>(std::acos(view.direction.y) / 3.14159265358979 * 4);
    const RasterPart part{positions, alone.draws[0].levels[0].orders[cell % 2].indices.view(), false};
    shaded += static_cast<double>(overdraw_raster(std::span(&part, 1), {{view}, 32})[0][0].shaded);
  }
  EXPECT_EQ(testing::find(both, "ratio", {})->numerator, shaded);
  EXPECT_EQ(testing::find(both, "ratio", {})->denominator,
            testing::find(evaluate(alone, views), "ratio", {})->denominator);
}

TEST(OverdrawOrders, details_tell_the_same_overdraw) {
  for (const std::vector<std::uint8_t>& order : {std::vector<std::uint8_t>{0, 1}, {1, 0}, {0, 0}}) {
    const Findings findings = evaluate(scene_with(order, 2), {{"details", true}});
    double shaded = 0;
    for (const Measured& measured : findings.measured) {
      if (!measured.metric.starts_with("shaded-times.")) continue;
      shaded += measured.numerator * std::stod(measured.metric.substr(13));
    }
    EXPECT_EQ(shaded, testing::find(findings, "ratio", {})->numerator);
  }
}

/// Three squares side by side in depth, each a draw, and a table with a sequence for each of two orders.
Scene squares_in_sequence() {
  std::vector<Draw> draws;
  for (const float height : {0.1f, 0.3f, 0.2f}) {
    TestMesh square = testing::quad(0);
    for (glm::vec3& p : square.positions) p = {p.x + height, height, -p.y};
    Draw draw = testing::draw_of(square, "square");
    draw.levels[0].orders.push_back(draw.levels[0].orders[0]);
    draw.material = static_cast<MaterialId>(draws.size() == 0 ? 1 : 0);
    draws.push_back(std::move(draw));
  }
  Scene scene = testing::scene_of(std::move(draws));
  scene.materials.resize(2);
  for (Material& material : scene.materials) material.double_sided = true;
  Node root;
  root.children = {0, 1, 2};
  scene.nodes.push_back(root);
  scene.skins.resize(1);
  scene.skins[0].joints = {3};
  OrderTable table{{0, 1, 2}, {}, 2, 1, {0, 1}};
  table.parts = subjects_of(scene)[0].parts;
  table.sequences = {0, 1, 2, 1, 2, 0};
  testing::edit<DrawOrders>(scene)->tables.push_back(table);
  return scene;
}

/// Drawn view by view, the parts one behind the other: `sequence_of(view)` says how.
template <class SequenceOf>
double shaded_of(const Scene& scene, const Views& views, SequenceOf sequence_of) {
  const Subject subject = subjects_of(scene)[0];
  Analyses analyses;
  const SubjectGeometry posed = subject_geometry(scene, subject, Faces::material, posed_nodes(scene), analyses);
  double shaded = 0;
  for (const View& view : views.views) {
    std::vector<RasterPart> drawn;
    for (const std::size_t part : sequence_of(view)) drawn.push_back(posed.parts[part]);
    for (const auto& of_part : overdraw_raster(drawn, {{view}, views.size})) {
      shaded += static_cast<double>(of_part[0].shaded);
    }
  }
  return shaded;
}

TEST(OverdrawOrders, parts_are_drawn_in_the_sequence_that_is_asked_for) {
  using Sequence = std::vector<std::size_t>;
  const Scene scene = squares_in_sequence();
  ViewSet set;
  set.views = "random";
  set.count = 40;
  set.size = 32;
  const Views views = make_views(set);
  const auto measured = [&](const std::string& sequence) {
    return testing::find(
               evaluate(scene, {{"views", std::string("random")}, {"count", std::int64_t{40}}, {"sequence", sequence}}),
               "ratio", {})
        ->numerator;
  };
  const double by_table = shaded_of(scene, views, [](const View& view) {
    return view.direction.y > 0 ? Sequence{0, 1, 2} : Sequence{1, 2, 0};
  });
  const double as_in_file = shaded_of(scene, views, [](const View&) { return Sequence{0, 1, 2}; });
  const double by_material = shaded_of(scene, views, [](const View&) { return Sequence{1, 2, 0}; });
  EXPECT_EQ(measured("table"), by_table);
  EXPECT_EQ(measured("file"), as_in_file);
  EXPECT_EQ(measured("material"), by_material);
  EXPECT_NE(by_table, as_in_file);
  EXPECT_NE(by_table, by_material);
  EXPECT_NE(as_in_file, by_material);
}

TEST(OverdrawOrders, details_and_draws_are_told_by_their_numbers_in_any_sequence) {
  const Scene scene = squares_in_sequence();
  for (const char* sequence : {"table", "file", "material"}) {
    const Findings findings = evaluate(scene, {{"details", true}, {"sequence", std::string(sequence)}});
    double of_draws = 0, of_pixels = 0;
    for (DrawId draw = 0; draw < 3; ++draw) of_draws += testing::find(findings, "ratio", draw)->numerator;
    for (const Measured& measured : findings.measured) {
      if (!measured.metric.starts_with("shaded-times.")) continue;
      of_pixels += measured.numerator * std::stod(measured.metric.substr(13));
    }
    EXPECT_EQ(of_draws, testing::find(findings, "ratio", {})->numerator) << sequence;
    EXPECT_EQ(of_pixels, of_draws) << sequence;
  }
  // From above and below nothing is seen of the middle square but where the others leave it.
  const auto shaded = [&](const char* sequence, DrawId draw) {
    return testing::find(evaluate(scene, {{"sequence", std::string(sequence)}}), "ratio", draw)->numerator;
  };
  EXPECT_GT(shaded("file", 0), shaded("material", 0)) << "drawn first, and drawn last";
}

TEST(OverdrawOrders, poses_draw_what_their_keyframe_says) {
  Scene scene = scene_with({}, 1);
  testing::edit<DrawOrders>(scene)->tables[0].theta_steps = 2;
  testing::edit<DrawOrders>(scene)->tables[0].clips = {{"Good", {0}}, {"Bad", {0, 1}}};
  testing::edit<DrawOrders>(scene)->tables[0].order = {0, 1, 1, 0, 0, 1};
  // A joint above the tower makes it a character, which clips of one and two keys do not bend.
  Node root;
  root.children = {0};
  scene.nodes.push_back(root);
  scene.skins.resize(1);
  scene.skins[0].joints = {1};
  const auto still = [](std::vector<float> times) {
    std::vector<float> values(3 * times.size(), 1);
    return AnimationChannel{0, AnimatedPath::scale, Interpolation::step, Shared<float>(std::move(times)),
                            Shared<float>(std::move(values))};
  };
  scene.animations = {{"Bad", {still({0, 1})}}, {"Good", {still({0})}}};
  const Findings findings = evaluate(scene, {{"poses", std::string("all")}});
  const auto in_pose = [&](const std::string& pose) {
    const Measured& ratio = *testing::find(findings, "poses." + pose + ".ratio", {});
    return ratio.numerator / *ratio.denominator;
  };
  EXPECT_EQ(in_pose("Bad@0"), floors);
  EXPECT_EQ(in_pose("Bad@1"), 1);
  EXPECT_EQ(in_pose("Good@0"), 1);
}

}  // namespace
}  // namespace foredraw::overdraw_raster_orders_test
