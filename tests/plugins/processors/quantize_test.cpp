// Streams rounded: never farther off than asked for, and what cannot be rounded stays.
#include "plugins/processors/quantize/quantize.h"

#include <foredraw/scene/coded_values.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace foredraw::quantize_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class T>
VertexStream stream(std::string name, Component component, std::uint8_t components, const std::vector<T>& values,
                    bool normalized = false) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(name),
          {component, components, normalized, static_cast<std::uint16_t>(components * sizeof(T))},
          Shared<std::byte>(std::vector<std::byte>(bytes.begin(), bytes.end()))};
}

VertexStream floats(std::string name, std::uint8_t components, const std::vector<float>& values) {
  return stream(std::move(name), Component::float32, components, values);
}

VertexStreams of(std::vector<VertexStream> streams) {
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(streams.front().count());
  vertices.base = std::move(streams);
  return vertices;
}

std::vector<float> decoded(const VertexStream& stream) {
  std::vector<float> values;
  for (std::size_t v = 0; v < stream.count(); ++v) {
    for (std::size_t i = 0; i < stream.format.components; ++i) values.push_back(decode_component(stream, v, i));
  }
  return values;
}

const VertexStream& made(const Quantized& quantized, const char* name) { return *quantized.vertices->find(name); }

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Quantize, ALatticeIsAsCoarseAsTheErrorAllows) {
  EXPECT_THAT(lattice_exponents(1, 1), ElementsAre(1));
  EXPECT_THAT(lattice_exponents(.5, 1), ElementsAre(0));
  EXPECT_THAT(lattice_exponents(.49, 1), ElementsAre(-1));
  EXPECT_THAT(lattice_exponents(std::sqrt(3.0), 3), ElementsAre(1, 1, 1));
  EXPECT_THAT(lattice_exponents(std::sqrt(3.0) / 2, 3), ElementsAre(0, 0, 0));
  EXPECT_THAT(lattice_exponents(std::sqrt(6.01) / 2, 3), ElementsAre(0, 1, 0)) << "the diagonal of 1, 2, 1";
  EXPECT_THAT(lattice_exponents(std::sqrt(9.01) / 2, 3), ElementsAre(1, 0, 1)) << "the diagonal of 2, 1, 2";
  EXPECT_THAT(lattice_exponents(1.2, 3), ElementsAre(0, 0, 0));
  EXPECT_THAT(lattice_exponents(1.12, 2), ElementsAre(0, 1));
}

RC_GTEST_PROP(Quantize, NoPositionIsFartherOffThanAskedForOrTold, (std::vector<std::array<std::int16_t, 3>> points)) {
  std::vector<float> values;
  for (const auto& point : points) {
    for (const std::int16_t one : point) values.push_back(static_cast<float>(one) * .0137f);
  }
  RC_PRE(!values.empty());
  for (const double error : {.001, .3, 5.0}) {
    const Quantized quantized = quantize(of({floats("POSITION", 3, values)}), {.position = error});
    const std::vector<float> now = decoded(made(quantized, "POSITION"));
    double farthest = 0;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      double square = 0;
      for (std::size_t k = i; k < i + 3; ++k) square += (double(now[k]) - values[k]) * (double(now[k]) - values[k]);
      farthest = std::max(farthest, std::sqrt(square));
      for (std::size_t k = i; k < i + 3; ++k)
        RC_ASSERT(lattice_of(now[k]).value_or(99) >= std::ranges::min(lattice_exponents(error, 3)));
    }
    RC_ASSERT(farthest <= error);
    RC_ASSERT(quantized.largest.position == farthest);
  }
}

TEST(Quantize, EqualValuesStayEqualAndDyadicOnesStay) {
  const std::vector<float> values{0, .5f, 1, .25f, -.0f, 3, 1.f / 3, 1.f / 3, 1.f / 3, 1.f / 3, 1.f / 3, 1.f / 3};
  const Quantized quantized = quantize(of({floats("POSITION", 3, values)}), {.position = .01});
  const std::vector<float> now = decoded(made(quantized, "POSITION"));
  for (const std::size_t i : {0u, 1u, 2u, 3u, 5u}) EXPECT_EQ(now[i], values[i]);
  EXPECT_FALSE(std::signbit(now[4])) << "a filter knows no -0";
  EXPECT_EQ(now[6], now[9]);
}

