// The stage: what it puts first, what it leaves out and why, and what later stages make of it.
#include "plugins/processors/second_depth/second_depth.h"
#include "plugins/processors/second_depth/second_depth_product.h"

#include "hidden_shapes.h"
#include "support/closed_bodies.h"
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/scene/reorder.h>
#include <foredraw/shells/second_depth.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

namespace foredraw::second_depth_stage_test {
namespace {

using testing::box;
using ::testing::HasSubstr;
using testing::joined;
using testing::TestMesh;

std::uint32_t closed_of(const Scene& scene, DrawId draw = 0) {
  const auto* product = scene.products.find<SecondDepth>();
  return product == nullptr ? 0 : product->triangles_of(draw);
}

std::string notes_of(const Result& result, std::size_t stage = 0) {
  std::string text;
  for (const NoteRecord& note : result.report.stages.at(stage).notes) text += note.about + ": " + note.message + '\n';
  return text;
}

/// A ball and a sheet in one draw, in random order.
TestMesh ball_and_sheet() {
  return testing::shuffled(joined(testing::closed_sphere(24, 12), testing::grid(10, 10)), 5);
}

using Corners = std::array<float, 9>;

std::multiset<Corners> first_triangles(const Draw& draw, const IndexStream& stream, std::size_t count) {
  const auto positions = decode_vec3(*draw.full().vertices->find("POSITION"));
  std::multiset<Corners> triangles;
  for (std::size_t t = 0; t < count; ++t) {
    Corners corners;
    for (std::size_t c = 0; c < 9; ++c) {
      corners[c] = positions[stream.indices.view()[3 * t + c / 3]][static_cast<int>(c % 3)];
    }
    triangles.insert(corners);
  }
  return triangles;
}

std::multiset<Corners> first_triangles(const Scene& scene) {
  return first_triangles(scene.draws[0], scene.draws[0].full().stream(), closed_of(scene));
}

TEST(SecondDepth, PutsClosedShellsFirstInTheSequenceThatTheyHad) {
  const Scene scene = testing::scene_of(ball_and_sheet());
  const Result result = testing::run("second-depth", scene);
  ASSERT_FALSE(result.failed);
  const std::size_t triangles = testing::closed_sphere(24, 12).indices.size() / 3;
  EXPECT_EQ(closed_of(result.scene), triangles);
  EXPECT_EQ(first_triangles(result.scene),
            first_triangles(testing::scene_of(testing::closed_sphere(24, 12)).draws[0],
                            testing::scene_of(testing::closed_sphere(24, 12)).draws[0].full().stream(), triangles));
  const auto origin = result.scene.draws[0].full().stream().triangle_origin.view();
  EXPECT_TRUE(std::ranges::is_sorted(origin.first(triangles)));
  EXPECT_TRUE(std::ranges::is_sorted(origin.subspan(triangles)));
  EXPECT_THAT(notes_of(result), HasSubstr("200 triangles"));
  EXPECT_THAT(notes_of(result), HasSubstr("are open"));
  // Done again it is the same.
  const Result again = testing::run("second-depth", result.scene);
  EXPECT_EQ(closed_of(again.scene), triangles);
  EXPECT_TRUE(std::ranges::equal(again.scene.draws[0].full().stream().indices.view(),
                                 result.scene.draws[0].full().stream().indices.view()));
}

TEST(SecondDepth, StaysUnderStagesThatOrderRenumberAndWeld) {
  const Scene first = testing::run("second-depth", testing::scene_of(ball_and_sheet())).scene;
  const auto wanted = first_triangles(first);
  for (const char* stages :
       {"tipsify", "lookahead", "forsyth", "vertex-fetch", "weld, tipsify, linear-clusters, dot-rule, vertex-fetch",
        "occlusion-order", "occlusion-order(k=2)"}) {
    const Result result = testing::run(stages, first);
    ASSERT_FALSE(result.failed) << stages;
    ASSERT_EQ(closed_of(result.scene), closed_of(first)) << stages;
    EXPECT_EQ(first_triangles(result.scene), wanted) << stages;
    for (const IndexStream& order : result.scene.draws[0].full().orders) {
      EXPECT_EQ(first_triangles(result.scene.draws[0], order, closed_of(first)), wanted) << stages;
    }
  }
}

TEST(SecondDepth, IsLeftOutWhereAStageOpensAShellOrMakesOthers) {
  const Scene before =
      testing::run("second-depth", testing::scene_of({testing::draw_of(testing::closed_sphere(24, 12), "cut"),
                                                      testing::draw_of(testing::closed_sphere(24, 12), "whole")}))
          .scene;
  // As a stage does that removes what nobody sees: the first ten triangles go.
  Scene after = before;
  IndexStream& stream = after.draws[0].full().stream();
  const std::vector<std::uint32_t> indices(stream.indices.view().begin() + 30, stream.indices.view().end());
  std::vector<std::uint32_t> origin;
  for (std::uint32_t t = 10; t < stream.triangle_count(); ++t) {
    origin.push_back(stream.triangle_origin.empty() ? t : stream.triangle_origin.view()[t]);
  }
  stream.indices = Shared<std::uint32_t>(indices);
  stream.triangle_origin = Shared<std::uint32_t>(origin);
  const auto told = second_depth_product()->follow(before, after);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0], HasSubstr("the first triangles of cut are not closed shells"));
  EXPECT_EQ(closed_of(after, 0), 0u);
  EXPECT_EQ(closed_of(after, 1), closed_of(before, 1));

