// Streams of version 1 are what they were. What changes a byte of them makes files of others unreadable, and needs
// another version.

#include "support/progressive_streams.h"
#include "support/refined.h"

#include <gtest/gtest.h>

namespace foredraw::progressive_stream_format_test {
namespace {

using testing::TestMesh;

template <class T>
void add(VertexStreams& vertices, const char* semantic, Component component, std::uint8_t components,
         const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  const bool is_amount = component != Component::float32;
  vertices.base.push_back({semantic,
                           {component, components, is_amount, static_cast<std::uint16_t>(components * sizeof(T))},
                           Shared<std::byte>({bytes.begin(), bytes.end()})});
}

/// Hills of whole numbers, so that no library's rounding is in it. Below its middle the first half has vertices of its
/// own, at a seam; the second half is another draw, of other attributes.
Scene hills() {
  constexpr std::uint32_t across = 24;
  TestMesh all = testing::grid(across, across);
  Random random(3);
  for (glm::vec3& p : all.positions) p.z = static_cast<float>(random.below(9));
  TestMesh first{all.positions, {}}, second{all.positions, {}};
  const auto count = static_cast<std::uint32_t>(all.positions.size());
  for (std::size_t v = 0; v < count; ++v) first.positions.push_back(glm::vec3(first.positions[v]));
  for (std::size_t i = 0; i < all.indices.size(); ++i) {
    const std::size_t cell = i / 6, x = cell % across, y = cell / across;
    if (x >= across / 2) {
      second.indices.push_back(all.indices[i]);
    } else {
      first.indices.push_back(all.indices[i] + (y < across / 2 ? count : 0));
    }
  }
  std::vector<Draw> draws{testing::draw_of(first, "first"), testing::draw_of(second, "second")};
  for (std::size_t d = 0; d < 2; ++d) {
    VertexStreams vertices = *draws[d].full().vertices;
    std::vector<std::uint8_t> colours;
    std::vector<float> coordinates;
    for (std::uint32_t v = 0; v < vertices.count; ++v) {
      for (int c = 0; c < 4; ++c) colours.push_back(static_cast<std::uint8_t>(v % 7 * 30 + random.below(8)));
      for (int c = 0; c < 2; ++c) coordinates.push_back(0.25f * static_cast<float>(v / 25 + random.below(3)));
    }
    add(vertices, "COLOR_0", Component::uint8, 4, colours);
    if (d == 0) add(vertices, "TEXCOORD_0", Component::float32, 2, coordinates);
    draws[d].full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  }
  return testing::scene_of(std::move(draws));
}

std::uint32_t checksum(std::span<const std::byte> bytes) {
  return foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, testing::raw(bytes), bytes.size());
}

TEST(ProgressiveStreamFormat, OfVersionOneIsWhatItWas) {
  const Scene scene = hills();
  const std::vector<DrawId> both{0, 1};
  Analyses analyses;
  const JoinedMesh mesh = joined_mesh(scene, both, analyses).value();
  const CollapseSequence sequence = testing::collapses_of({mesh.positions, mesh.indices}, 5);
  ASSERT_GT(sequence.collapses.size(), 400u);
  ProgressiveStreamOptions options;
  options.chunk_size = 1024;
  const ProgressiveStream rounded = progressive_stream(mesh, sequence, options);
  options.lossless = true;
  const ProgressiveStream exact = progressive_stream(mesh, sequence, options);
  for (const ProgressiveStream* made : {&rounded, &exact}) {
    const auto read = StreamMesh::read(made->bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(difference(*read, mesh), "");
  }
  EXPECT_EQ(foredraw_stream_word(testing::raw(rounded.bytes) + 4), 1u);
  EXPECT_EQ(checksum(rounded.bytes), 525872897u);
  EXPECT_EQ(checksum(exact.bytes), 1656333227u);
}

}  // namespace
}  // namespace foredraw::progressive_stream_format_test
