#include "plugins/processors/progressive_stream/progressive_stream.h"

#include "plugins/processors/progressive_stream/stream_mesh.h"
#include "plugins/processors/progressive_stream/stream_product.h"
#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/collapses.h"

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/replay.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace foredraw {
namespace {

using ::testing::HasSubstr;

/// Attributes of all kinds, that change from vertex to vertex.
std::shared_ptr<const VertexStreams> with_attributes(const std::vector<glm::vec3>& positions) {
  auto vertices = std::make_shared<VertexStreams>(*testing::vertex_streams(positions));
  std::vector<float> uv, normals;
  std::vector<std::uint8_t> colours;
  for (const glm::vec3& p : positions) {
    uv.insert(uv.end(), {p.x * 3 + p.z, p.y - 7});
    const float length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z + 1);
    normals.insert(normals.end(), {p.x / length, p.y / length, 1 / length});
    for (int k = 0; k < 3; ++k) colours.push_back(static_cast<std::uint8_t>(static_cast<int>(90 * p[k]) & 255));
    colours.push_back(255);
  }
  const auto add = [&](const char* semantic, Format format, const auto& values) {
    const auto bytes = std::as_bytes(std::span(values));
    vertices->base.push_back({semantic, format, Shared<std::byte>({bytes.begin(), bytes.end()})});
  };
  add("TEXCOORD_0", {Component::float32, 2, false, 8}, uv);
  add("NORMAL", {Component::float32, 3, false, 12}, normals);
  add("COLOR_0", {Component::uint8, 4, true, 4}, colours);
  return vertices;
}

struct Sequenced {
  Scene scene;
  std::vector<DrawId> draws;
  JoinedMesh mesh;
  CollapseSequence sequence;
};

/// All draws of the scene as one mesh, and the sequence in which it becomes coarser.
Sequenced sequenced(Scene scene, CollapsePlacement placement = CollapsePlacement::endpoint) {
  Sequenced made{std::move(scene), {}, {}, {}};
  for (DrawId id = 0; id < made.scene.draws.size(); ++id) made.draws.push_back(id);
  Analyses analyses;
  made.mesh = joined_mesh(made.scene, made.draws, analyses).value();
  made.sequence = quadric_collapse(made.mesh.positions, made.mesh.indices, {.placement = placement});
  return made;
}

/// Half a torus with attributes, the other half without, as draws that meet at two rings; the first has a seam.
Scene two_halves() {
  testing::TestMesh torus = testing::closed_torus(48, 24);
  const std::size_t half = torus.indices.size() / 6 * 3, seam = half / 6 * 3;
  testing::TestMesh other{torus.positions,
                          {torus.indices.begin() + static_cast<std::ptrdiff_t>(half), torus.indices.end()}};
  torus.indices.resize(half);
  const std::size_t vertices = torus.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) torus.positions.push_back(glm::vec3(torus.positions[v]));
  for (std::size_t i = seam; i < half; ++i) torus.indices[i] += static_cast<std::uint32_t>(vertices);
  std::vector<Draw> draws{testing::draw_of(torus, "first"), testing::draw_of(other, "second")};
  draws[0].full().vertices = with_attributes(torus.positions);
  // Both sides of the seam have texture coordinates of their own.
  auto seamed = std::make_shared<VertexStreams>(*draws[0].full().vertices);
  std::vector<std::byte> uv(seamed->base[1].bytes.view().begin(), seamed->base[1].bytes.view().end());
  for (std::size_t v = vertices; v < 2 * vertices; ++v) uv[8 * v + 2] ^= std::byte{0x40};
  seamed->base[1].bytes = Shared<std::byte>(std::move(uv));
  draws[0].full().vertices = std::move(seamed);
  return testing::scene_of(std::move(draws));
}

const std::uint8_t* raw(std::span<const std::byte> bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

/// Reads so many chunks of a good stream.
class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::size_t chunks) {
    foredraw_stream_header header;
    is_good_ = foredraw_stream_read_header(raw(bytes), bytes.size(), &header) == 1;
    if (!is_good_) return;
    memory_.resize(foredraw_stream_memory(&header, raw(bytes)) / 4 + 1);
    foredraw_stream_begin(&stream_, &header, raw(bytes), memory_.data());
    std::size_t at = header.bytes, used = 0;
    while (stream_.chunks < chunks && (used = foredraw_stream_take(&stream_, raw(bytes) + at, bytes.size() - at)) > 0) {
      at += used;
    }
    is_good_ = !stream_.damaged;
  }
  bool is_good() const { return is_good_; }
  const foredraw_stream& stream() const { return stream_; }
  const foredraw_split_mesh& mesh() const { return stream_.coding.mesh; }

 private:
  foredraw_stream stream_ = {};
  std::vector<std::uint32_t> memory_;
  bool is_good_ = false;
};

