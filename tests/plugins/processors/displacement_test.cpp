#include "plugins/processors/displacement/displacement.h"

#include "support/displaced.h"
#include "support/staged.h"

#include <foredraw/scene/scaled_texcoords.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <cmath>

namespace foredraw::displacement_test {
namespace {

Image flat() {
  return testing::height_image(2, 2, [](auto, auto) { return std::uint16_t{0}; });
}

/// Two draws of one material, without a displacement.
Scene two_draws() {
  Scene scene = testing::displaced_grid(3, 3, flat());
  scene.materials[0].displacement.reset();
  scene.draws[0].traits.remove(traits::displaced);
  scene.draws.push_back(scene.draws[0]);
  scene.meshes[0].draws.push_back(1);
  return scene;
}

TEST(Displacement, OfAMaterialThatOthersHaveTooIsACopys) {
  Scene scene = two_draws();
  const auto answer = displace(scene, {1}, {.map = 0, .factor = 0.5f, .offset = {}, .texcoord = {}});
  EXPECT_EQ(answer.displaced, std::vector<DrawId>{1});
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_FALSE(scene.materials[0].displacement);
  EXPECT_EQ(scene.materials[1].displacement, (Displacement{{.image = 0}, 0.5f, 0}));
  EXPECT_EQ(scene.materials[1].copy_of, MaterialId{0});
  EXPECT_EQ(scene.draws[0].material, MaterialId{0});
  EXPECT_EQ(scene.draws[1].material, MaterialId{1});
}

TEST(Displacement, OfAMaterialOfTheirOwnIsItsOwn) {
  Scene scene = two_draws();
  displace(scene, {0, 1}, {.map = 0, .factor = 0.5f, .offset = {}, .texcoord = {}});
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_TRUE(scene.materials[0].displacement);
}

TEST(Displacement, OfADrawWithoutAMaterialMakesOne) {
  Scene scene = two_draws();
  scene.draws[0].material.reset();
  displace(scene, {0}, {.map = 0, .factor = 0.5f, .offset = {}, .texcoord = {}});
  EXPECT_TRUE(scene.material_of(scene.draws[0])->displacement);
  EXPECT_FALSE(scene.material_of(scene.draws[1])->displacement);
}

TEST(Displacement, WithoutAFactorIsTwoPerCentOfTheDiagonal) {
  Scene scene = two_draws();
  const auto answer = displace(scene, {0, 1}, {.map = 0, .factor = {}, .offset = {}, .texcoord = {}});
  EXPECT_NEAR(*answer.factor, 0.02 * std::sqrt(18.0), 1e-6);
  EXPECT_EQ(scene.materials[0].displacement->factor, *answer.factor);
}

TEST(Displacement, ChangesOnlyWhatIsGiven) {
  Scene scene = testing::displaced_grid(3, 3, flat(), 0.25f, -1);
  const auto look = scene.materials[0].look = Stamp{1, 2};
  const auto answer = displace(scene, {0}, {.map = {}, .factor = {}, .offset = 3.0f, .texcoord = {}});
  EXPECT_FALSE(answer.factor);
  EXPECT_EQ(scene.materials[0].displacement, (Displacement{{.image = 0}, 0.25f, 3}));
  EXPECT_NE(scene.materials[0].look, look) << "it no longer looks like what looked like it";
}

TEST(Displacement, SaysWhyADrawCannotBeDisplaced) {
  Scene scene = two_draws();
  const GivenDisplacement none{};
  EXPECT_NE(displace(scene, {0}, none).why_not.at(0).second.find("names no map of heights"), std::string::npos);
  const auto answer = displace(scene, {0}, {.map = 0, .factor = {}, .offset = {}, .texcoord = 1});
  EXPECT_TRUE(answer.displaced.empty());
  EXPECT_EQ(answer.why_not.at(0).second, "it has no TEXCOORD_1");
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(Displacement, IsAStageThatKeepsWhatItCannotDisplace) {
  const Scene scene = two_draws();
  const Result result = testing::run("displacement(factor=2)", scene);
  EXPECT_FALSE(result.scene.materials[0].displacement);
  EXPECT_TRUE(
      testing::run("displacement(factor=2)", testing::displaced_grid(2, 2, flat())).scene.materials[0].displacement);
}

std::string crossing_in(const Result& result) {
  for (const StageRecord& stage : result.report.stages) {
    for (const NoteRecord& note : stage.notes) {
      if (note.code == "passes-through-itself") return note.message;
    }
  }
  return {};
}

/// Larger than the mesh, inwards: every point of a sphere moves through its middle, by as much as noise says.
TEST(Displacement, ThatIsLargerThanTheMeshIsTold) {
  testing::TestMesh sphere = testing::sphere(16, 8);
  for (glm::vec3& p : sphere.positions) p = glm::round(p * 1024.0f) / 1024.0f;  // it closes to the bit
  std::vector<glm::vec2> uv;
  for (const glm::vec3& p : sphere.positions) uv.emplace_back(0.5f + 0.4f * p.x, 0.5f + 0.4f * p.y);
  const Image noise = testing::height_image(
      64, 64, [](auto x, auto y) { return static_cast<std::uint16_t>((x * 2654435761u + y * 40503u) >> 7); });
  const Scene scene = testing::displaced_scene(sphere, uv, noise);
  EXPECT_NE(crossing_in(testing::run("displacement(factor=-3)", scene)).find("the surface passes through itself"),
            std::string::npos);
  EXPECT_NE(crossing_in(testing::run("displacement(factor=-3), tessellate(parts=2)", scene)).find("smaller factor"),
            std::string::npos);
  EXPECT_NE(crossing_in(testing::run("tessellate(parts=2)", testing::displaced_scene(sphere, uv, noise, -3))), "");
  const Image high = testing::height_image(2, 2, [](auto, auto) { return std::uint16_t{65535}; });
  EXPECT_EQ(crossing_in(testing::run("displacement(factor=3)", testing::displaced_scene(sphere, uv, high))), "")
      << "outwards there is room";
}

/// A gutter whose sides stand close: they meet as soon as they move by half of its width.
TEST(Displacement, OfACageWithAFoldIsTold) {
  testing::TestMesh fold = testing::grid(8, 4);
  std::vector<glm::vec2> uv;
  for (glm::vec3& p : fold.positions) {
    uv.emplace_back(p.x / 8, p.y / 4);
    const float along = p.x - 4;
    p = {0.05f * along, p.y, 2 * std::abs(along)};
  }
  const Image high = testing::height_image(32, 32, [](auto, auto) { return std::uint16_t{65535}; });
  const auto told = [&](float factor) {
    return crossing_in(testing::run("tessellate(parts=4)", testing::displaced_scene(fold, uv, high, factor)));
  };
  EXPECT_NE(told(0.12f), "") << "into the fold";
  EXPECT_EQ(told(-0.12f), "") << "away from it";
  EXPECT_EQ(told(0.001f), "");
}

/// Which scene's texture coordinates are in other units by now.
TEST(Displacement, OfAMapLiesWhereItWouldInTheFile) {
  const ScaledTexcoords of_0{.set = 0, .offset = {-3, 1}, .scale = glm::dvec2(0x1p-8)};
  const ScaledTexcoords of_1{.set = 1, .offset = {0.5, 0}, .scale = {0.25, 2}};
  const auto placed = [&](Texture before, std::uint32_t set, bool has_any) {
    Scene scene = two_draws();
    for (const Scene& other = scene; Draw & draw : scene.draws) {
      auto vertices = std::make_shared<VertexStreams>(*other.draws[0].full().vertices);
      if (vertices->find("TEXCOORD_1") == nullptr) {
        vertices->base.push_back(*vertices->find("TEXCOORD_0"));
        vertices->base.back().semantic = "TEXCOORD_1";
      }
      draw.full().vertices = vertices;
    }
    if (has_any) scene.materials[0].displacement = Displacement{before, 1};
    for (const ScaledTexcoords& change : {of_0, of_1})
      scene.materials[0] = with_scaled_texcoords(scene.materials[0], change);
    displace(scene, {0, 1}, {.map = 0, .factor = 0.5f, .offset = {}, .texcoord = set});
    return scene.materials[0].displacement->texture;
  };
  const Texture turned{.image = 0, .scale = {2, 4}, .rotation = 0, .offset = {0.5, 0.25}};
  EXPECT_EQ(placed({}, 0, false), with_scaled_texcoords({.image = 0}, of_0));
  EXPECT_EQ(placed({}, 1, false), with_scaled_texcoords({.image = 0, .texcoord = 1}, of_1));
  EXPECT_EQ(placed(turned, 0, true), with_scaled_texcoords(turned, of_0));
  Texture on_1 = turned;
  on_1.texcoord = 1;
  EXPECT_EQ(placed(turned, 1, true), with_scaled_texcoords(on_1, of_1));
}

}  // namespace
}  // namespace foredraw::displacement_test
