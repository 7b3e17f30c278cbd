#include <foredraw/base/random.h>
#include <foredraw/displaced/interpolated.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace foredraw::interpolated_test {
namespace {

template <class T>
VertexStream stream(std::string semantic, Format format, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic), format, Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))};
}

template <class T>
T stored(const VertexStream& of, std::size_t vertex, std::size_t component) {
  T value;
  std::memcpy(&value, of.bytes.view().data() + vertex * of.format.bytes + component * sizeof(T), sizeof(T));
  return value;
}

VertexStream floats(std::string semantic, std::uint8_t components, const std::vector<float>& values) {
  return stream(std::move(semantic),
                {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)}, values);
}

constexpr std::uint32_t third = weight_one / 3;
const std::vector<std::uint32_t> triangle = {0, 1, 2};

/// On the triangle's edges, inside it, and at a corner.
std::vector<SurfaceSample> samples() {
  std::vector<SurfaceSample> samples = {{0, {third, third}}, {0, {weight_one, 0}}, {0, {weight_one / 2, 0}}};
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const auto u = static_cast<std::uint32_t>(random.below(weight_one + 1));
    samples.push_back({0, {u, static_cast<std::uint32_t>(random.below(weight_one + 1 - u))}});
    samples.push_back({0, {u, weight_one - u}});
  }
  return samples;
}

VertexStream interpolated(const VertexStream& one, const std::vector<SurfaceSample>& at) {
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(one.count());
  vertices.base = {one};
  return interpolated(vertices, triangle, at).base[0];
}

TEST(Interpolated, the_vertices_themselves_come_first_as_they_were) {
  VertexStreams vertices;
  vertices.count = 3;
  vertices.base = {
      floats("NORMAL", 3, {5, 0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 1, 2}),
      stream<std::uint16_t>("JOINTS_0", {Component::uint16, 4, false, 8}, {9, 9, 9, 9, 1, 2, 3, 4, 0, 0, 0, 0}),
      floats("WEIGHTS_0", 4, {7, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0})};
  vertices.morph_targets = {{floats("POSITION", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9})}};
  const VertexStreams made = interpolated(vertices, triangle, samples());
  EXPECT_EQ(made.count, 3 + samples().size());
  ASSERT_EQ(made.all().size(), 4u);
  for (std::size_t s = 0; s < 4; ++s) {
    const VertexStream &before = *vertices.all()[s], &after = *made.all()[s];
    EXPECT_EQ(after.semantic, before.semantic);
    EXPECT_EQ(after.format, before.format);
    EXPECT_EQ(after.count(), made.count);
    EXPECT_EQ(std::memcmp(after.bytes.view().data(), before.bytes.view().data(), before.bytes.size()), 0);
  }
}

TEST(Interpolated, floats_are_what_a_shader_sums_up) {
  Random random(2);
  std::vector<float> values;
  for (int i = 0; i < 9; ++i) values.push_back(static_cast<float>((random.unit() - 0.5) * std::pow(10, i - 3)));
  const VertexStream made = interpolated(floats("POSITION", 3, values), samples());
  for (std::size_t i = 0; i < samples().size(); ++i) {
    const auto [u, v, w] = samples()[i].at.coordinates();
    for (std::size_t c = 0; c < 3; ++c) {
      const volatile float a = u * values[c], b = v * values[3 + c], ab = a + b, rest = w * values[6 + c];
      EXPECT_EQ(stored<float>(made, 3 + i, c), ab + rest);
    }
  }
}

template <class T>
void expect_nearest(Component component, bool normalized) {
  Random random(3);
  std::vector<T> values;
  for (int i = 0; i < 3; ++i) values.push_back(static_cast<T>(random.next()));
  values[2] = std::numeric_limits<T>::min();
  const std::uint16_t size = sizeof(T);
  const VertexStream made = interpolated(stream("COLOR_0", {component, 1, normalized, size}, values), samples());
  for (std::size_t i = 0; i < samples().size(); ++i) {
    long double sum = 0;  // exact
    for (std::size_t c = 0; c < 3; ++c) {
      long double value = values[c];
      if (normalized && std::is_signed_v<T>)
        value = std::max<long double>(value, -static_cast<long double>(std::numeric_limits<T>::max()));
      sum += static_cast<long double>(samples()[i].at.weights()[c]) * value / weight_one;
    }
    const T expected = static_cast<T>(std::round(sum));
    if (samples()[i].at.u == weight_one) continue;  // the corner's own code, or the other one for -1
    EXPECT_EQ(stored<T>(made, 3 + i, 0), expected) << i;
  }
}

TEST(Interpolated, whole_numbers_are_the_nearest_ones) {
  for (const bool normalized : {false, true}) {
    expect_nearest<std::int8_t>(Component::int8, normalized);
    expect_nearest<std::uint8_t>(Component::uint8, normalized);
    expect_nearest<std::int16_t>(Component::int16, normalized);
    expect_nearest<std::uint16_t>(Component::uint16, normalized);
    expect_nearest<std::uint32_t>(Component::uint32, normalized);
  }
  const std::vector<std::int16_t> odd = {1, 0, -1};
  const VertexStream halves = interpolated(stream("POSITION", {Component::int16, 1, false, 2}, odd),
                                           {{0, {weight_one / 2, weight_one / 2}}, {0, {0, weight_one / 2}}});
  EXPECT_EQ(stored<std::int16_t>(halves, 3, 0), 1);
  EXPECT_EQ(stored<std::int16_t>(halves, 4, 0), -1);
}