TEST(Quantize, DirectionsTakeAsFewBitsAsTheirErrorAllows) {
  std::vector<float> values;
  for (int i = 0; i < 1000; ++i) {
    const double z = std::fmod(i * .618033988, 2) - 1, angle = i * 2.39996323;
    for (const double one : {std::cos(angle) * std::sqrt(1 - z * z), std::sin(angle) * std::sqrt(1 - z * z), z}) {
      values.push_back(static_cast<float>(one) * (i % 3 == 0 ? 5.f : 1.f));
    }
  }
  double before = 90;
  for (const double degrees : {10.0, 1.0, .1, .01}) {
    const Quantized quantized = quantize(of({floats("NORMAL", 3, values)}), {.direction = degrees});
    EXPECT_LE(quantized.largest.direction, degrees * 1.000001);
    EXPECT_LT(quantized.largest.direction, before);
    EXPECT_GT(quantized.largest.direction, degrees / 4) << "bits to spare";
    EXPECT_EQ(made(quantized, "NORMAL").format.component, degrees < .8 ? Component::int16 : Component::int8);
    EXPECT_TRUE(made(quantized, "NORMAL").format.normalized);
    before = quantized.largest.direction;
  }
  const Quantized too_fine = quantize(of({floats("NORMAL", 3, values)}), {.direction = .0001});
  EXPECT_EQ(made(too_fine, "NORMAL").format.component, Component::float32);
  ASSERT_EQ(too_fine.plain.size(), 1u);
  EXPECT_THAT(too_fine.plain[0], HasSubstr("NORMAL"));
}

TEST(Quantize, TangentsKeepTheirSideAndDirectionsOfNoLengthPointUp) {
  const Quantized quantized =
      quantize(of({floats("TANGENT", 4, {1, 0, 0, -1, 0, 1, 0, 1, 0, 0, 0, 1})}), {.direction = 1});
  EXPECT_THAT(decoded(made(quantized, "TANGENT")), ElementsAre(1, 0, 0, -1, 0, 1, 0, 1, 0, 0, 1, 1));
}

TEST(Quantize, TextureCoordinatesMayTile) {
  const Quantized quantized =
      quantize(of({floats("TEXCOORD_1", 2, {0, 1, .5f, -3.3f, 999.7f, .12345f})}), {.uv = .5 / 4096});
  const std::vector<float> now = decoded(made(quantized, "TEXCOORD_1"));
  EXPECT_EQ(now[1], 1);
  EXPECT_NEAR(now[3], -3.3f, .5 / 4096);
  EXPECT_NEAR(now[4], 999.7f, .5 / 4096);
}

TEST(Quantize, ColoursTakeAsFewBitsAsWillDoAndBrightOnesStayFloats) {
  const auto component = [](const VertexStream& colours, double error) {
    return made(quantize(of({colours}), {.color = error}), "COLOR_0").format.component;
  };
  const VertexStream usual = floats("COLOR_0", 3, {0, .5f, 1, .2f, .3f, .4f});
  EXPECT_EQ(component(usual, .002), Component::uint8);
  EXPECT_EQ(component(usual, .0001), Component::uint16);
  EXPECT_EQ(component(usual, 1e-7), Component::float32);
  EXPECT_EQ(component(floats("COLOR_0", 3, {0, .5f, 7.3f}), .002), Component::float32);
  const std::vector<std::uint16_t> wide{0, 257 * 3, 65535, 257 * 9};
  EXPECT_EQ(component(stream("COLOR_0", Component::uint16, 4, wide, true), .002), Component::uint8);
  const std::vector<std::uint16_t> fine{1, 2, 3, 4};
  EXPECT_EQ(component(stream("COLOR_0", Component::uint16, 4, fine, true), 1e-6), Component::uint16);
}

