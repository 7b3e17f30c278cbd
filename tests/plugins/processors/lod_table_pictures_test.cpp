#include "plugins/processors/lod_table/lod_pictures.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::lod_table_pictures_test {
namespace {

template <class T>
VertexStream stream_of(const char* semantic, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  const Format format{Component::float32, sizeof(T) / 4, false, sizeof(T)};
  return {semantic, format, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A ball with texture coordinates; its material names the scene's last images, behind one of something else.
Scene textured_ball() {
  const testing::TestMesh mesh = testing::sphere(32, 16);
  Scene scene = testing::scene_of({testing::draw_of(testing::grid(1, 1), "other"), testing::draw_of(mesh, "ball")});
  VertexStreams vertices = *scene.draws[1].full().vertices;
  std::vector<std::array<float, 2>> places;
  for (const glm::vec3& p : mesh.positions) places.push_back({p.x, p.y});
  vertices.base.push_back(stream_of("TEXCOORD_0", places));
  vertices.base.push_back(stream_of("NORMAL", mesh.positions));
  scene.draws[1].full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  for (const char* name : {"something else", "colours", "normals"}) {
    scene.images.emplace_back();
    scene.images.back().name = scene.images.back().uri = name;
  }
  scene.materials.resize(2);
  scene.materials[1].base_colour.emplace().image = 1;
  scene.materials[1].normal_map.emplace().image = 2;
  scene.draws[1].material = 1;
  return scene;
}

/// Every texel of an image is of one colour.
LodPictures pictures_of(const Scene& scene, DrawId draw, std::array<std::uint8_t, 3> colour,
                        std::array<std::uint8_t, 3> normal) {
  Analyses analyses([&](const Image& image) -> std::variant<Texels, std::string> {
    if (image.name == "something else") return std::string("nobody asks for it");
    Texels texels;
    texels.facts = {1, 1, 3, 8, false};
    for (const std::uint8_t channel : image.name == "normals" ? normal : colour) {
      texels.bytes.push_back(static_cast<std::byte>(channel));
    }
    return texels;
  });
  return lod_pictures(scene, draw, analyses, Executor(1));
}

constexpr std::array<std::uint8_t, 3> white = {255, 255, 255}, dark = {30, 30, 30}, upright = {128, 128, 255},
                                      leaning = {220, 128, 180};

TEST(LodPictures, TellWhatANormalMapDoes) {
  const Scene scene = textured_ball();
  const LodPictures with = pictures_of(scene, 1, white, leaning), without = pictures_of(scene, 1, white, upright);
  EXPECT_EQ(with.accuracy[0], 1);
  EXPECT_LT(with.accuracy[1], 0.9);
  EXPECT_GT(without.accuracy[1], 0.95);
}

TEST(LodPictures, SeeTheColoursOfTheirOwnDraw) {
  const Scene scene = textured_ball();
  EXPECT_NE(pictures_of(scene, 1, white, upright).accuracy[2], pictures_of(scene, 1, dark, upright).accuracy[2]);
  EXPECT_EQ(pictures_of(scene, 0, white, upright).accuracy, pictures_of(scene, 0, dark, leaning).accuracy);
}

TEST(LodPictures, OfWhatHasNoSizeAreNone) {
  testing::TestMesh mesh = testing::grid(2, 2);
  std::ranges::fill(mesh.positions, glm::vec3(5));
  EXPECT_EQ(pictures_of(testing::scene_of(mesh), 0, white, upright).radius, 0);
  std::ranges::fill(mesh.positions, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(pictures_of(testing::scene_of(mesh), 0, white, upright).radius, 0);
  mesh.indices.clear();
  EXPECT_EQ(pictures_of(testing::scene_of(mesh), 0, white, upright).radius, 0);
}

/// Corners on one line cover nothing.
TEST(LodPictures, OfALineAreNumbers) {
  testing::TestMesh mesh = testing::grid(2, 2);
  for (glm::vec3& p : mesh.positions) p.y = p.z = 0;
  const LodPictures pictures = pictures_of(testing::scene_of(mesh), 0, white, upright);
  EXPECT_EQ(pictures.coverage, 0);
  for (const double accuracy : pictures.accuracy) {
    EXPECT_GE(accuracy, 0);
    EXPECT_LE(accuracy, 1);
  }
}

}  // namespace
}  // namespace foredraw::lod_table_pictures_test