TEST(Interpolated, an_edge_is_the_same_from_both_ends_and_both_sides) {
  // Two triangles at a seam: vertices 3 and 4 are copies of 1 and 0.
  Random random(4);
  VertexStreams vertices;
  vertices.count = 6;
  std::vector<float> positions(18), normals(18), weights(24);
  std::vector<std::uint8_t> joints(24);
  for (float& value : positions) value = static_cast<float>(random.unit() * 100 - 50);
  for (float& value : normals) value = static_cast<float>(random.unit() - 0.5);
  for (float& value : weights) value = static_cast<float>(random.unit());
  for (std::uint8_t& joint : joints) joint = static_cast<std::uint8_t>(random.below(5));
  const auto copy = [](auto& values, std::ptrdiff_t width) {
    std::copy_n(values.begin() + width, width, values.begin() + 3 * width);
    std::copy_n(values.begin(), width, values.begin() + 4 * width);
  };
  copy(positions, 3);
  copy(normals, 3);
  copy(weights, 4);
  copy(joints, 4);
  vertices.base = {floats("POSITION", 3, positions), floats("NORMAL", 3, normals),
                   stream("JOINTS_0", {Component::uint8, 4, false, 4}, joints), floats("WEIGHTS_0", 4, weights)};
  vertices.morph_targets = {{floats("POSITION", 3, positions)}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4, 5};
  for (const TessellationSpacing spacing :
       {TessellationSpacing::equal, TessellationSpacing::fractional_odd, TessellationSpacing::fractional_even}) {
    for (const float level : {2.0f, 7.3f, 23.9f, 64.0f}) {
      const std::vector<TessellationLevels> levels(2, {{1, 1, level}, 1});
      const TessellatedMesh mesh = tessellated_mesh(indices, 6, levels, spacing);
      const VertexStreams made = interpolated(vertices, indices, mesh.samples);
      std::map<std::uint32_t, std::size_t> first;  // by the weight of the end
      std::size_t pairs = 0;
      for (std::size_t i = 0; i < mesh.samples.size(); ++i) {
        const SurfaceSample& sample = mesh.samples[i];
        if (sample.at.w() != 0 || sample.at.u == 0 || sample.at.v == 0) continue;  // points inside may lie on corners
        const std::uint32_t weight = sample.triangle == 0 ? sample.at.u : sample.at.v;
        const auto [found, is_first] = first.try_emplace(weight, i);
        if (is_first) continue;
        ++pairs;
        for (const VertexStream* stream : made.all()) {
          const std::size_t size = stream->format.bytes;
          const std::byte* bytes = stream->bytes.view().data() + 6 * size;
          EXPECT_EQ(std::memcmp(bytes + i * size, bytes + found->second * size, size), 0) << stream->semantic;
        }
      }
      EXPECT_EQ(pairs, EdgeDivision(effective_level(level, spacing), spacing).parts() - 1);
    }
  }
}

TEST(Interpolated, directions_keep_their_length) {
  const std::vector<float> tangents = {1, 0, 0, -1, 0, 1, 0, -1, 0, 0, 1, 1};
  const VertexStream made = interpolated(floats("TANGENT", 4, tangents), samples());
  for (std::size_t i = 0; i < samples().size(); ++i) {
    const auto [u, v, w] = samples()[i].at.coordinates();
    const glm::dvec3 expected = glm::normalize(glm::dvec3(u, v, w));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(stored<float>(made, 3 + i, c), expected[static_cast<int>(c)], 1e-7);
    }
    EXPECT_EQ(stored<float>(made, 3 + i, 3), w > u && w > v ? 1 : -1);
  }
  const std::vector<std::int8_t> bytes = {127, 0, 0, 0, 0, 127, 0, 0, 0, 0, -128, 0};
  const VertexStream small =
      interpolated(stream("NORMAL", {Component::int8, 3, true, 4}, bytes), {{0, {third, third}}});
  EXPECT_EQ(stored<std::int8_t>(small, 3, 0), 73);  // 127 / sqrt(3)
  EXPECT_EQ(stored<std::int8_t>(small, 3, 1), 73);
  EXPECT_EQ(stored<std::int8_t>(small, 3, 2), -73);
}

