// Any bytes as a stream of the vertex codec: a byte of stride, two of count, then the stream. It is decoded or not,
// alike at every width of vector registers; what was decoded is encoded, and decoded again.

#include "claim.h"
#include "support/vector_widths.h"

#include <foredraw/io/meshopt/vertex_codec.h>

#include <optional>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  if (size < 3) return 0;
  const std::size_t stride = 4 + data[0] % 64 * 4;
  const std::size_t count = (data[1] + data[2] * std::size_t{256}) % 2048;
  const auto all = std::as_bytes(std::span(data, size)).subspan(3);
  const std::vector<std::byte> stream(all.begin(), all.end());  // of its own, so that a byte read too much is seen
  const auto decoded = [&](const std::vector<std::byte>& from) -> std::optional<std::vector<std::byte>> {
    std::vector<std::byte> elements(count * stride);
    if (!meshopt::decode_vertices(from, stride, elements)) return std::nullopt;
    return elements;
  };
  const auto elements = decoded(stream);
  testing::at_every_width([&] { claim(decoded(stream) == elements, "two widths decode differently"); });
  if (!elements) return 0;
  const auto version = meshopt::vertex_version(stream);
  claim(version.has_value(), "decoded without a version");
  claim(stream.size() >= meshopt::least_vertex_bytes(count, stride, *version), "shorter than any stream can be");
  const auto again = meshopt::encode_vertices(*elements, stride, *version);
  claim(decoded(again) == elements, "encoded and decoded, it is another");
  return 0;
}
