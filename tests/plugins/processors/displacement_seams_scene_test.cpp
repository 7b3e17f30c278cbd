#include "plugins/processors/displacement_seams/displacement_seams.h"

#include "support/displaced.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>

#include <gtest/gtest.h>

namespace foredraw::displacement_seams_scene_test {
namespace {

using namespace testing;

testing::Map noise() {
  testing::Map map = noise_map(96, 96, 1);
  for (std::uint16_t& texel : map.texels) texel = static_cast<std::uint16_t>(20000 + texel / 4);
  return map;
}

Image image_of(const testing::Map& map) {
  return height_image(map.width, map.height,
                      [&](std::uint32_t x, std::uint32_t y) { return map.texels[std::size_t{y} * map.width + x]; });
}

Scene scene_of_charts(const Charts& charts, const testing::Map& map) {
  return displaced_scene({charts.positions, charts.indices}, charts.uvs, image_of(map), 0.5f, 2);
}

/// That a draw's material moves it by.
testing::Map map_of(const Scene& scene, DrawId draw) {
  const Image& image = scene.images[*scene.material_of(scene.draws[draw])->displacement->texture.image];
  const Analyses analyses(image_decoder({}));
  const Texels texels = std::get<Texels>(analyses.decode(image));
  EXPECT_EQ(texels.facts.bits, 16);
  testing::Map map{texels.facts.width, texels.facts.height, {}};
  map.texels.resize(texels.bytes.size() / 2);
  std::memcpy(map.texels.data(), texels.bytes.data(), texels.bytes.size());
  return map;
}

TEST(DisplacementSeamsStage, GivesTheMaterialAMapWithoutGaps) {
  const Charts charts = cube_sphere(4, turned_places());
  const Scene scene = scene_of_charts(charts, noise());
  const Result result = run("displacement-seams", scene);
  EXPECT_EQ(opinion(charts.mesh(), map_of(result.scene, 0)).unequal, 0u);
  EXPECT_EQ(result.scene.images.size(), 2u);
  EXPECT_EQ(result.scene.images[0].bytes.stamp(), scene.images[0].bytes.stamp()) << "others may show it";
  EXPECT_EQ(result.scene.materials[0].displacement->factor, 0.5f);
  EXPECT_EQ(result.scene.materials[0].displacement->offset, 2);
  const Result again = run("displacement-seams", result.scene);
  EXPECT_EQ(again.scene.images.size(), 2u);
}

TEST(DisplacementSeamsStage, IsThereAfterWritingAndReading) {
  const Charts charts = cube_sphere(3, turned_places());
  const Scene scene = run("displacement-seams", scene_of_charts(charts, noise())).scene;
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "out.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "again", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  const testing::Map map = map_of(*again, 0);
  EXPECT_EQ(map.texels, map_of(scene, 0).texels);
  EXPECT_EQ(opinion(charts.mesh(), map).unequal, 0u);
}

/// What a surface is moved by stays, up to half a step of 16 bits, when heights are scaled.
TEST(DisplacementSeamsStage, AdjustsFactorAndOffset) {
  const Charts charts = cube_sphere(4, turned_places());
  testing::Map map = noise_map(128, 128, 3);
  for (std::uint16_t& texel : map.texels) texel = texel < 32768 ? 0 : 65535;
  const Scene before = scene_of_charts(charts, map), after = run("displacement-seams", before).scene;
  const Displacement displacement = *after.materials[0].displacement;
  EXPECT_GT(displacement.factor, 0.5f);
  EXPECT_LT(displacement.offset, 2);
  const testing::Map now = map_of(after, 0);
  const auto repaired = displacement_seams(charts.seams(), map.view());
  for (std::uint32_t i = 0; i < map.texels.size(); ++i) {
    if (std::ranges::binary_search(repaired.seam_texels, i)) continue;
    const double moved = displacement.offset + displacement.factor * (now.texels[i] / 65535.0);
    EXPECT_NEAR(moved, 2 + 0.5 * (map.texels[i] / 65535.0), 1e-5);
  }
}

/// Half of the sphere in one draw and half in the other, of one mesh and of materials of their own.
Scene two_draws(const Charts& charts, const testing::Map& map, bool is_one_mesh) {
  Scene scene = scene_of_charts(charts, map);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].displacement->factor = -3;
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].material = 1;
  const std::vector<std::uint32_t>& all = charts.indices;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  scene.draws[0].full().stream().indices = Shared<std::uint32_t>({all.begin(), middle});
  scene.draws[1].full().stream().indices = Shared<std::uint32_t>({middle, all.end()});
  if (is_one_mesh) {
    scene.meshes[0].draws.push_back(1);
  } else {
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].draws = {1};
    scene.nodes.push_back(scene.nodes[0]);
    scene.nodes[1].mesh = 1;
  }
  return scene;
}

TEST(DisplacementSeamsStage, TakesDrawsOfOneMapTogether) {
  const Charts charts = cube_sphere(4, turned_places());
  const Scene scene = run("displacement-seams", two_draws(charts, noise(), true)).scene;
  EXPECT_EQ(scene.materials[0].displacement->texture.image, scene.materials[1].displacement->texture.image);
  EXPECT_EQ(scene.materials[0].displacement->factor, 0.5f);
  EXPECT_EQ(scene.materials[1].displacement->factor, -3);
  EXPECT_EQ(opinion(charts.mesh(), map_of(scene, 0)).unequal, 0u) << "between the draws, too";
}

TEST(DisplacementSeamsStage, DrawsOfTwoMeshesHaveNoSeamBetweenThem) {
  const Charts charts = cube_sphere(4, turned_places());
  const Scene scene = run("displacement-seams", two_draws(charts, noise(), false)).scene;
  const testing::Map map = map_of(scene, 0);
  EXPECT_GT(opinion(charts.mesh(), map).unequal, 0u);
  for (const auto half : {std::span(charts.indices).first(charts.indices.size() / 2),
                          std::span(charts.indices).last(charts.indices.size() / 2)}) {
    const Opinion of_half = opinion({charts.positions, charts.uvs, half}, map);
    EXPECT_GT(of_half.edges, 0u);
    EXPECT_EQ(of_half.unequal, 0u);
  }
}

TEST(DisplacementSeamsStage, SaysWhyItKeepsWhatItKeeps) {
  const auto reason = [](const Result& result) {
    const StageRecord& stage = result.report.stages.at(0);
    return stage.skipped.empty() ? std::string() : stage.skipped[0].reason;
  };
  const Result whole = run("displacement-seams", displaced_grid(3, 3, image_of(noise())));
  EXPECT_EQ(whole.scene.images.size(), 1u);
  EXPECT_NE(reason(whole).find("0 seam edges"), std::string::npos) << reason(whole);
  const Scene repaired = run("displacement-seams", scene_of_charts(cube_sphere(3, turned_places()), noise())).scene;
  const Result again = run("displacement-seams", repaired);
  EXPECT_NE(reason(again).find("as equal as they can be"), std::string::npos) << reason(again);
}

TEST(DisplacementSeamsStage, LeavesOutMapsThatCannotBeRead) {
  Scene scene = scene_of_charts(cube_sphere(3, turned_places()), noise());
  scene.images[0] = {.name = "damaged", .bytes = Shared<std::byte>({std::byte{7}})};
  const Result result = run("displacement-seams", scene);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(result.scene.images.size(), 1u);
  ASSERT_FALSE(result.report.stages[0].notes.empty());
  EXPECT_NE(result.report.stages[0].notes[0].message.find("its map cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace foredraw::displacement_seams_scene_test
