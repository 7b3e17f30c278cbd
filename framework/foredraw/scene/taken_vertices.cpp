#include <foredraw/scene/taken_vertices.h>

#include <cstring>

namespace foredraw {

namespace {

Shared<std::byte> taken(const VertexStream& stream, std::span<const std::uint32_t> from) {
  const std::size_t row = stream.format.bytes;
  const std::span<const std::byte> bytes = stream.bytes.view();
  std::vector<std::byte> result(from.size() * row);
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::memcpy(result.data() + i * row, bytes.data() + from[i] * row, row);
  }
  return Shared<std::byte>(std::move(result));
}

}  // namespace

VertexStreams taken_vertices(const VertexStreams& streams, std::span<const std::uint32_t> from) {
  VertexStreams result = streams;
  result.count = static_cast<std::uint32_t>(from.size());
  for (VertexStream& stream : result.base) stream.bytes = taken(stream, from);
  for (auto& target : result.morph_targets) {
    for (VertexStream& stream : target) stream.bytes = taken(stream, from);
  }
  return result;
}

}  // namespace foredraw
