#pragma once
// Draws made in code, from memory of GLM's vectors.

#include <foredraw/scene/draw.h>

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace foredraw {

/// A copy of any contiguous range of float vectors: float_stream("TEXCOORD_0", std::vector<glm::vec2>(...)).
template <class Vectors>
VertexStream float_stream(std::string semantic, const Vectors& vectors) {
  const std::span values(vectors);
  using Vector = typename decltype(values)::value_type;
  static_assert(std::is_same_v<typename Vector::value_type, float> && sizeof(Vector) == 4 * Vector::length());
  const auto bytes = std::as_bytes(values);
  const Format format{Component::float32, static_cast<std::uint8_t>(Vector::length()), false, sizeof(Vector)};
  return {std::move(semantic), format, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A draw of triangles in one level and one order, without material. `indices` holds three a triangle; `streams` are
/// the attributes besides positions. Throws std::invalid_argument where indices are no multiple of three, one of them
/// names no position, or a stream is not as long as the positions.
Draw triangle_draw(std::string name, std::span<const glm::vec3> positions, std::vector<std::uint32_t> indices,
                   std::vector<VertexStream> streams = {});

}  // namespace foredraw
