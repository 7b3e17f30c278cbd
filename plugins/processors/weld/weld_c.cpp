#include "weld.h"

#include <foredraw/c/checked_input.h>
#include <foredraw/scene/draw.h>

#include <algorithm>
#include <limits>

using namespace foredraw;

namespace {

/// The bytes of an attribute, one vertex's behind the other's.
VertexStream stream_of(const foredraw_attribute& attribute, std::size_t count) {
  std::vector<std::byte> bytes(count * attribute.bytes);
  const std::size_t stride = attribute.stride == 0 ? attribute.bytes : attribute.stride;
  const auto* from = static_cast<const std::byte*>(attribute.first);
  for (std::size_t v = 0; v < count; ++v) {
    std::memcpy(bytes.data() + v * attribute.bytes, from + v * stride, attribute.bytes);
  }
  return {"", {Component::uint8, 1, false, static_cast<std::uint16_t>(attribute.bytes)}, Shared(std::move(bytes))};
}

}  // namespace

int foredraw_weld(uint32_t* destination, uint32_t* kept, uint32_t* kept_count, const foredraw_triangles* triangles,
                  const foredraw_attribute* attributes, uint32_t attribute_count, int keep_unused) {
  return c::with_triangles(triangles, destination, [&](const c::CheckedTriangles& checked) -> int {
    if (attributes == nullptr || kept_count == nullptr) return FOREDRAW_NULL_POINTER;
    if (destination == nullptr && checked.vertex_count() > 0) return FOREDRAW_NULL_POINTER;
    if (attribute_count == 0 || keep_unused < 0 || keep_unused > 1) return FOREDRAW_OPTION_RANGE;
    VertexStreams vertices;
    vertices.count = static_cast<std::uint32_t>(checked.vertex_count());
    for (const foredraw_attribute& attribute : std::span(attributes, attribute_count)) {
      if (attribute.bytes < 1 || attribute.bytes > std::numeric_limits<std::uint16_t>::max()) {
        return FOREDRAW_OPTION_RANGE;
      }
      if (attribute.first == nullptr && vertices.count > 0) return FOREDRAW_NULL_POINTER;
      vertices.base.push_back(stream_of(attribute, vertices.count));
    }
    const std::span<const std::uint32_t> indices = checked.indices();
    const Weld found = weld(vertices, {&indices, 1}, {.keep_unused = keep_unused == 1});
    std::ranges::copy(found.destination, destination);
    *kept_count = found.count;
    if (kept == nullptr) return FOREDRAW_DONE;
    for (std::size_t v = vertices.count; v-- > 0;) {  // of equals the first is written last
      if (found.destination[v] != no_vertex) kept[found.destination[v]] = static_cast<std::uint32_t>(v);
    }
    return FOREDRAW_DONE;
  });
}
