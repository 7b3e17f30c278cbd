#include <foredraw/image/sprite_pieces.h>

#include <gtest/gtest.h>

namespace foredraw::sprite_pieces_test {
namespace {

template <class T>
Shared<std::byte> bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return Shared<std::byte>({bytes.begin(), bytes.end()});
}

Draw draw_of(const std::vector<glm::vec3>& positions, const std::vector<glm::vec2>& texcoords,
             std::vector<std::uint32_t> indices) {
  auto vertices = std::make_shared<VertexStreams>();
  vertices->count = static_cast<std::uint32_t>(positions.size());
  vertices->base = {{"POSITION", {Component::float32, 3, false, 12}, bytes_of(positions)},
                    {"TEXCOORD_0", {Component::float32, 2, false, 8}, bytes_of(texcoords)}};
  Draw draw;
  draw.levels = {{vertices, {{Shared<std::uint32_t>(std::move(indices))}}}};
  return draw;
}

TEST(SpritePieces, corners_that_are_stored_twice_hang_together) {
  const Draw draw =
      draw_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
              {{0, 1}, {1, 1}, {1, 0}, {0, 1}, {1, 0}, {0, 0}, {0, 0}, {1, 0}, {0, 1}}, {0, 1, 2, 6, 7, 8, 3, 4, 5});
  const std::vector<SpritePiece> pieces = sprite_pieces(draw);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].triangles, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(pieces[0].outline, (std::vector<std::uint32_t>{0, 1, 2, 5}));
  EXPECT_EQ(pieces[1].outline, (std::vector<std::uint32_t>{6, 7, 8}));
  EXPECT_FALSE(is_made_of_quads(draw));
}

TEST(SpritePieces, a_piece_with_a_hole_or_a_fold_has_no_outline) {
  const Draw fold = draw_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1}, {1, 1}, {1, 0}}, {0, 1, 2, 0, 1, 2});
  ASSERT_EQ(sprite_pieces(fold).size(), 1u);
  EXPECT_TRUE(sprite_pieces(fold)[0].outline.empty());
}

TEST(SpritePieces, quads_may_be_turned_mirrored_and_leaning) {
  const std::vector<glm::vec3> leaning = {{0, 0, 1}, {2, 0, 1}, {3, 1, 2}, {1, 1, 2}};
  EXPECT_TRUE(is_made_of_quads(draw_of(leaning, {{0, 0}, {0, .5}, {.25, .5}, {.25, 0}}, {0, 1, 2, 0, 2, 3})));
  EXPECT_TRUE(is_made_of_quads(draw_of(leaning, {{1, 0}, {0, 0}, {0, 1}, {1, 1}}, {0, 1, 2, 0, 2, 3})));
  EXPECT_FALSE(is_made_of_quads(draw_of(leaning, {{1, 0}, {0, .1}, {0, 1}, {1, .9}}, {0, 1, 2, 0, 2, 3})));
  EXPECT_FALSE(is_made_of_quads(
      draw_of({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0, 1, 2, 0, 2, 3})));
  EXPECT_FALSE(is_made_of_quads(draw_of(leaning, {{0, 0}, {0, 0}, {0, 0}, {0, 0}}, {0, 1, 2, 0, 2, 3})));
  EXPECT_FALSE(is_made_of_quads(draw_of({}, {}, {})));
  EXPECT_FALSE(is_made_of_sprites(draw_of({}, {}, {})));
}

TEST(SpritePieces, polygons_that_show_the_image_evenly_are_sprites_and_no_quads) {
  const std::vector<glm::vec2> uv = {{0, 0}, {.5, -.1}, {1, .5}, {.4, 1}, {0, .7}};
  const std::vector<std::uint32_t> fan = {0, 1, 2, 0, 2, 3, 0, 3, 4};
  std::vector<glm::vec3> flat, bent;
  for (const glm::vec2& p : uv) flat.emplace_back(3 * p.x + p.y, 2 - p.y, p.x - p.y);
  bent = flat;
  bent[3].z += 0.1f;
  EXPECT_TRUE(is_made_of_sprites(draw_of(flat, uv, fan)));
  EXPECT_FALSE(is_made_of_quads(draw_of(flat, uv, fan)));
  EXPECT_FALSE(is_made_of_sprites(draw_of(bent, uv, fan)));
  EXPECT_TRUE(is_made_of_sprites(draw_of({flat[0], flat[1], flat[2]}, {uv[0], uv[1], uv[2]}, {0, 1, 2})));
}

}  // namespace
}  // namespace foredraw::sprite_pieces_test
