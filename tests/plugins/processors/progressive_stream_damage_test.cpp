#include "support/progressive_streams.h"

#include <gtest/gtest.h>

namespace foredraw::progressive_stream_damage_test {
namespace {

using testing::all_chunks;
using testing::raw;
using testing::Reader;
using testing::Sequenced;
using testing::sequenced;
using testing::two_halves;

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

}  // namespace
}  // namespace foredraw::progressive_stream_damage_test
