#include "plugins/processors/progressive_stream/stream_product.h"
#include "support/progressive_streams.h"

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/replay.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace foredraw::progressive_stream_test {
namespace {

using testing::all_chunks;
using ::testing::HasSubstr;
using testing::Reader;
using testing::Sequenced;
using testing::sequenced;
using testing::two_halves;

using Triangle = std::array<std::uint32_t, 3>;
std::multiset<Triangle> triangles_of(std::span<const std::uint32_t> indices) {
  std::multiset<Triangle> all;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    Triangle t{indices[i], indices[i + 1], indices[i + 2]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.insert(t);
  }
  return all;
}

/// In the mesh's numbers.
std::multiset<Triangle> triangles_of(const Reader& reader, const ProgressiveStream& made) {
  std::vector<std::uint32_t> indices;
  for (std::size_t c = 0; c < std::size_t{3} * reader.mesh().triangles; ++c) {
    indices.push_back(made.vertex[reader.mesh().indices[c]]);
  }
  return triangles_of(indices);
}

/// The sequence in which the stream's splits undo collapses, the last one first.
CollapseSequence reordered(const CollapseSequence& sequence, const ProgressiveStream& made) {
  CollapseSequence other;
  float error = 0;
  for (auto c = made.collapse.rbegin(); c != made.collapse.rend(); ++c) {
    other.first_pair.push_back(static_cast<std::uint32_t>(other.pairs.size()));
    other.collapses.push_back(sequence.collapses[*c]);
    other.collapses.back().error = error = std::max(error, other.collapses.back().error);
    for (std::uint32_t i = sequence.first_pair[*c]; i < sequence.first_pair[*c + 1]; ++i) {
      other.pairs.push_back(sequence.pairs[i]);
    }
  }
  other.first_pair.push_back(static_cast<std::uint32_t>(other.pairs.size()));
  return other;
}

class ProgressiveStreams_ : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(All, ProgressiveStreams_, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "Lossless" : "Rounded"; });

TEST_P(ProgressiveStreams_, EndAsFullDetail) {
  for (Scene scene : {testing::scene_of(testing::closed_torus(60, 30)), two_halves()}) {
    const Sequenced of = sequenced(std::move(scene));
    ProgressiveStreamOptions options;
    options.lossless = GetParam();
    const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
    const auto read = StreamMesh::read(made.bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(difference(*read, of.mesh), "");
    EXPECT_EQ(triangles_of(Reader(made.bytes, all_chunks), made), triangles_of(of.mesh.indices));
  }
}

/// Where several vertices become one.
TEST(ProgressiveStream, OfFacetsEndsAsFullDetail) {
  const testing::TestMesh torus = testing::closed_torus(40, 20);
  testing::TestMesh apart;
  std::vector<float> normals;
  for (std::size_t i = 0; i < torus.indices.size(); ++i) {
    apart.positions.push_back(torus.positions[torus.indices[i]]);
    apart.indices.push_back(static_cast<std::uint32_t>(i));
    const float turned = 0.1f * static_cast<float>(i / 3 % 7);
    normals.insert(normals.end(), {std::sin(turned), std::cos(turned), 0});
  }
  Scene scene = testing::scene_of(apart);
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  const auto bytes = std::as_bytes(std::span(normals));
  vertices->base.push_back({"NORMAL", Format{}, Shared<std::byte>({bytes.begin(), bytes.end()})});
  scene.draws[0].full().vertices = std::move(vertices);
  Sequenced of = sequenced(std::move(scene));
  EXPECT_TRUE(of.sequence.collapses.empty());
  of.sequence = quadric_collapse(of.mesh.positions, of.mesh.indices, {.placement = CollapsePlacement::endpoint},
                                 attribute_rows(of.mesh, {}));
  ASSERT_GT(of.sequence.collapses.size(), 500u);
  ASSERT_EQ(replay(of.sequence, of.mesh.positions, of.mesh.indices, of.mesh.part).mistake, "");
  ProgressiveStreamOptions options;
  options.lossless = true;
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
  const auto read = StreamMesh::read(made.bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(difference(*read, of.mesh), "");
  EXPECT_EQ(triangles_of(Reader(made.bytes, all_chunks), made), triangles_of(of.mesh.indices));
}

TEST(ProgressiveStream, KeepsFloatsExactlyIfAsked) {
  const Sequenced of = sequenced(two_halves());
  ProgressiveStreamOptions options;
  options.lossless = true;
  options.position_bits = 8;
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
  const Reader reader(made.bytes, all_chunks);
  ASSERT_TRUE(reader.is_good());
  for (std::uint32_t v = 0; v < made.vertex.size(); ++v) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      EXPECT_EQ(foredraw_stream_value(&reader.stream(), v, k), of.mesh.positions[made.vertex[v]][static_cast<int>(k)]);
    }
  }
}

TEST(ProgressiveStream, RoundsToTheNearest) {
  const Sequenced of = sequenced(two_halves());
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence);
  const Reader reader(made.bytes, all_chunks);
  ASSERT_TRUE(reader.is_good());
  for (std::uint32_t v = 0; v < made.vertex.size(); ++v) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(foredraw_stream_place(&reader.stream(), v, k), of.mesh.positions[made.vertex[v]][static_cast<int>(k)],
                  0.501 * reader.mesh().step);
    }
  }
}

