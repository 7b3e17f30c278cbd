// Packing and unpacking many vertices at once, and what layouts promise of each.
#include "plugins/processors/vertex_pack/vertex_pack.h"

#include "support/packed_vertices.h"
#include "support/vector_widths.h"

#include <foredraw/packing/packed_precision.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace foredraw::vertex_pack_test {
namespace {

using testing::degrees_between;
using testing::FloatVertices;
using testing::unit_layout;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

std::vector<std::uint32_t> packed(const PackedLayout& layout, const FloatVertices& vertices) {
  std::vector<std::uint32_t> rows(4 * vertices.positions.size());
  EXPECT_EQ(pack_vertices(layout, vertices.plain(), rows), 0u);
  return rows;
}

FloatVertices unpacked(const PackedLayout& layout, const std::vector<std::uint32_t>& rows) {
  FloatVertices vertices(rows.size() / 4);
  unpack_vertices(layout, rows, vertices.unpacked());
  return vertices;
}

/// One by one, with the header.
FloatVertices unpacked_in_c(const PackedLayout& layout, const std::vector<std::uint32_t>& rows) {
  FloatVertices all(rows.size() / 4);
  for (std::size_t v = 0; v < all.uvs.size(); ++v) {
    foredraw_packed_vertex vertex;
    foredraw_packed_decode(&layout, &rows[4 * v], &vertex);
    std::memcpy(&all.positions[v], vertex.position, 12);
    std::memcpy(&all.normals[v], vertex.normal, 12);
    std::memcpy(&all.tangents[v], vertex.tangent, 16);
    std::memcpy(&all.uvs[v], vertex.uv, 8);
  }
  return all;
}

void expect_same(const FloatVertices& a, const FloatVertices& b) {
  EXPECT_TRUE(same_bits(a.positions, b.positions));
  EXPECT_TRUE(same_bits(a.normals, b.normals));
  EXPECT_TRUE(same_bits(a.tangents, b.tangents));
  EXPECT_TRUE(same_bits(a.uvs, b.uvs));
}

class PackedBits : public ::testing::TestWithParam<bool> {};

TEST_P(PackedBits, AreThoseOfTheHeaderAtEveryWidthOfRegisters) {
  const PackedLayout layout = unit_layout(GetParam());
  ASSERT_TRUE(foredraw_packed_is_layout(&layout));
  for (const std::size_t count : {1u, 7u, 8u, 9u, 100003u}) {
    const FloatVertices vertices = FloatVertices::random(count, count);
    std::vector<std::uint32_t> wanted(4 * count), noise(4 * count);
    Random random(3);
    for (std::size_t v = 0; v < count; ++v) {
      const foredraw_packed_vertex vertex = vertices.vertex(v);
      EXPECT_EQ(foredraw_packed_encode(&layout, &vertex, &wanted[4 * v]), 0u);
      for (std::size_t i = 0; i < 4; ++i) noise[4 * v + i] = static_cast<std::uint32_t>(random.next());
    }
    testing::at_every_width([&] {
      EXPECT_EQ(packed(layout, vertices), wanted);
      expect_same(unpacked(layout, wanted), unpacked_in_c(layout, wanted));
      expect_same(unpacked(layout, noise), unpacked_in_c(layout, noise));
    });
  }
}

TEST_P(PackedBits, SayWhatTheyDoNotHoldAsTheHeaderDoes) {
  const PackedLayout layout = unit_layout(GetParam());
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const glm::vec3 odd[] = {{nan, 0.5f, 0.5f},     {infinite, 0, 0}, {-infinite, 1, 1}, {1e30f, 0, 0}, {0, -1e-3f, 0},
                           {0, 0, 1.001f},        {0, 0, 0},        {1e-20f, 0, 0},    {1e20f, 0, 0}, {0, 0, -0.0f},
                           {0.5f, 0.25f, -1e-30f}};
  testing::at_every_width([&] {
    for (const glm::vec3& one : odd) {
      for (std::size_t which = 0; which < 4; ++which) {
        FloatVertices vertices = FloatVertices::random(13, 5);
        if (which == 0) vertices.positions[11] = one;
        if (which == 1) vertices.normals[11] = one;
        if (which == 2) vertices.tangents[11] = {one, 0};
        if (which == 3) vertices.uvs[11] = one;
        std::vector<std::uint32_t> rows(52), wanted(52);
        std::uint32_t told = 0;
        for (std::size_t v = 0; v < 13; ++v) {
          const foredraw_packed_vertex vertex = vertices.vertex(v);
          told |= foredraw_packed_encode(&layout, &vertex, &wanted[4 * v]);
        }
        EXPECT_EQ(pack_vertices(layout, vertices.plain(), rows), told) << which << ' ' << one.x << ' ' << one.z;
        EXPECT_EQ(rows, wanted);
      }
    }
  });
}

TEST_P(PackedBits, OfWhatIsNotThereAre0) {
  const PackedLayout layout = unit_layout(GetParam());
  const FloatVertices vertices = FloatVertices::random(21, 2);
  std::vector<std::uint32_t> whole = packed(layout, vertices), some(84);
  EXPECT_EQ(pack_vertices(layout, {.positions = vertices.positions}, some), 0u);
  for (std::size_t v = 0; v < 21; ++v) {
    for (std::uint32_t f = 0; f < FOREDRAW_PACKED_FIELDS; ++f) {
      const std::uint32_t is = foredraw_packed_read(&layout, f, &some[4 * v]);
      EXPECT_EQ(is, f <= FOREDRAW_PACKED_Z ? foredraw_packed_read(&layout, f, &whole[4 * v]) : 0u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(VertexPack, PackedBits, ::testing::Values(false, true),
                         [](const auto& info) { return info.param ? "spherical" : "octahedral"; });

/// All 2^24 of 12 + 12 bits: each decodes to a unit vector, and that to a code of the same vector.
TEST(VertexPack, EveryCodeOfANormalIsTheNearestOneOfWhatItDecodesTo) {
  PackedLayout layout = unit_layout();
  for (const int f : {FOREDRAW_PACKED_NORMAL_0, FOREDRAW_PACKED_NORMAL_1}) layout.field[f].bits = 12;
  layout.field[FOREDRAW_PACKED_NORMAL_0].word = 0;
  layout.field[FOREDRAW_PACKED_NORMAL_1].word = 1;
  layout.field[FOREDRAW_PACKED_NORMAL_0].shift = layout.field[FOREDRAW_PACKED_NORMAL_1].shift = 0;
  constexpr std::uint32_t codes = 4095;  // from 0 to 2^12 - 2
  std::vector<std::uint32_t> rows(std::size_t{4} * codes), again(rows.size());
  std::vector<glm::vec3> normals(codes), back(codes);
  std::size_t aliases = 0, wrong = 0;
  for (std::uint32_t u = 0; u < codes; ++u) {
    for (std::uint32_t v = 0; v < codes; ++v) {
      rows[4 * v] = u;
      rows[4 * v + 1] = v;
    }
    unpack_vertices(layout, rows, {.normals = normals});
    pack_vertices(layout, {.normals = normals}, again);
    unpack_vertices(layout, again, {.normals = back});
    for (std::uint32_t v = 0; v < codes; ++v) {
      wrong += std::abs(glm::dot(normals[v], normals[v]) - 1) > 5e-7f || std::memcmp(&normals[v], &back[v], 12) != 0;
      aliases += rows[4 * v] != again[4 * v] || rows[4 * v + 1] != again[4 * v + 1];
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_LE(aliases, 4u * codes) << "only the square's border has two codes for one vector";
}

/// The largest one found, of random directions and of the worst place: the middle of the middle cell of a face.
double largest_normal_error(const PackedLayout& layout, std::size_t count) {
  FloatVertices vertices = FloatVertices::random(count, 8);
  Random random(9);
  for (std::size_t v = 0; v < count / 2; ++v) {
    const glm::vec3 aside = testing::random_direction(random) * 0.002f;
    vertices.normals[v] = glm::normalize(glm::vec3(v % 2 ? 1 : -1, v % 4 < 2 ? 1 : -1, v % 8 < 4 ? 1 : -1) + aside);
  }
  std::vector<std::uint32_t> rows(4 * count);
  pack_vertices(layout, {.normals = vertices.normals}, rows);
  std::vector<glm::vec3> normals(count);
  unpack_vertices(layout, rows, {.normals = normals});
  double most = 0;
  for (std::size_t v = 0; v < count; ++v) most = std::max(most, degrees_between(vertices.normals[v], normals[v]));
  return most;
}

/// Proved for all bits; and no bound that is not reached.
TEST(VertexPack, TheBoundOfNormalsIsTight) {
  for (std::uint32_t bits = 3; bits <= 16; ++bits) {
    PackedLayout layout = unit_layout();
    layout.field[FOREDRAW_PACKED_NORMAL_0] = {0, 0, bits};
    layout.field[FOREDRAW_PACKED_NORMAL_1] = {1, 0, bits};
    const double bound = packed_bounds(layout).normal, found = largest_normal_error(layout, 200'000);
    EXPECT_LE(found, bound) << bits;
    EXPECT_GT(found, (bits < 5 ? 0.75 : 0.96) * bound) << bits;
  }
}

/// At 12 + 12 bits: the paper's angles are worse, though they have more codes.
TEST(VertexPack, AnOctahedronIsFinerThanTwoAngles) {
  PackedLayout octahedral = unit_layout(), spherical = unit_layout(true);
  for (PackedLayout* layout : {&octahedral, &spherical}) {
    layout->field[FOREDRAW_PACKED_NORMAL_0] = {0, 0, 12};
    layout->field[FOREDRAW_PACKED_NORMAL_1] = {1, 0, 12};
  }
  EXPECT_NEAR(largest_normal_error(octahedral, 300'000), 0.0396, 0.0004);
  const double found = largest_normal_error(spherical, 300'000);
  EXPECT_LE(found, packed_bounds(spherical).normal);
  EXPECT_GT(found, 0.047);
}

/// Beside an own computation, of random vertices: nearest lattice points, angles, and signs.
TEST(VertexPack, NoVertexIsFartherOffThanPromised) {
  for (const bool is_spherical : {false, true}) {
    const PackedLayout layout = unit_layout(is_spherical);
    const FloatVertices vertices = FloatVertices::random(200'000, 1);
    const FloatVertices again = unpacked(layout, packed(layout, vertices));
    const PackedBounds bounds = packed_bounds(layout);
    double tangent = 0, uv = 0, position = 0;
    for (std::size_t v = 0; v < vertices.uvs.size(); ++v) {
      const glm::dvec3 nearest = glm::dvec3(vertices.positions[v]) / static_cast<double>(layout.step);
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(static_cast<double>(again.positions[v][c]),
                  std::nearbyint(nearest[c]) * static_cast<double>(layout.step));
      }
      position = std::max(position, glm::length(glm::dvec3(again.positions[v]) - glm::dvec3(vertices.positions[v])));
      EXPECT_LE(degrees_between(vertices.normals[v], again.normals[v]), bounds.normal);
      tangent = std::max(tangent, degrees_between(glm::vec3(vertices.tangents[v]), glm::vec3(again.tangents[v])));
      EXPECT_EQ(vertices.tangents[v].w, again.tangents[v].w);
      EXPECT_LT(std::abs(glm::dot(glm::vec3(again.tangents[v]), again.normals[v])), 1e-6f);
      uv = std::max(uv, static_cast<double>(std::abs(vertices.uvs[v].x - again.uvs[v].x)));
    }
    EXPECT_LE(position, bounds.position);
    EXPECT_GT(position, 0.95 * bounds.position);
    EXPECT_LE(tangent, bounds.tangent);
    EXPECT_GT(tangent, 0.8 * bounds.tangent);
    EXPECT_LE(uv, bounds.u);
    EXPECT_GT(uv, 0.95 * bounds.u);
  }
}

/// Axes are coded without error: 2^bits - 2 steps put them on the lattice.
TEST(VertexPack, AxesKeepTheirDirectionExactly) {
  const PackedLayout layout = unit_layout();
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      FloatVertices vertices = FloatVertices::random(1, 1);
      vertices.normals[0] = glm::vec3(0);
      vertices.normals[0][axis] = sign;
      vertices.tangents[0] = glm::vec4(0, 0, 0, 1);
      vertices.tangents[0][(axis + 1) % 3] = -sign;
      const FloatVertices again = unpacked(layout, packed(layout, vertices));
      EXPECT_EQ(degrees_between(again.normals[0], vertices.normals[0]), 0);
      EXPECT_EQ(degrees_between(glm::vec3(again.tangents[0]), glm::vec3(vertices.tangents[0])), 0);
    }
  }
}

}  // namespace
}  // namespace foredraw::vertex_pack_test