constexpr std::size_t all_chunks = ~std::size_t{0};

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

TEST(ProgressiveStream, CutAnywhereItGivesItsWholeChunks) {
  const Sequenced of = sequenced(testing::scene_of(testing::closed_torus(20, 12)));
  ProgressiveStreamOptions options;
  options.chunk_size = 1024 / 8;
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence, options);
  ASSERT_GT(made.chunk_end.size(), 3u);
  for (std::size_t bytes = 0; bytes < made.bytes.size(); ++bytes) {
    const auto cut = std::span(made.bytes).first(bytes);
    const Reader reader(cut, all_chunks);
    const auto whole =
        static_cast<std::uint32_t>(std::ranges::upper_bound(made.chunk_end, bytes) - made.chunk_end.begin());
    if (whole > 0) {
      EXPECT_TRUE(reader.is_good());
    }
    EXPECT_EQ(reader.stream().chunks, whole) << bytes;
    EXPECT_FALSE(StreamMesh::read(cut)) << bytes;
  }
}

TEST(ProgressiveStream, AChangedByteIsNoticed) {
  const Sequenced of = sequenced(two_halves());
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence);
  for (std::size_t i = 0; i < made.bytes.size(); i += i < 400 ? 1 : 37) {
    std::vector<std::byte> bytes = made.bytes;
    bytes[i] ^= std::byte{0x10};
    EXPECT_FALSE(StreamMesh::read(bytes)) << i;
  }
}

void put_word(std::vector<std::byte>& bytes, std::size_t at, std::uint32_t word) {
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<std::byte>(word >> 8 * k & 255);
}

/// So that what is wrong is not the checksum.
void sign(std::vector<std::byte>& bytes, std::size_t first_chunk_end) {
  const std::size_t head = foredraw_stream_word(raw(bytes) + 8);
  put_word(bytes, head - 4, foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, raw(bytes), head - 4));
  const std::uint32_t sum = foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, raw(bytes) + head, 20);
  put_word(bytes, head + 20, foredraw_stream_checksum(sum, raw(bytes) + head + 24, first_chunk_end - head - 24));
}

class Damage : public ::testing::Test {
 protected:
  Damage() : of_(sequenced(testing::scene_of(testing::closed_torus(20, 12)))) {
    made_ = progressive_stream(of_.mesh, of_.sequence);
    head_ = foredraw_stream_word(raw(made_.bytes) + 8);
  }
  bool reads_with(std::size_t at, std::uint32_t word) const {
    std::vector<std::byte> bytes = made_.bytes;
    put_word(bytes, at, word);
    sign(bytes, made_.chunk_end[0]);
    return StreamMesh::read(bytes).has_value();
  }
  std::uint32_t word(std::size_t at) const { return foredraw_stream_word(raw(made_.bytes) + at); }

  Sequenced of_;
  ProgressiveStream made_;
  std::size_t head_ = 0;
};

TEST_F(Damage, OnlyTheStreamItselfIsRead) { EXPECT_TRUE(reads_with(head_ + 4, word(head_ + 4))); }

TEST_F(Damage, ClaimsAreRefusedBeforeThereIsMemory) {
  for (const std::size_t count :
       {20u, 24u, 28u, 52u, 56u, 60u}) {  // points, vertices, triangles, parts, draws, numbers
    for (const std::uint32_t claim : {0xffffffffu, 0x7fffffffu, 100'000'000u}) {
      std::vector<std::byte> bytes = made_.bytes;
      put_word(bytes, count, claim);
      sign(bytes, made_.chunk_end[0]);
      foredraw_stream_header header;
      EXPECT_EQ(foredraw_stream_read_header(raw(bytes), bytes.size(), &header), -1) << count;
    }
  }
}

TEST_F(Damage, CountsMustBeRight) {
  for (const std::size_t at : {std::size_t{20}, std::size_t{24}, std::size_t{28}, head_ + 4, head_ + 8, head_ + 12}) {
    EXPECT_FALSE(reads_with(at, word(at) + 1)) << at;
    EXPECT_FALSE(reads_with(at, word(at) - 1)) << at;
  }
  EXPECT_FALSE(reads_with(head_ + 4, 0xffffffffu)) << "2^32 splits";
}

