#pragma once
// The two streams of vertices that know their wire.

#include "wire_radius.h"

#include <foredraw/scene/draw.h>

#include <glm/vec4.hpp>

#include <memory>
#include <optional>
#include <span>

namespace foredraw::processors::wire_radius {

/// A vertex, and the number of its copy in what was found.
struct CopiedVertex {
  std::uint32_t vertex = 0;
  std::uint32_t copy = 0;
};

/// The streams of the mesh's vertices from `first` on, in place of any of that name, or in sets of texture coordinates
/// from that number on. Behind the vertices come copies of
/// some of them with wires of their own; all else of them is the same.
std::shared_ptr<const VertexStreams> with_wire_streams(const VertexStreams& vertices, const FoundWires& found,
                                                       std::size_t first, std::span<const CopiedVertex> copies,
                                                       std::optional<std::uint32_t> texcoords = {});

/// The number behind those of all texture coordinates that there are.
std::uint32_t first_free_texcoord(const VertexStreams& vertices);

/// `texcoords`: as DrawWires has it.
std::shared_ptr<const VertexStreams> without_wire_streams(const VertexStreams& vertices,
                                                          std::optional<std::uint32_t> texcoords);

/// What WIRE says of each vertex. Nothing where one of the two streams is missing, or of another type, or a number is
/// not finite.
std::optional<std::vector<glm::vec4>> wire_rows(const VertexStreams& vertices, std::optional<std::uint32_t> texcoords);

}  // namespace foredraw::processors::wire_radius