  const Result coarser = testing::run("weld, quadric-collapse, simplify(ratio=0.5)", before);
  ASSERT_FALSE(coarser.failed);
  ASSERT_LT(coarser.scene.draws[1].full().stream().triangle_count(), 400u);
  EXPECT_EQ(closed_of(coarser.scene, 1), 0u);
}

/// Triangles that a stage takes out of the range, to stand last, as wires do.
TEST(SecondDepth, ShrinksWhereWholeShellsLeaveItAndGoesWhereOneIsTorn) {
  const TestMesh mesh = joined(joined(box(), box(1, {9, 0, 0})), testing::grid(2, 1));
  const Scene before = testing::run("second-depth", testing::scene_of(mesh)).scene;
  ASSERT_EQ(closed_of(before), 24u);
  const auto put_last = [&](std::uint32_t count) {
    IndexOrder order;
    for (std::uint32_t t = count; t < 28; ++t) order.push_back(t);
    for (std::uint32_t t = 0; t < count; ++t) order.push_back(t);
    Scene after = before;
    after.draws[0] = with_triangle_order(after.draws[0], order);
    return after;
  };
  Scene whole = put_last(12);
  EXPECT_TRUE(second_depth_product()->follow(before, whole).empty());
  EXPECT_EQ(closed_of(whole), 12u);
  Scene torn = put_last(4);
  const auto told = second_depth_product()->follow(before, torn);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0], HasSubstr("are not closed shells; run second-depth again"));
  EXPECT_EQ(closed_of(torn), 0u);
}

Material material(AlphaMode mode, bool double_sided = false) {
  Material made;
  made.alpha_mode = mode;
  made.double_sided = double_sided;
  return made;
}

TEST(SecondDepth, LeavesOutWhatShowsItsBacksOrWhatLiesBehind) {
  Scene scene =
      testing::one_mesh({box(), box(1, {5, 0, 0}), box(1, {10, 0, 0}), box(1, {15, 0, 0}), box(1, {20, 0, 0})});
  scene.materials = {material(AlphaMode::opaque), material(AlphaMode::mask), material(AlphaMode::blend),
                     material(AlphaMode::opaque, true), material(AlphaMode::opaque)};
  scene.materials[4].keeps_sides = true;
  for (DrawId id = 0; id < 5; ++id) scene.draws[id].material = id;
  const Result result = testing::run("second-depth", scene);
  ASSERT_FALSE(result.failed);
  EXPECT_EQ(closed_of(result.scene, 0), 12u);
  for (DrawId id = 1; id < 5; ++id) EXPECT_EQ(closed_of(result.scene, id), 0u) << id;
  const std::string notes = notes_of(result);
  for (const char* why : {"is masked", "is blended", "is double-sided", "light passes through"}) {
    EXPECT_THAT(notes, HasSubstr(why));
  }
}

TEST(SecondDepth, LeavesOutMorphedDraws) {
  Scene scene = testing::scene_of(box());
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  vertices->morph_targets = {vertices->base};
  scene.draws[0].full().vertices = vertices;
  const Result result = testing::run("second-depth", scene);
  EXPECT_EQ(closed_of(result.scene), 0u);
  EXPECT_THAT(notes_of(result), HasSubstr("morph targets"));
}

