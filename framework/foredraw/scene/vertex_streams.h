#pragma once
// Vertex attributes as the asset stores them: 16 bits stay 16 bits. Float views are decoded on demand.

#include <foredraw/scene/shared.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

enum class Component : std::uint8_t { int8, uint8, int16, uint16, uint32, float32 };
std::size_t bytes_of(Component component);

/// One element of a stream, tightly packed. `bytes` counts the padding that matrix columns need.
struct Format {
  Component component = Component::float32;
  std::uint8_t components = 3;
  bool normalized = false;
  std::uint16_t bytes = 12;
  friend bool operator==(const Format&, const Format&) = default;
};

struct VertexStream {
  std::string semantic;  ///< glTF's word: "POSITION", "TEXCOORD_0", "_MINE"
  Format format;
  Shared<std::byte> bytes;  ///< count * format.bytes, without gaps

  std::size_t count() const { return format.bytes == 0 ? 0 : bytes.size() / format.bytes; }
};

struct VertexStreams {
  std::vector<VertexStream> base;
  std::vector<std::vector<VertexStream>> morph_targets;  ///< each as long as the base
  std::uint32_t count = 0;                               ///< vertices

  const VertexStream* find(std::string_view semantic) const;
  /// Every stream: the base, then each morph target's.
  std::vector<const VertexStream*> all() const;
  /// Of all streams' names and formats, and of which of them are the base's and which each morph target's.
  Stamp layout_stamp() const;
  /// Of the layout, the number of vertices and all streams' content.
  Stamp stamp() const;
  /// Bytes of one vertex over the base streams.
  std::size_t bytes_per_vertex() const;
};

/// One component of one element as the shader sees it: normalized integers become [0, 1] or [-1, 1].
float decode_component(const VertexStream& stream, std::size_t element, std::size_t component);

/// The first three components of every element (missing ones are 0).
std::vector<glm::vec3> decode_vec3(const VertexStream& stream);

}  // namespace foredraw
