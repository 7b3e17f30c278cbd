// KHR_materials_volume: the thickness comes in, and what a stage changes of it comes out.
#include <gtest/gtest.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"

namespace foredraw::thickness_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;

constexpr const char* name = "KHR_materials_volume";

GltfBuilder of_glass(GltfJson members) {
  GltfBuilder builder = testing::ribbon(2);
  builder.json["materials"] = {{{"name", "glass"}, {"extensions", {{name, std::move(members)}}}}};
  builder.json["extensionsUsed"] = {name};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  return builder;
}

GltfJson whole() { return {{"thicknessFactor", 0.25}, {"attenuationDistance", 3}, {"myOwn", "word"}}; }

GltfJson members_in(const GltfJson& json, std::size_t material) {
  return json["materials"][material]["extensions"][name];
}

TEST(GltfThickness, ComesInWhereThereIsOne) {
  EXPECT_EQ(testing::read(of_glass(whole())).materials[0].thickness, 0.25f);
  for (const auto& [why, members] :
       {std::pair("absent", GltfJson::object()), std::pair("none", GltfJson{{"thicknessFactor", 0}}),
        std::pair("less than any float", GltfJson{{"thicknessFactor", 1e-60}}), std::pair("no object", GltfJson(7))}) {
    EXPECT_EQ(testing::read(of_glass(members)).materials[0].thickness, std::nullopt) << why;
  }
}

TEST(GltfThickness, ThatIsNoNumberIsLeftOutWithAWarning) {
  for (const GltfJson& wrong : {GltfJson("much"), GltfJson(1e39)}) {
    GltfJson members = whole();
    members["thicknessFactor"] = wrong;
    Diagnostics diagnostics;
    const auto scene = read_gltf(of_glass(members).glb(), "glass.glb", {}, diagnostics);
    ASSERT_TRUE(scene) << to_text(diagnostics);
    EXPECT_FALSE(diagnostics.empty());
    EXPECT_EQ(scene->materials[0].thickness, std::nullopt);
  }
}

TEST(GltfThickness, StaysAsItCameWhereNobodyTouchesIt) {
  const GltfBuilder builder = of_glass(whole());
  EXPECT_EQ(testing::write(testing::read(builder)), builder.glb());
}

TEST(GltfThickness, ThatIsChangedComesOutWithWhatWeDoNotKnow) {
  Scene scene = testing::read(of_glass(whole()));
  scene.materials[0].thickness = 0.1f;
  GltfJson expected = whole();
  expected["thicknessFactor"] = 0.1f;
  EXPECT_EQ(members_in(testing::written(scene), 0), expected);
  EXPECT_EQ(testing::read(testing::write(scene)).materials[0].thickness, 0.1f);
  scene.materials[0].thickness.reset();
  expected.erase("thicknessFactor");
  EXPECT_EQ(members_in(testing::written(scene), 0), expected);
}

TEST(GltfThickness, OfANewMaterialIsWrittenAndReadAgain) {
  Scene scene = testing::read(testing::ribbon(2));
  scene.materials.push_back({.name = "new", .thickness = 2.0f});
  const GltfJson json = testing::written(scene);
  EXPECT_EQ(json["extensionsUsed"], GltfJson({name}));
  EXPECT_EQ(testing::read(testing::write(scene)).materials[0].thickness, 2.0f);
}

TEST(GltfThickness, OfTheFirstAndOfACopyAreTheirOwn) {
  Scene scene = testing::read(of_glass(whole()));
  Material copy = scene.materials[0];
  copy.copy_of = 0;
  scene.materials.push_back(copy);
  scene.materials[0].thickness = 1.0f;
  const auto thicknesses = [&] {
    const Scene again = testing::read(testing::write(scene));
    return std::pair(again.materials[0].thickness, again.materials[1].thickness);
  };
  EXPECT_EQ(thicknesses(), std::pair(std::optional(1.0f), std::optional(0.25f))) << "the copy is of what was read";
  scene.materials[1].thickness = 8.0f;
  EXPECT_EQ(thicknesses(), std::pair(std::optional(1.0f), std::optional(8.0f)));
}

}  // namespace
}  // namespace foredraw::thickness_test