/// Each chunk shows what the sequence shows when its collapses run in the stream's order, and that order is a clean
/// one.
TEST(ProgressiveStream, EachChunkIsALevelOfTheSequence) {
  const Sequenced of = sequenced(two_halves());
  ProgressiveStreamOptions options;
  options.chunk_size = 1024;
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
  const CollapseSequence order = reordered(of.sequence, made);
  EXPECT_EQ(replay(order, of.mesh.positions, of.mesh.indices, of.mesh.part).mistake, "");
  ASSERT_EQ(made.collapse.size(), of.sequence.collapses.size());
  ASSERT_GT(made.splits.size(), 4u);
  float error = std::numeric_limits<float>::infinity();
  for (std::size_t chunk = 1; chunk <= made.splits.size(); ++chunk) {
    const Reader reader(made.bytes, chunk);
    ASSERT_TRUE(reader.is_good());
    const Collapsed level =
        collapsed(order, order.collapses.size() - made.splits[chunk - 1], of.mesh.positions, of.mesh.indices);
    EXPECT_EQ(triangles_of(reader, made), triangles_of(level.indices)) << chunk;
    EXPECT_LE(reader.stream().error, error);
    error = reader.stream().error;
  }
  EXPECT_EQ(error, 0);
}

TEST(ProgressiveStream, EachChunkOfATorusIsATorus) {
  const Sequenced of = sequenced(testing::scene_of(testing::closed_torus(60, 30)));
  ProgressiveStreamOptions options;
  options.chunk_size = 1024;
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
  for (std::size_t chunk = 1; chunk <= made.splits.size(); ++chunk) {
    const Reader reader(made.bytes, chunk);
    testing::TestMesh shown;
    for (std::uint32_t v = 0; v < reader.mesh().vertices; ++v)
      shown.positions.push_back(of.mesh.positions[made.vertex[v]]);
    shown.indices.assign(reader.mesh().indices, reader.mesh().indices + std::size_t{3} * reader.mesh().triangles);
    EXPECT_EQ(testing::euler(shown), 0) << chunk;
    for (const auto& [triangles, edges] : testing::edges(shown)) EXPECT_EQ(triangles, 2) << chunk;
  }
}

TEST(ProgressiveStream, OddMeshesAreStreamed) {
  std::size_t streamed = 0;
  for (const testing::TestMesh& odd : testing::odd_meshes()) {
    const Sequenced of = sequenced(testing::scene_of(odd));
    try {
      const ProgressiveStream made = progressive_stream(of.mesh, of.sequence);
      const auto read = StreamMesh::read(made.bytes);
      ASSERT_TRUE(read);
      EXPECT_EQ(difference(*read, of.mesh), "");
      ++streamed;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("not a finite number"));
    }
  }
  EXPECT_GT(streamed, 5u);
}

TEST(ProgressiveStream, PointsOfManyTrianglesAreStreamed) {
  testing::TestMesh fan{{glm::vec3(0)}, {}};
  constexpr std::uint32_t around = 700;
  for (std::uint32_t i = 0; i < around; ++i) {
    fan.positions.push_back({float(i), float(i * i % 613), float(i * i * i % 59)});
    fan.indices.insert(fan.indices.end(), {0, 1 + i, 1 + (i + 1) % around});
  }
  for (const testing::TestMesh& mesh : {fan, testing::spokes(10'000)}) {
    const Sequenced of = sequenced(testing::scene_of(mesh));
    EXPECT_GT(of.sequence.collapses.size(), mesh.positions.size() / 2);
    const auto read = StreamMesh::read(progressive_stream(of.mesh, of.sequence).bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(difference(*read, of.mesh), "");
  }
}

/// Places at 16 bits and triangles: less than a fifth of what floats and indices of 16 bits take.
TEST(ProgressiveStream, IsSmall) {
  const Sequenced of = sequenced(testing::scene_of(testing::closed_torus(160, 80)));
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence);
  EXPECT_LT(static_cast<double>(made.bytes.size()) / static_cast<double>(of.mesh.positions.size()), 4.0);
}

/// Numbers that are none go to the other side as the bits that they are.
TEST(ProgressiveStream, AttributesNeedNotBeFinite) {
  Scene scene = two_halves();
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  VertexStream& texcoords = vertices->base[1];
  ASSERT_EQ(texcoords.semantic, "TEXCOORD_0");
  std::vector<std::byte> bytes(texcoords.bytes.view().begin(), texcoords.bytes.view().end());
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 0,
                       -std::numeric_limits<float>::infinity()};
  std::memcpy(bytes.data(), odd, sizeof odd);
  texcoords.bytes = Shared<std::byte>(std::move(bytes));
  scene.draws[0].full().vertices = std::move(vertices);
  const Sequenced of = sequenced(std::move(scene));
  const auto read = StreamMesh::read(progressive_stream(of.mesh, of.sequence).bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(difference(*read, of.mesh), "");
}

}  // namespace
}  // namespace foredraw::progressive_stream_test