/// Bytes of no meaning, signed: what they say is read, and comes to an end.
TEST_F(Damage, AnyBytesComeToAnEnd) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::byte> bytes = made_.bytes;
    const std::size_t first = head_ + 24 + random.below(bytes.size() - head_ - 24);
    for (std::size_t at = first; at < bytes.size(); ++at) {
      bytes[at] = i % 3 == 0 ? std::byte{0} : i % 3 == 1 ? std::byte{255} : static_cast<std::byte>(random.below(256));
    }
    sign(bytes, made_.chunk_end[0]);
    const Reader reader(bytes, all_chunks);
    for (std::size_t c = 0; c < std::size_t{3} * reader.mesh().triangles; ++c) {
      EXPECT_LT(reader.mesh().indices[c], reader.mesh().vertices + 1);
    }
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
  const Sequenced of = sequenced(testing::scene_of(fan));
  EXPECT_GT(of.sequence.collapses.size(), around / 2);
  const auto read = StreamMesh::read(progressive_stream(of.mesh, of.sequence).bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(difference(*read, of.mesh), "");
}

/// Places at 16 bits and triangles: less than a fifth of what floats and indices of 16 bits take.
TEST(ProgressiveStream, IsSmall) {
  const Sequenced of = sequenced(testing::scene_of(testing::closed_torus(160, 80)));
  const ProgressiveStream made = progressive_stream(of.mesh, of.sequence);
  EXPECT_LT(static_cast<double>(made.bytes.size()) / static_cast<double>(of.mesh.positions.size()), 4.0);
}

class StreamStage : public ::testing::Test {
 protected:
  void run(CollapsePlacement placement) {
    Sequenced of = sequenced(two_halves(), placement);
    scene_ = of.scene;
    for (Draw& draw : scene_.draws) draw.full().made.add(traits::progressive);
    scene_.products.set(
        CollapseSequences{{{of.draws, std::make_shared<const CollapseSequence>(std::move(of.sequence))}}});
    const Technique technique = progressive_stream_plugin().create({});
    std::get<std::unique_ptr<Processor>>(technique)->process(scene_, of.draws, fixture_.run);
  }

  Scene scene_;
  testing::RunFixture fixture_;
  const std::shared_ptr<const ProductRow> row_ = stream_product();
};

TEST_F(StreamStage, MakesAProductThatIsProved) {
  run(CollapsePlacement::endpoint);
  ASSERT_NE(scene_.products.find<ProgressiveStreams>(), nullptr);
  EXPECT_EQ(scene_.products.find<CollapseSequences>(), nullptr) << "it is used up";
  EXPECT_EQ(row_->difference(scene_), "");
  ASSERT_EQ(fixture_.findings.measured.size(), 1u);
  const SideFile file = row_->side_file(scene_, ".json", "streams.bin");
  EXPECT_EQ(file.beside.size(), scene_.products.find<ProgressiveStreams>()->meshes[0].bytes.size());
}

TEST_F(StreamStage, StaysWhileTrianglesMoveAndEndsWhereTheyChange) {
  run(CollapsePlacement::endpoint);
  Scene after = scene_;
  std::vector<std::uint32_t> order(after.draws[0].full().stream().triangle_count());
  for (std::size_t t = 0; t < order.size(); ++t) order[t] = static_cast<std::uint32_t>(order.size() - 1 - t);
  after.draws[0].full().stream() = with_triangle_order(after.draws[0].full().stream(), order);
  EXPECT_TRUE(row_->follow(scene_, after).empty());
  EXPECT_EQ(row_->difference(after), "");
  std::vector<std::uint32_t> fewer(after.draws[1].full().stream().indices.view().begin() + 3,
                                   after.draws[1].full().stream().indices.view().end());
  after.draws[1].full().stream().indices = Shared<std::uint32_t>(std::move(fewer));
  EXPECT_THAT(row_->difference(after), HasSubstr("shows other triangles"));
  EXPECT_EQ(row_->follow(scene_, after).size(), 1u);
  EXPECT_EQ(after.products.find<ProgressiveStreams>(), nullptr);
}

TEST_F(StreamStage, SaysWhatItWants) {
  run(CollapsePlacement::optimal);
  EXPECT_EQ(scene_.products.find<ProgressiveStreams>(), nullptr);
  ASSERT_EQ(fixture_.findings.notes.size(), 1u);
  EXPECT_THAT(fixture_.findings.notes[0].message, HasSubstr("endpoint"));
  EXPECT_TRUE(fixture_.run.keeps());
}

}  // namespace
}  // namespace foredraw