TEST(Interpolated, between_opposite_directions_there_is_the_heavier_one) {
  const std::vector<float> normals = {0.6f, 0.8f, 0, -0.6f, -0.8f, 0, 0, 0, 0};
  const VertexStream made =
      interpolated(floats("NORMAL", 3, normals),
                   {{0, {weight_one / 2, weight_one / 2}}, {0, {weight_one / 4, 3 * weight_one / 4}}, {0, {1, 0}}});
  EXPECT_EQ(stored<float>(made, 3, 1), 0.8f);
  EXPECT_NEAR(stored<float>(made, 4, 1), -0.8f, 1e-7);
  EXPECT_NEAR(stored<float>(made, 5, 1), 0.8f, 1e-7);
  VertexStreams moved;
  moved.count = 3;
  moved.morph_targets = {{floats("NORMAL", 3, normals)}};  // differences
  const VertexStreams mixed = interpolated(moved, triangle, std::vector<SurfaceSample>{{0, {weight_one / 4, 0}}});
  EXPECT_EQ(stored<float>(mixed.morph_targets[0][0], 3, 0), 0.25f * 0.6f);
}

TEST(Interpolated, no_number_does_not_spread) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  const std::vector<SurfaceSample> at = {{0, {weight_one / 2, weight_one / 2}},
                                         {0, {0, weight_one / 4}},
                                         {0, {0, 3 * weight_one / 4}},
                                         {0, {third, third}}};
  const VertexStream made = interpolated(floats("TEXCOORD_0", 1, {1, 3, none}), at);
  EXPECT_EQ(stored<float>(made, 3, 0), 2);  // the third corner has no share
  EXPECT_TRUE(std::isnan(stored<float>(made, 4, 0)));
  EXPECT_EQ(stored<float>(made, 5, 0), 3);
  const VertexStream far = interpolated(floats("TEXCOORD_0", 1, {endless, -endless, 5}), at);
  EXPECT_EQ(stored<float>(far, 3, 0), endless);
  EXPECT_EQ(stored<float>(far, 4, 0), 5);
  EXPECT_EQ(stored<float>(far, 5, 0), -endless);
}

TEST(Interpolated, what_is_no_amount_is_the_heaviest_corners) {
  const std::vector<std::uint16_t> names = {700, 5, 9000};
  const std::vector<SurfaceSample> at = {{0, {40000, 20000}}, {0, {20000, 40000}}, {0, {weight_one / 2, 0}}};
  const VertexStream made = interpolated(stream("_NAME", {Component::uint16, 1, false, 2}, names), at);
  EXPECT_EQ(stored<std::uint16_t>(made, 3, 0), 700);
  EXPECT_EQ(stored<std::uint16_t>(made, 4, 0), 5);
  EXPECT_EQ(stored<std::uint16_t>(made, 5, 0), 700);  // of two, the first vertex's
}

TEST(Interpolated, joints_are_the_largest_influences) {
  VertexStreams vertices;
  vertices.count = 3;
  const std::vector<std::uint8_t> joints = {1, 2, 3, 4, 4, 5, 6, 7, 8, 9, 1, 0};
  const std::vector<float> weights = {0.5f, 0.25f, 0.125f, 0.125f, 0.5f, 0.25f, 0.25f, 0, 0.5f, 0.25f, 0.25f, 0};
  const std::vector<std::uint8_t> bytes = {128, 64, 32, 31, 128, 64, 63, 0, 128, 64, 63, 0};
  const std::vector<SurfaceSample> at = {{0, {weight_one / 2, weight_one / 4}}, {0, {0, weight_one / 2}}};
  const auto base = [&](VertexStream stored_weights) {
    return std::vector{stream("JOINTS_0", {Component::uint8, 4, false, 4}, joints), std::move(stored_weights)};
  };
  vertices.base = base(floats("WEIGHTS_0", 4, weights));
  const VertexStreams made = interpolated(vertices, triangle, at);
  // 1: 1/4 + 1/16, 4: 1/16 + 1/8, 2: 1/8, 8: 1/8, of 3/4 + less
  const float whole = 0.3125f + 0.1875f + 0.125f + 0.125f;
  const std::vector<std::pair<int, float>> expected = {{1, 0.3125f}, {4, 0.1875f}, {2, 0.125f}, {8, 0.125f}};
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(stored<std::uint8_t>(made.base[0], 3, c), expected[c].first);
    EXPECT_FLOAT_EQ(stored<float>(made.base[1], 3, c), expected[c].second / whole);
  }
  // Of equal ones the smaller joints: 4 and 8 have 1/4 each, then 1, 5, 6 and 9 have 1/8.
  const std::vector<int> chosen = {4, 8, 1, 5};
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(stored<std::uint8_t>(made.base[0], 4, c), chosen[c]);

  vertices.base = base(stream("WEIGHTS_0", {Component::uint8, 4, true, 4}, bytes));
  const VertexStreams small = interpolated(vertices, triangle, samples());
  for (std::size_t i = 0; i < samples().size(); ++i) {
    int sum = 0;
    for (std::size_t c = 0; c < 4; ++c) sum += stored<std::uint8_t>(small.base[1], 3 + i, c);
    EXPECT_EQ(sum, 255);
  }
  vertices.base = base(floats("WEIGHTS_0", 4, std::vector<float>(12, 0)));
  const VertexStreams without = interpolated(vertices, triangle, at);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(stored<float>(without.base[1], 4, c), 0);
}

}  // namespace
}  // namespace foredraw::interpolated_test
