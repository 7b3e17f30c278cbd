#include <foredraw/collapses/level_vertices.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace foredraw::level_vertices_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

template <class T>
VertexStream stream(std::string semantic, Component component, std::uint8_t components, bool normalized,
                    const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {std::move(semantic),
          {component, components, normalized, static_cast<std::uint16_t>(components * sizeof(T))},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

VertexStream floats(std::string semantic, std::uint8_t components, const std::vector<float>& values) {
  return stream(std::move(semantic), Component::float32, components, false, values);
}

using Targets = std::vector<std::vector<VertexStream>>;

/// Three of the four corners of a square, which are vertices 0 to 2; vertex 3 is the fourth one.
Draw square(std::vector<VertexStream> more, Targets targets = {}) {
  Draw draw = testing::draw_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 2, 1, 3}});
  auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
  for (VertexStream& one : more) vertices->base.push_back(std::move(one));
  vertices->morph_targets = std::move(targets);
  draw.full().vertices = std::move(vertices);
  return draw;
}

/// Two triangles that lie elsewhere but for one corner, which is vertex 1 of the square and vertex 0 here.
Draw beside(std::vector<VertexStream> more, Targets targets = {}) {
  Draw draw = square(std::move(more), std::move(targets));
  auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
  vertices->base[0] = floats("POSITION", 3, {1, 0, 0, 2, 0, 0, 3, 1, 0, 3, 2, 0});
  draw.full().vertices = std::move(vertices);
  return draw;
}

/// Vertex 0 of the first draw has gone to vertex 1, which has so much of it.
class LevelVerticesTest : public ::testing::Test {
 protected:
  void blend(std::vector<Draw> draws, float share) {
    Analyses analyses;
    std::vector<DrawId> all;
    for (DrawId id = 0; id < draws.size(); ++id) all.push_back(id);
    const JoinedMesh mesh = joined_mesh(testing::scene_of(std::move(draws)), all, analyses).value();
    const CollapseSequence sequence{
        .collapses = {{0, 1, share, 0}}, .pairs = {{0, 1}}, .first_pair = {0, 1}, .places = {1, 0, 0}};
    levels_ = level_vertices(sequence, 1, collapsed(sequence, 1, mesh.positions, mesh.indices), mesh);
  }

  /// Of the vertex that both became.
  std::vector<float> values(const VertexStream& of, std::size_t draw = 0) const {
    std::vector<float> found;
    for (std::size_t c = 0; c < of.format.components; ++c) {
      found.push_back(decode_component(of, levels_[draw].number[draw == 0 ? 1 : 0], c));
    }
    return found;
  }
  std::vector<float> values(std::string_view semantic) const { return values(*levels_[0].vertices->find(semantic)); }

  /// The joints of all sets, and their weights; of those that count.
  std::map<int, float> skin() const {
    std::map<int, float> weights;
    for (int set = 0; levels_[0].vertices->find("JOINTS_" + std::to_string(set)) != nullptr; ++set) {
      const auto joints = values("JOINTS_" + std::to_string(set)), shares = values("WEIGHTS_" + std::to_string(set));
      for (std::size_t c = 0; c < 4; ++c) {
        if (shares[c] > 0) weights[static_cast<int>(joints[c])] += shares[c];
      }
    }
    return weights;
  }

  std::vector<LevelVertices> levels_;
};

/// Eight joints a vertex; four of the two vertices' are the same.
std::vector<VertexStream> two_sets() {
  return {
      stream<std::uint8_t>("JOINTS_0", Component::uint8, 4, false, {1, 2, 3, 4, 3, 4, 9, 10, 0, 0, 0, 0, 0, 0, 0, 0}),
      floats("WEIGHTS_0", 4, {.3f, .2f, .1f, .1f, .2f, .2f, .2f, .1f, 1, 0, 0, 0, 1, 0, 0, 0}),
      stream<std::uint8_t>("JOINTS_1", Component::uint8, 4, false, {5, 6, 7, 8, 5, 6, 11, 12, 0, 0, 0, 0, 0, 0, 0, 0}),
      floats("WEIGHTS_1", 4, {.1f, .1f, .05f, .05f, .1f, .1f, .05f, .05f, 0, 0, 0, 0, 0, 0, 0, 0})};
}