TEST(Quantize, WeightsSumUpToWhatTheyDidAndJointsWithoutWeightAreTheFirst) {
  const VertexStream joints =
      stream<std::uint16_t>("JOINTS_0", Component::uint16, 4, {3, 7, 9, 300, 1, 2, 3, 4, 5, 6, 0, 0});
  const VertexStream weights =
      floats("WEIGHTS_0", 4, {1.f / 3, 1.f / 3, 1.f / 3, 0, .25f, .25f, .25f, .25f, .5f, .1f, 0, 0});
  const Quantized quantized = quantize(of({joints, weights}), {.weight = .004});
  const auto whole = made(quantized, "WEIGHTS_0").bytes.view();
  ASSERT_EQ(whole.size(), 12u);
  const auto sum = [&](std::size_t v) {
    int all = 0;
    for (std::size_t i = 0; i < 4; ++i) all += std::to_integer<int>(whole[4 * v + i]);
    return all;
  };
  EXPECT_EQ(sum(0), 255);
  EXPECT_EQ(sum(1), 255);
  EXPECT_EQ(sum(2), 153) << "of .6";
  EXPECT_EQ(made(quantized, "JOINTS_0").format.component, Component::uint8);
  EXPECT_THAT(decoded(made(quantized, "JOINTS_0")), ElementsAre(3, 7, 9, 0, 1, 2, 3, 4, 5, 6, 0, 0));
  EXPECT_LE(quantized.largest.weight, .004);
  EXPECT_EQ(made(quantize(of({joints, weights}), {.weight = .0001}), "WEIGHTS_0").format.component, Component::uint16);
}

TEST(Quantize, OddNumbersStayAndAreTold) {
  const float infinite = std::numeric_limits<float>::infinity();
  VertexStreams odd = of({floats("POSITION", 3, {0, nan, 0}), floats("NORMAL", 3, {infinite, 0, 0}),
                          floats("TEXCOORD_0", 2, {1e30f, 0}), floats("COLOR_0", 3, {nan, 0, 0}),
                          stream<std::uint8_t>("JOINTS_0", Component::uint8, 4, {0, 0, 0, 0}),
                          floats("WEIGHTS_0", 4, {-1, 2, 0, 0}), floats("_MINE", 1, {.123f})});
  const Quantized quantized = quantize(odd, {.position = 1, .direction = 1, .uv = .001, .color = .01, .weight = .01});
  EXPECT_EQ(quantized.vertices->stamp(), odd.stamp());
  EXPECT_EQ(quantized.plain.size(), 5u);
}

TEST(Quantize, DenormalsBecomeZero) {
  const Quantized quantized = quantize(of({floats("POSITION", 3, {1e-40f, -1e-42f, 1})}), {.position = .001});
  EXPECT_THAT(decoded(made(quantized, "POSITION")), ElementsAre(0, 0, 1));
}

TEST(Quantize, NothingIsRoundedWhereNoErrorIsAllowed) {
  const VertexStreams plain = of({floats("POSITION", 3, {.1f, .2f, .3f}), floats("NORMAL", 3, {1, 0, 0})});
  EXPECT_EQ(quantize(plain, {}).vertices->stamp(), plain.stamp());
}

TEST(Quantize, MorphTargetsAreRoundedToo) {
  VertexStreams vertices = of({floats("POSITION", 3, {.1f, .2f, .3f})});
  vertices.morph_targets = {{floats("POSITION", 3, {.013f, 0, 0}), floats("NORMAL", 3, {.1f, 0, 0})}};
  const Quantized quantized = quantize(vertices, {.position = .01, .direction = 1});
  const auto& target = quantized.vertices->morph_targets[0];
  EXPECT_GE(lattice_of(decoded(target[0])[0]), lattice_exponents(.01, 3)[0]);
  EXPECT_NEAR(decoded(target[0])[0], .013, .01);
  EXPECT_NEAR(decoded(target[1])[0], .1, .0175);
  EXPECT_LE(quantized.largest.direction, 1);
}

TEST(Quantize, TwiceIsOnce) {
  VertexStreams vertices = of({floats("POSITION", 3, {.1f, .2f, .3f}), floats("NORMAL", 3, {.6f, .8f, 0}),
                               floats("TEXCOORD_0", 2, {.3f, .7f})});
  const Tolerances tolerances{.position = .01, .direction = 1, .uv = .001};
  const Quantized once = quantize(vertices, tolerances);
  EXPECT_EQ(quantize(*once.vertices, tolerances).vertices->stamp(), once.vertices->stamp());
}

}  // namespace
}  // namespace foredraw::quantize_test
