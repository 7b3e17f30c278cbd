#include <foredraw/analysis/certificate.h>

#include "support/meshes.h"

#include <foredraw/scene/reorder.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace foredraw::certificate_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Certificate certificate(const VertexStreams& vertices, const Numbers& indices) {
  Analyses analyses;
  return certificate_of(vertices, indices, analyses);
}

Certificate certificate(const Draw& draw) {
  Analyses analyses;
  return certificates_of(draw, analyses).at(0);
}

Numbers random_permutation(std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  Numbers order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  for (std::uint32_t n = count; n > 1; --n) std::swap(order[n - 1], order[random.below(n)]);
  return order;
}

/// Every vertex is used, no two are equal, and there is a morph target.
Draw random_mesh(std::uint32_t least_triangles = 1) {
  testing::TestMesh mesh = testing::soup(*rc::gen::inRange(least_triangles, 20u), *rc::gen::arbitrary<std::uint64_t>());
  for (std::uint32_t& index : mesh.indices) {
    if (*rc::gen::inRange(0, 3) == 0) index = *rc::gen::inRange(0u, static_cast<std::uint32_t>(mesh.positions.size()));
  }
  Draw draw = testing::draw_of(mesh);
  VertexStreams vertices = *draw.levels[0].vertices;
  std::vector<glm::vec3> moved = mesh.positions;
  for (glm::vec3& position : moved) position *= 0.5f;
  vertices.morph_targets = {testing::vertex_streams(moved)->base};
  draw.levels[0].vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  return draw;
}

Numbers indices_of(const Draw& draw) {
  const auto view = draw.levels[0].orders[0].indices.view();
  return {view.begin(), view.end()};
}

RC_GTEST_PROP(Certificate, any_order_of_triangles_keeps_it, (std::uint64_t seed)) {
  const Draw draw = random_mesh();
  const auto triangles = static_cast<std::uint32_t>(draw.levels[0].orders[0].triangle_count());
  RC_ASSERT(certificate(with_triangle_order(draw, random_permutation(triangles, seed))) == certificate(draw));
}

RC_GTEST_PROP(Certificate, any_numbering_of_vertices_keeps_it, (std::uint64_t seed)) {
  const Draw draw = random_mesh();
  const VertexStreams& vertices = *draw.levels[0].vertices;
  const Numbers destination = random_permutation(vertices.count, seed);
  const auto moved = std::make_shared<const VertexStreams>(with_vertices_moved(vertices, destination, vertices.count));
  RC_ASSERT(certificate(with_vertices_moved(draw, 0, moved, destination)) == certificate(draw));
}

RC_GTEST_PROP(Certificate, rotated_corners_break_it, ()) {
  const Draw draw = random_mesh();
  Numbers indices = indices_of(draw);
  const auto at = 3 * *rc::gen::inRange<std::size_t>(0, indices.size() / 3);
  std::rotate(indices.begin() + at, indices.begin() + at + 1, indices.begin() + at + 3);
  RC_PRE(indices != indices_of(draw));
  RC_ASSERT(certificate(*draw.levels[0].vertices, indices) != certificate(draw));
}

RC_GTEST_PROP(Certificate, a_dropped_or_a_doubled_triangle_breaks_it, ()) {
  const Draw draw = random_mesh();
  const Numbers indices = indices_of(draw);
  const auto at = 3 * *rc::gen::inRange<std::size_t>(0, indices.size() / 3);
  Numbers dropped = indices;
  dropped.erase(dropped.begin() + at, dropped.begin() + at + 3);
  RC_ASSERT(certificate(*draw.levels[0].vertices, dropped) != certificate(draw));
  Numbers doubled = indices;
  doubled.insert(doubled.end(), indices.begin() + at, indices.begin() + at + 3);
  RC_ASSERT(certificate(*draw.levels[0].vertices, doubled) != certificate(draw));
}

RC_GTEST_PROP(Certificate, one_triangle_in_the_place_of_another_breaks_it, ()) {
  const Draw draw = random_mesh(2);
  const Numbers indices = indices_of(draw);
  const auto a = 3 * *rc::gen::inRange<std::size_t>(1, indices.size() / 3);
  const auto b = 3 * *rc::gen::inRange<std::size_t>(0, a / 3);
  Numbers changed = indices;
  std::copy_n(indices.begin() + a, 3, changed.begin() + b);
  RC_PRE(changed != indices);
  RC_ASSERT(certificate(*draw.levels[0].vertices, changed) != certificate(draw));
}

RC_GTEST_PROP(Certificate, one_bit_of_a_vertex_that_is_used_breaks_it, ()) {
  const Draw draw = random_mesh();
  VertexStreams vertices = *draw.levels[0].vertices;
  const Numbers indices = indices_of(draw);
  const std::uint32_t vertex = indices[*rc::gen::inRange<std::size_t>(0, indices.size())];
  VertexStream& stream = *rc::gen::arbitrary<bool>() ? vertices.base[0] : vertices.morph_targets[0][0];
  std::vector<std::byte> bytes(stream.bytes.view().begin(), stream.bytes.view().end());
  bytes[vertex * 12 + *rc::gen::inRange<std::size_t>(0, 12)] ^= std::byte{1} << *rc::gen::inRange(0, 8);
  stream.bytes = Shared<std::byte>(std::move(bytes));
  RC_ASSERT(certificate(vertices, indices) != certificate(draw));
}

TEST(Certificate, MergedAndLeftOutVerticesKeepIt) {
  const Draw draw = testing::draw_of({{{1, 0, 0}, {9, 0, 0}, {1, 0, 0}, {4, 0, 0}, {5, 0, 0}}, {0, 3, 4, 2, 4, 3}});
  const Numbers destination = {0, no_vertex, 0, 1, 2};
  const auto moved =
      std::make_shared<const VertexStreams>(with_vertices_moved(*draw.levels[0].vertices, destination, 3));
  EXPECT_EQ(certificate(with_vertices_moved(draw, 0, moved, destination)), certificate(draw));
}

TEST(Certificate, OtherFormatsAndNamesBreakIt) {
  const Draw draw = testing::draw_of(testing::grid(2, 2));
  const Numbers indices = indices_of(draw);
  std::vector<VertexStreams> others(3, *draw.levels[0].vertices);
  others[0].base[0].semantic = "NORMAL";
  others[1].base[0].format.component = Component::uint32;
  others[2].morph_targets = {others[2].base};
  others[2].base.clear();
  for (const VertexStreams& other : others) EXPECT_NE(certificate(other, indices), certificate(draw));
}

TEST(Certificate, PartsOfTrianglesAreLeftOut) {
  const auto vertices = testing::vertex_streams({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(certificate(*vertices, {0, 1, 2, 0, 1}), certificate(*vertices, {0, 1, 2}));
  EXPECT_EQ(certificate(*vertices, {}), Certificate{});
}

TEST(Certificate, OneForEachOrderOfEachLevel) {
  Draw draw = testing::draw_of(testing::grid(2, 2));
  draw.levels[0].orders.push_back(with_triangle_order(draw.levels[0].orders[0], Numbers{7, 6, 5, 4, 3, 2, 1, 0}));
  Level coarse = draw.levels[0];
  coarse.orders = {{.indices = Shared<std::uint32_t>(Numbers{0, 2, 6})}};
  draw.levels.push_back(coarse);
  Analyses analyses;
  const std::vector<Certificate> all = certificates_of(draw, analyses);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[2].triangles, 1u);
  EXPECT_EQ(analyses.size(), 1u) << "the vertices are read once";
}

}  // namespace
}  // namespace foredraw::certificate_test