TEST_F(LevelVerticesTest, TheLargestOfAllJointsStay) {
  blend({square(two_sets())}, 0.5f);
  const std::map<int, float> blended = skin();
  // .15 each of 3, 4 and 1; .1 each of 2, 5, 6 and 9; then 10, .05. What is less than that goes.
  const float kept = 3 * .15f + 4 * .1f + .05f;
  ASSERT_EQ(blended.size(), 8u);
  for (const int joint : {1, 3, 4}) EXPECT_FLOAT_EQ(blended.at(joint), .15f / kept) << joint;
  for (const int joint : {2, 5, 6, 9}) EXPECT_FLOAT_EQ(blended.at(joint), .1f / kept) << joint;
  EXPECT_FLOAT_EQ(blended.at(10), .05f / kept);
  std::vector<float> shares = values("WEIGHTS_0");
  for (const float share : values("WEIGHTS_1")) shares.push_back(share);
  EXPECT_TRUE(std::ranges::is_sorted(shares, std::greater<>())) << "the largest ones come first, over both sets";
}

/// Weights of 8 or 16 bits: what rounding takes away is not lost, and where it is half of one in each set neither.
TEST_F(LevelVerticesTest, RoundedWeightsOfAllSetsSumUpToOne) {
  const auto sets = [](auto whole, Component component, std::size_t count) {
    using T = decltype(whole);
    std::vector<VertexStream> more;
    for (std::size_t s = 0; s < count; ++s) {
      std::vector<std::uint8_t> joints;
      for (std::size_t c = 0; c < 16; ++c) joints.push_back(static_cast<std::uint8_t>(4 * s + c % 4));
      more.push_back(stream("JOINTS_" + std::to_string(s), Component::uint8, 4, false, joints));
      more.push_back(stream("WEIGHTS_" + std::to_string(s), component, 4, true, std::vector<T>(16, whole)));
    }
    return more;
  };
  for (const std::size_t count : {1, 2, 5}) {
    for (const int weight : {1, 7, 31}) {  // all alike: each becomes the same share of 1
      blend({square(sets(static_cast<std::uint8_t>(weight), Component::uint8, count))}, 0.5f);
      double sum = 0;
      for (const auto& [joint, share] : skin()) sum += share;
      EXPECT_NEAR(255 * sum, 255, 1e-3) << count << " sets of " << weight;
      EXPECT_EQ(skin().size(), 4 * count);
      blend({square(sets(static_cast<std::uint16_t>(weight), Component::uint16, count))}, 0.5f);
      sum = 0;
      for (const auto& [joint, share] : skin()) sum += share;
      EXPECT_NEAR(65535 * sum, 65535, 1e-2) << count << " sets of " << weight;
    }
  }
}

/// Weights that are no numbers count as none, joints that are none as the first.
TEST_F(LevelVerticesTest, JointsMayBeNoNumbers) {
  blend({square({floats("JOINTS_0", 4, {nan, -5, 1e20f, infinity, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}),
                 floats("WEIGHTS_0", 4, {.5f, nan, infinity, .5f, 3e38f, 3e38f, 3e38f, -1, 1, 0, 0, 0, 1, 0, 0, 0})})},
        0.5f);
  float sum = 0;
  for (const auto& [joint, share] : skin()) {
    EXPECT_TRUE(joint == 0 || joint == 3) << joint;
    sum += share;
  }
  EXPECT_FLOAT_EQ(sum, 1);
}

TEST_F(LevelVerticesTest, OppositeDirectionsAreTheNearerOne) {
  const float third = 1 / std::sqrt(3.0f);
  const std::vector<std::vector<float>> directions{{1, 0, 0}, {0.6f, -0.8f, 0}, {third, third, third}};
  for (const std::vector<float>& d : directions) {
    for (const float share : {0.5f, 0.25f, 0.75f}) {
      const float off = std::nextafter(d[0], 2.0f);  // what is opposite but for rounding
      blend({square({floats("NORMAL", 3, {-off, -d[1], -d[2], d[0], d[1], d[2], 0, 0, 1, 0, 0, 1}),
                     floats("TANGENT", 4, {-d[0], -d[1], -d[2], 1, d[0], d[1], d[2], -1, 1, 0, 0, 1, 1, 0, 0, 1})})},
            share);
      const float sign = share > 0.5f ? -1.0f : 1.0f;
      for (const char* semantic : {"NORMAL", "TANGENT"}) {
        const std::vector<float> blended = values(semantic);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(blended[c], sign * d[c], 1e-6f) << semantic << share;
      }
      EXPECT_EQ(std::abs(values("TANGENT")[3]), 1);
    }
  }
}

