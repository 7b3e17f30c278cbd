#include <foredraw/viewing/draw_mask.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <span>

namespace foredraw::draw_mask_test {
namespace {

VertexStream floats(std::string semantic, std::uint8_t components, const std::vector<float>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic),
          {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A masked triangle with places in its image.
Scene leaf() {
  const testing::TestMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};
  Scene scene = testing::scene_of({testing::draw_of(triangle)});
  VertexStreams streams = *scene.draws[0].levels[0].vertices;
  streams.base.push_back(floats("TEXCOORD_0", 2, {0, 0, 1, 0, 0.25f, 0.5f}));
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  scene.draws[0].material = 0;
  scene.materials.resize(1);
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[0].base_colour = Texture{};
  scene.materials[0].base_colour->image = 0;
  scene.images.resize(1);
  return scene;
}

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

/// Decodes whatever it is given to two texels of grey and alpha, of which the first is a hole.
ImageDecoder a_hole(int bits = 8) {
  return [bits](const Image&) -> std::variant<Texels, std::string> {
    return Texels{{2, 1, 2, bits, bits == 32},
                  bits == 8    ? bytes_of<std::uint8_t>({9, 0, 9, 0xFF})
                  : bits == 16 ? bytes_of<std::uint16_t>({9, 0, 9, 0xFFFF})
                               : bytes_of<float>({9, -1, 9, 7})};
  };
}

std::shared_ptr<const Mask> known(const Scene& scene, Analyses& analyses) {
  const auto mask = mask_of(analyses, scene, scene.draws[0]);
  EXPECT_EQ(mask.index(), 0u);
  return mask.index() == 0 ? std::get<0>(mask) : nullptr;
}

std::string why_not(const Scene& scene, Analyses& analyses) {
  const auto mask = mask_of(analyses, scene, scene.draws[0]);
  EXPECT_EQ(mask.index(), 1u);
  return mask.index() == 1 ? std::get<1>(mask) : "";
}

TEST(DrawMask, has_the_alpha_of_the_image_whatever_its_bits) {
  for (const int bits : {8, 16, 32}) {
    Analyses analyses(a_hole(bits));
    const auto mask = known(leaf(), analyses);
    ASSERT_NE(mask, nullptr);
    EXPECT_EQ(mask->image->width, 2u);
    EXPECT_EQ(mask->image->alpha, (std::vector<std::uint16_t>{0, 65535})) << bits;
    EXPECT_EQ(mask->alphas, (std::vector<double>{1, 1, 1}));
    EXPECT_EQ(mask->uv, (std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0.25, 0.5}}));
    EXPECT_EQ(mask->cutoff, 0.5);
  }
}

TEST(DrawMask, an_image_is_decoded_once) {
  int times = 0;
  Analyses analyses([&times](const Image& image) {
    ++times;
    return a_hole()(image);
  });
  const Scene scene = leaf();
  EXPECT_EQ(known(scene, analyses)->image, known(scene, analyses)->image);
  EXPECT_EQ(times, 1);
}

TEST(DrawMask, what_is_not_masked_or_has_no_holes_has_none) {
  Analyses analyses(a_hole());
  Scene scene = leaf();
  scene.materials[0].alpha_mode = AlphaMode::opaque;
  EXPECT_EQ(known(scene, analyses), nullptr);
  scene = leaf();
  scene.materials[0].base_colour.reset();
  EXPECT_EQ(known(scene, analyses), nullptr);
  scene.materials[0].alpha = 0.49f;
  EXPECT_NE(known(scene, analyses), nullptr);
  scene = leaf();
  scene.materials.clear();
  EXPECT_EQ(known(scene, analyses), nullptr);
}

TEST(DrawMask, colours_of_vertices_multiply) {
  Analyses analyses(a_hole());
  Scene scene = leaf();
  VertexStreams streams = *scene.draws[0].levels[0].vertices;
  streams.base.push_back(floats("COLOR_0", 4, {1, 1, 1, 0.5f, 1, 1, 1, 1, 1, 1, 1, 0}));
  scene.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(std::move(streams));
  scene.materials[0].alpha = 0.5f;
  EXPECT_EQ(known(scene, analyses)->alphas, (std::vector<double>{0.25, 0.5, 0}));
}

TEST(DrawMask, places_are_scaled_turned_and_moved) {
  Analyses analyses(a_hole());
  Scene scene = leaf();
  Texture& texture = *scene.materials[0].base_colour;
  texture.scale = {2, 4};
  texture.rotation = 1.5707963267948966;  // what lay to the right lies above
  texture.offset = {10, 20};
  const auto mask = known(scene, analyses);
  const std::vector<glm::dvec2> expected = {{10, 20}, {10, 18}, {12, 19.5}};
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_NEAR(mask->uv[v].x, expected[v].x, 1e-14);
    EXPECT_NEAR(mask->uv[v].y, expected[v].y, 1e-14);
  }
  texture.rotation += 6.283185307179586 * 5;
  EXPECT_NEAR(known(scene, analyses)->uv[2].x, 12, 1e-13);
}

TEST(DrawMask, says_why_it_is_not_known_where_the_holes_are) {
  Analyses blind;
  EXPECT_EQ(why_not(leaf(), blind), "this program cannot decode images");
  Analyses analyses(a_hole());
  Scene scene = leaf();
  scene.materials[0].base_colour->texcoord = 3;
  EXPECT_EQ(why_not(scene, analyses), "it has no TEXCOORD_3");
  scene.materials[0].base_colour->image.reset();
  EXPECT_EQ(why_not(scene, analyses), "its texture has no image of a known kind");
}

}  // namespace
}  // namespace foredraw::draw_mask_test
