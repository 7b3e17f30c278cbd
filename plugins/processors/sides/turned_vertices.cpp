#include "turned_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace foredraw::processors::sides {

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

const VertexStream* floats_of(std::span<const VertexStream> streams, std::string_view semantic,
                              std::uint8_t components) {
  const auto found = std::ranges::find(streams, semantic, &VertexStream::semantic);
  const Format wanted{Component::float32, components, false, static_cast<std::uint16_t>(components * sizeof(float))};
  return found != streams.end() && found->format == wanted ? &*found : nullptr;
}

/// A unit vector at a right angle to the normal, which need not have length 1; the x axis where it has none.
std::array<float, 3> across(std::span<const float, 3> normal) {
  const auto [x, y, z] = std::array{normal[0], normal[1], normal[2]};
  const std::array<float, 3> made = std::abs(x) < std::abs(z) ? std::array{0.0f, -z, y} : std::array{-y, x, 0.0f};
  const float length = std::sqrt(made[0] * made[0] + made[1] * made[1] + made[2] * made[2]);
  if (!(length > 0)) return {1, 0, 0};
  return {made[0] / length, made[1] / length, made[2] / length};
}

/// A tangent of no length, which glTF forbids, says nothing: its copies get one, so that there is no further fault.
void mend_tangents(VertexStreams& streams, std::size_t first) {
  const VertexStream* const tangents = floats_of(streams.base, "TANGENT", 4);
  const VertexStream* const normals = floats_of(streams.base, "NORMAL", 3);
  if (tangents == nullptr || normals == nullptr) return;
  std::vector<std::byte> bytes(tangents->bytes.view().begin(), tangents->bytes.view().end());
  for (std::size_t vertex = first; vertex < streams.count; ++vertex) {
    std::array<float, 3> tangent, normal;
    std::memcpy(tangent.data(), bytes.data() + 16 * vertex, sizeof tangent);
    if (tangent != std::array{0.0f, 0.0f, 0.0f}) continue;
    std::memcpy(normal.data(), normals->bytes.view().data() + 12 * vertex, sizeof normal);
    tangent = across(normal);
    std::memcpy(bytes.data() + 16 * vertex, tangent.data(), sizeof tangent);
  }
  streams.base[tangents - streams.base.data()].bytes = Shared(std::move(bytes));
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
  mend_tangents(*result, streams.count);
  return result;
}

}  // namespace foredraw::processors::sides