TEST_F(LevelVerticesTest, DirectionsOfNoLengthAreFilledIn) {
  blend({square({floats("NORMAL", 3, {0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1})})}, 0.125f);
  EXPECT_EQ(values("NORMAL"), (std::vector<float>{0, 0, 1}));
  blend({square({floats("NORMAL", 3, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1})})}, 0.5f);
  EXPECT_EQ(values("NORMAL"), (std::vector<float>{0, 0, 0}));  // nobody knows a better one
}

/// Between numbers and what is none lies nothing: the nearer vertex's stand, whole directions together.
TEST_F(LevelVerticesTest, WhatIsNoNumberIsNotBlended) {
  const std::vector<float> odd{nan, infinity, -infinity, nan};
  for (const float value : odd) {
    const Draw draw = square({floats("TEXCOORD_0", 2, {value, 4, 8, 8, 0, 0, 0, 0}),
                              floats("NORMAL", 3, {value, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 1}),
                              floats("COLOR_0", 3, {3e38f, 0, 0, -3e38f, 0, 0, 0, 0, 0, 0, 0, 0})});
    blend({draw}, 0.25f);
    EXPECT_EQ(values("TEXCOORD_0"), (std::vector<float>{8, 7}));
    EXPECT_EQ(values("NORMAL"), (std::vector<float>{0, 1, 0}));
    EXPECT_EQ(values("COLOR_0")[0], -3e38f);
    blend({draw}, 0.75f);
    EXPECT_FALSE(std::isfinite(values("TEXCOORD_0")[0]));
    EXPECT_EQ(values("TEXCOORD_0")[1], 5);
    EXPECT_EQ(values("NORMAL"), (std::vector<float>{0, 1, 0})) << "which is the only one that points somewhere";
    EXPECT_EQ(values("COLOR_0")[0], 3e38f);
  }
}

/// A target of floats that are none moves a vertex of a draw whose targets are whole numbers.
TEST_F(LevelVerticesTest, WholeNumbersHoldNone) {
  const auto whole = [](bool normalized) {
    const std::vector<std::int16_t> moves{4, 4, 4, 8, 8, 8, 0, 0, 0, 0, 0, 0};
    return Targets{{stream("POSITION", Component::int16, 3, normalized, moves)}};
  };
  for (const bool normalized : {false, true}) {
    const auto after = [&](float x, float share) {
      blend({square({}, {{floats("POSITION", 3, {x, 16, -3e38f, 0, 0, 0, 0, 0, 0, 0, 0, 0})}}),
             beside({}, whole(normalized))},
            share);
      const VertexStream& moves = levels_[1].vertices->morph_targets[0][0];
      std::vector<int> stored;
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = decode_component(moves, levels_[1].number[0], c);
        stored.push_back(static_cast<int>(std::lround(normalized ? 32767 * value : value)));
      }
      return stored;
    };
    for (const float odd : {nan, infinity, -infinity}) {
      EXPECT_EQ(after(odd, 0.25f)[0], 4) << "the nearer one's is a number";
      const int most = odd > 0 ? 32767 : odd < 0 ? (normalized ? -32767 : -32768) : 0;
      EXPECT_EQ(after(odd, 0.75f)[0], most) << odd;
    }
    EXPECT_EQ(after(0, 0.75f)[2], normalized ? -32767 : -32768);
  }
}

/// Draws of one mesh whose targets do not carry the same.
TEST_F(LevelVerticesTest, TargetsAreMatchedByTheirNumber) {
  const VertexStream normals = floats("NORMAL", 3, std::vector<float>(12, 0));
  const VertexStream moves = floats("POSITION", 3, {8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const VertexStream still = floats("POSITION", 3, std::vector<float>(12, 0));
  blend({square({}, {{normals}, {moves}}), beside({}, {{still}, {normals, still}})}, 0.5f);
  EXPECT_EQ(values(levels_[0].vertices->morph_targets[1][0])[0], 4);
  EXPECT_EQ(values(levels_[1].vertices->morph_targets[0][0], 1)[0], 0) << "the other draw's first one has no moves";
  EXPECT_EQ(values(levels_[1].vertices->morph_targets[1][1], 1)[0], 4);
}

}  // namespace
}  // namespace foredraw::level_vertices_test
