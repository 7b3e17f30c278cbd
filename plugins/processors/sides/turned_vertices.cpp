#include "turned_vertices.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace foredraw::sides {

namespace {

template <class Number>
void negate(std::byte* element, std::size_t components) {
  for (std::size_t c = 0; c < components; ++c) {
    Number value;
    std::memcpy(&value, element + c * sizeof value, sizeof value);
    if constexpr (std::is_integral_v<Number>) {
      value = value == std::numeric_limits<Number>::min() ? std::numeric_limits<Number>::max()
                                                          : static_cast<Number>(-value);
    } else {
      value = -value;
    }
    std::memcpy(element + c * sizeof value, &value, sizeof value);
  }
}

void negate(std::byte* element, const Format& format) {
  switch (format.component) {
    case Component::int8: return negate<std::int8_t>(element, format.components);
    case Component::int16: return negate<std::int16_t>(element, format.components);
    case Component::float32: return negate<float>(element, format.components);
    default: return;  // unsigned numbers hold no direction
  }
}

VertexStream with_turned_copies(const VertexStream& stream, std::span<const std::uint32_t> copies) {
  const std::size_t size = stream.format.bytes;
  const std::span<const std::byte> before = stream.bytes.view();
  std::vector<std::byte> bytes(before.begin(), before.end());
  bytes.resize(before.size() + copies.size() * size);
  const bool is_turned = stream.semantic == "NORMAL" || stream.semantic == "TANGENT";
  std::byte* to = bytes.data() + before.size();
  for (const std::uint32_t vertex : copies) {
    std::memcpy(to, before.data() + vertex * size, size);
    if (is_turned) negate(to, stream.format);
    to += size;
  }
  return {stream.semantic, stream.format, Shared(std::move(bytes))};
}

}  // namespace

std::shared_ptr<const VertexStreams> with_turned_copies(const VertexStreams& streams,
                                                        std::span<const std::uint32_t> copies) {
  auto result = std::make_shared<VertexStreams>();
  for (const VertexStream& stream : streams.base) result->base.push_back(with_turned_copies(stream, copies));
  for (const std::vector<VertexStream>& target : streams.morph_targets) {
    result->morph_targets.emplace_back();
    for (const VertexStream& stream : target)
      result->morph_targets.back().push_back(with_turned_copies(stream, copies));
  }
  result->count = streams.count + static_cast<std::uint32_t>(copies.size());
  return result;
}

}  // namespace foredraw::sides
