#include "plugins/processors/displacement/displacement.h"

#include "support/displaced.h"
#include "support/staged.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw {
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

}  // namespace
}  // namespace foredraw
