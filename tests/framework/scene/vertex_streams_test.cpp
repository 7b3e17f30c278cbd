#include <foredraw/scene/vertex_streams.h>

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::vertex_streams_test {
namespace {

/// A stream of one-component elements.
template <class T>
VertexStream stream_of(Component component, bool normalized, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span<const T>(values));
  return {"A", {component, 1, normalized, sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

template <class T>
std::vector<float> decoded(Component component, bool normalized, const std::vector<T>& values) {
  const VertexStream stream = stream_of(component, normalized, values);
  std::vector<float> floats;
  for (std::size_t i = 0; i < stream.count(); ++i) floats.push_back(decode_component(stream, i, 0));
  return floats;
}

using Floats = std::vector<float>;

TEST(DecodeComponent, IntegersAsTheyAre) {
  EXPECT_EQ(decoded<std::int8_t>(Component::int8, false, {-128, -1, 0, 127}), (Floats{-128, -1, 0, 127}));
  EXPECT_EQ(decoded<std::uint8_t>(Component::uint8, false, {0, 128, 255}), (Floats{0, 128, 255}));
  EXPECT_EQ(decoded<std::int16_t>(Component::int16, false, {-32768, 0, 32767}), (Floats{-32768, 0, 32767}));
  EXPECT_EQ(decoded<std::uint16_t>(Component::uint16, false, {0, 40000, 65535}), (Floats{0, 40000, 65535}));
  EXPECT_EQ(decoded<std::uint32_t>(Component::uint32, false, {0, 1u << 31}), (Floats{0, 2147483648.f}));
}

TEST(DecodeComponent, FloatsBitForBit) {
  const Floats values = {-0.0f, 1e-42f, 3.25f, std::numeric_limits<float>::infinity()};
  const Floats same = decoded(Component::float32, false, values);
  EXPECT_EQ(std::memcmp(same.data(), values.data(), sizeof(float) * values.size()), 0);
  EXPECT_EQ(decoded(Component::float32, true, values), values) << "normalized says nothing of floats";
}

TEST(DecodeComponent, UnsignedNormalizedFromZeroToOne) {
  EXPECT_EQ(decoded<std::uint8_t>(Component::uint8, true, {0, 51, 255}), (Floats{0, 51 / 255.f, 1}));
  EXPECT_EQ(decoded<std::uint16_t>(Component::uint16, true, {0, 13107, 65535}), (Floats{0, 13107 / 65535.f, 1}));
}

// glTF 2.0, section 3.11: max(c / 127, -1), so that the least integer and the one above it are both -1.
TEST(DecodeComponent, SignedNormalizedFromMinusOneToOne) {
  EXPECT_EQ(decoded<std::int8_t>(Component::int8, true, {-128, -127, -126, 0, 127}),
            (Floats{-1, -1, -126 / 127.f, 0, 1}));
  EXPECT_EQ(decoded<std::int16_t>(Component::int16, true, {-32768, -32767, -32766, 0, 32767}),
            (Floats{-1, -1, -32766 / 32767.f, 0, 1}));
}

TEST(DecodeComponent, FindsElementAndComponentOverPadding) {
  // Three bytes, padded to four.
  const std::vector<std::uint8_t> bytes = {1, 2, 3, 99, 4, 5, 6, 99};
  const auto raw = std::as_bytes(std::span(bytes));
  const VertexStream stream{"A", {Component::uint8, 3, false, 4}, Shared<std::byte>({raw.begin(), raw.end()})};
  ASSERT_EQ(stream.count(), 2u);
  EXPECT_EQ(decode_component(stream, 0, 2), 3);
  EXPECT_EQ(decode_component(stream, 1, 0), 4);
  EXPECT_EQ(decode_vec3(stream), (std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(DecodeVec3, MissingComponentsAreZeroAndFurtherOnesLeftOut) {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
  const auto raw = std::as_bytes(std::span(values));
  VertexStream stream{"A", {Component::float32, 2, false, 8}, Shared<std::byte>({raw.begin(), raw.end()})};
  EXPECT_EQ(decode_vec3(stream), (std::vector<glm::vec3>{{1, 2, 0}, {3, 4, 0}, {5, 6, 0}, {7, 8, 0}}));
  stream.format = {Component::float32, 4, false, 16};
  EXPECT_EQ(decode_vec3(stream), (std::vector<glm::vec3>{{1, 2, 3}, {5, 6, 7}}));
}

TEST(BytesOf, EveryComponent) {
  EXPECT_EQ(bytes_of(Component::int8), 1u);
  EXPECT_EQ(bytes_of(Component::uint8), 1u);
  EXPECT_EQ(bytes_of(Component::int16), 2u);
  EXPECT_EQ(bytes_of(Component::uint16), 2u);
  EXPECT_EQ(bytes_of(Component::uint32), 4u);
  EXPECT_EQ(bytes_of(Component::float32), 4u);
}

VertexStreams two_streams() {
  VertexStreams streams;
  streams.count = 2;
  streams.base = {stream_of<std::uint8_t>(Component::uint8, false, {1, 2}),
                  stream_of<std::uint16_t>(Component::uint16, true, {3, 4})};
  streams.base[1].semantic = "B";
  streams.morph_targets = {{stream_of<float>(Component::float32, false, {5, 6})}};
  return streams;
}

TEST(VertexStreams, FindLooksInTheBase) {
  const VertexStreams streams = two_streams();
  EXPECT_EQ(streams.find("B"), &streams.base[1]);
  EXPECT_EQ(streams.find("A"), &streams.base[0]);
  EXPECT_EQ(streams.find("C"), nullptr);
}

TEST(VertexStreams, AllAreTheBaseThenTheMorphTargets) {
  const VertexStreams streams = two_streams();
  EXPECT_EQ(streams.all(),
            (std::vector<const VertexStream*>{&streams.base[0], &streams.base[1], &streams.morph_targets[0][0]}));
  EXPECT_EQ(streams.bytes_per_vertex(), 3u);
}

TEST(VertexStreams, StampIsOfContentFormatNamePlaceAndCount) {
  const VertexStreams streams = two_streams();
  EXPECT_EQ(streams.stamp(), two_streams().stamp());

  std::vector<VertexStreams> others(8, streams);
  others[0].base[0] = stream_of<std::uint8_t>(Component::uint8, false, {1, 3});
  others[1].base[0].semantic = "C";
  others[2].base[1].format.normalized = false;
  others[3].base[0].format.component = Component::int8;
  std::swap(others[4].base[0], others[4].base[1]);
  others[5].base.push_back(others[5].morph_targets[0][0]);  // the same streams in turn, but none of them morphs
  others[5].morph_targets.clear();
  others[6].morph_targets[0] = {stream_of<float>(Component::float32, false, {5, 7})};
  others[7].count = 3;
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_NE(others[i].stamp(), streams.stamp()) << "change " << i;
}

TEST(VertexStreams, StampTellsMorphTargetsApart) {
  VertexStreams one = two_streams();
  one.morph_targets = {{one.base[0], one.base[1]}};
  VertexStreams two = two_streams();
  two.morph_targets = {{two.base[0]}, {two.base[1]}};
  EXPECT_NE(one.stamp(), two.stamp());
}

}  // namespace
}  // namespace foredraw::vertex_streams_test