/// A shell of two materials: its halves are draws of one mesh.
TEST(SecondDepth, ClosesShellsOverTheDrawsOfAMesh) {
  TestMesh lower = box(), upper = box();
  lower.indices.resize(18);
  upper.indices.erase(upper.indices.begin(), upper.indices.begin() + 18);
  Scene scene = testing::one_mesh({lower, upper});
  scene.materials = {material(AlphaMode::opaque), material(AlphaMode::mask)};
  Result result = testing::run("second-depth", scene);
  EXPECT_EQ(closed_of(result.scene, 0), 6u);
  EXPECT_EQ(closed_of(result.scene, 1), 6u);
  // Where one half may not go, the other is open.
  scene.draws[1].material = 1;
  result = testing::run("second-depth", scene);
  EXPECT_EQ(closed_of(result.scene, 0), 0u);
  // In meshes of their own something may come between them.
  scene.draws[1].material = 0;
  Scene apart = testing::scene_of(scene.draws);
  apart.materials = scene.materials;
  EXPECT_EQ(closed_of(testing::run("second-depth", apart).scene, 0), 0u);
}

/// A box of which every triangle has vertices of its own, that follow joints.
Scene skinned_box(std::size_t odd_vertex) {
  const TestMesh shared = box();
  TestMesh mesh;
  for (const std::uint32_t v : shared.indices) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(shared.positions[v]);
  }
  Scene scene = testing::scene_of(mesh);
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float weight = v == odd_vertex ? 0.5f : mesh.positions[v].z > 0 ? 0.25f : 0.75f;
    joints.insert(joints.end(), {0, 1, static_cast<std::uint8_t>(v % 2), 0});  // the third has no weight
    weights.insert(weights.end(), {weight, 1 - weight, 0, 0});
  }
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  const auto stream = [&](const char* name, Component component, auto values, std::uint16_t bytes) {
    const auto raw = std::as_bytes(std::span(values));
    VertexStream made = vertices->base[0];
    made.semantic = name;
    made.format = {component, 4, false, bytes};
    made.bytes = Shared<std::byte>({raw.begin(), raw.end()});
    return made;
  };
  vertices->base.push_back(stream("JOINTS_0", Component::uint8, joints, 4));
  vertices->base.push_back(stream("WEIGHTS_0", Component::float32, weights, 16));
  scene.draws[0].full().vertices = vertices;
  return scene;
}

TEST(SecondDepth, SkinnedShellsAreClosedWhereJointsMoveTheirSeamsAlike) {
  EXPECT_EQ(closed_of(testing::run("second-depth", skinned_box(~std::size_t{0})).scene), 12u);
  EXPECT_EQ(closed_of(testing::run("second-depth", skinned_box(3)).scene), 0u) << "one corner goes elsewhere";
  const Result without = testing::run("second-depth(skinned=false)", skinned_box(~std::size_t{0}));
  EXPECT_EQ(closed_of(without.scene), 0u);
  EXPECT_THAT(notes_of(without), HasSubstr("follows joints"));
}

/// Another product's last range, as wires have it.
class LastHalfRow final : public ProductRow {
 public:
  LastHalfRow() : ProductRow({.name = std::string(SecondDepth::product) + "-other"}) {}
  std::string read(ExtensionReader&, Scene&) const override { return {}; }
  void write(const Scene&, ExtensionWriter&) const override {}
  std::vector<std::uint32_t> bounds(const Scene& scene, DrawLevel at) const override {
    return {static_cast<std::uint32_t>(scene.draws[at.draw].full().stream().triangle_count() / 2)};
  }
  ProductText told(const Scene&) const override { return {}; }
};

struct OtherProduct {
  static constexpr std::string_view product = "second-depth-other";
  friend bool operator==(const OtherProduct&, const OtherProduct&) = default;
};

/// [open, closed | closed, open]: the second half is the other product's.
TEST(SecondDepth, LeavesTheRangesOfOtherProductsWhereTheyAre) {
  const TestMesh first = joined(box(1, {0, 0, 0}, true), box(1, {5, 0, 0}));
  const TestMesh second = joined(box(1, {9, 0, 0}), box(1, {15, 0, 0}, true));
  Scene scene = testing::scene_of(joined(first, second));
  scene.products.set(OtherProduct{});
  testing::RunFixture fixture;
  const ProductRows rows{std::make_shared<LastHalfRow>(), second_depth_product()};
  foredraw::Run run{.analyses = fixture.analyses,
                    .executor = fixture.executor,
                    .findings = fixture.findings,
                    .views = fixture.views,
                    .products = rows};
  const Technique technique = second_depth_plugin().create({});
  std::get<std::unique_ptr<Processor>>(technique)->process(scene, {0}, run);
  EXPECT_EQ(closed_of(scene), 12u);
  const auto origin = scene.draws[0].full().stream().triangle_origin.view();
  EXPECT_EQ(origin[0], 10u) << "the closed box of the first half";
  EXPECT_EQ(origin[12], 0u);
  for (std::uint32_t t = 22; t < 44; ++t) EXPECT_EQ(origin[t], t);
}

}  // namespace
}  // namespace foredraw::second_depth_stage_test
