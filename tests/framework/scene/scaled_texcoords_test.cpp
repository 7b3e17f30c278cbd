// Texture coordinates in other units: textures lie where they lay.
#include <foredraw/scene/scaled_texcoords.h>
#include <foredraw/scene/turn.h>

#include <gtest/gtest.h>

namespace foredraw::scaled_texcoords_test {
namespace {

constexpr ScaledTexcoords by_256 = {.set = 1, .offset = {-0.5, 0.25}, .scale = {0x1p-8, 0x1p-7}};

Texture turned_texture() { return {.image = 3, .texcoord = 1, .scale = {2, 0.3}, .rotation = 0.7, .offset = {0.1, 5}}; }

glm::dvec2 place_of(const glm::dvec2& uv, const Texture& texture) {
  return texture.offset + turned(texture.scale * uv, turn_by(texture.rotation));
}

void expect_near(const glm::dvec2& a, const glm::dvec2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

TEST(ScaledTexcoords, LeaveATextureWhereItLies) {
  const Texture was = turned_texture(), now = with_scaled_texcoords(was, by_256);
  for (const glm::dvec2 whole : {glm::dvec2(0, 0), glm::dvec2(255, 3), glm::dvec2(17, 65535)}) {
    expect_near(place_of(whole, now), place_of(by_256.offset + by_256.scale * whole, was));
  }
  Texture moved = now;
  moved.offset = was.offset;
  moved.scale = was.scale;
  EXPECT_EQ(moved, was) << "nothing else of it changes";
}

TEST(ScaledTexcoords, OfAnotherSetLeaveATextureAsItIs) {
  ScaledTexcoords other = by_256;
  other.set = 0;
  EXPECT_EQ(with_scaled_texcoords(turned_texture(), other), turned_texture());
}

TEST(ScaledTexcoords, OfAMaterialChangeItsTexturesOfTheSet) {
  Texture of_set_0 = turned_texture();
  of_set_0.texcoord = 0;
  const Material was{
      .base_colour = turned_texture(), .normal_map = of_set_0, .displacement = {{turned_texture(), 2, 3}}};
  const Material now = with_scaled_texcoords(was, by_256);
  const Texture scaled = with_scaled_texcoords(turned_texture(), by_256);
  EXPECT_EQ(now.base_colour, scaled);
  EXPECT_EQ(now.normal_map, of_set_0);
  EXPECT_EQ(now.displacement, (Displacement{scaled, 2, 3}));
  EXPECT_EQ(now.scaled_texcoords, std::vector{by_256});
}

TEST(ScaledTexcoords, TwiceAreOneThatLeadsBackToTheFile) {
  const ScaledTexcoords second{.set = 1, .offset = {8, -4}, .scale = {4, 2}};
  const ScaledTexcoords of_set_0{.set = 0, .offset = {1, 1}, .scale = {3, 3}};
  Material material{.base_colour = turned_texture()};
  for (const ScaledTexcoords& change : {by_256, of_set_0, second}) material = with_scaled_texcoords(material, change);
  ASSERT_EQ(material.scaled_texcoords.size(), 2u);
  EXPECT_EQ(material.scaled_texcoords[0], of_set_0) << "by set";
  const ScaledTexcoords both = material.scaled_texcoords[1];
  const glm::dvec2 whole(5, 7), file = both.offset + both.scale * whole;
  EXPECT_EQ(file, by_256.offset + by_256.scale * (second.offset + second.scale * whole));
  expect_near(place_of(whole, *material.base_colour), place_of(file, turned_texture()));
  EXPECT_EQ(scaled_texcoords_of(&material, 1), both);
  EXPECT_EQ(scaled_texcoords_of(&material, 7), ScaledTexcoords{.set = 7});
  EXPECT_EQ(scaled_texcoords_of(nullptr, 0), ScaledTexcoords{});
}

TEST(ScaledTexcoords, KeepMaterialsAlikeThatWereAndAreScaledAlike) {
  const auto stamp = [](const int number) { return content_hash(std::span(&number, 1)); };
  const Material red{.look = stamp(1), .kind = stamp(9)}, green{.look = stamp(2), .kind = stamp(9)};
  ScaledTexcoords other = by_256;
  other.scale *= 2;
  const Material a = with_scaled_texcoords(red, by_256), b = with_scaled_texcoords(red, other);
  EXPECT_EQ(a.look, with_scaled_texcoords(red, by_256).look);
  EXPECT_NE(a.look, b.look);
  EXPECT_NE(a.look, red.look);
  EXPECT_NE(a.look, with_scaled_texcoords(green, by_256).look);
  EXPECT_EQ(a.kind, b.kind) << "they differ in numbers alone";
  EXPECT_NE(a.kind, red.kind);
  EXPECT_EQ(a.kind, with_scaled_texcoords(a, other).kind);
  EXPECT_EQ(with_scaled_texcoords(Material{}, by_256).look, std::nullopt);
}

TEST(ScaledTexcoords, AreSoManyWidthsOfATexture) {
  EXPECT_EQ(texture_widths(nullptr, 0), glm::dvec2(1));
  Material material{.base_colour = turned_texture(), .normal_map = Texture{.texcoord = 1, .scale = {-4, 0.1}}};
  EXPECT_EQ(texture_widths(&material, 1), glm::dvec2(4, 0.3)) << "the one that runs the fastest";
  EXPECT_EQ(texture_widths(&material, 0), glm::dvec2(1));
  material = with_scaled_texcoords(Material{}, {.set = 0, .scale = {0.5, 0.25}});
  EXPECT_EQ(texture_widths(&material, 0), glm::dvec2(0.5, 0.25)) << "looked up by a texture that the file alone knows";
}

}  // namespace
}  // namespace foredraw::scaled_texcoords_test
