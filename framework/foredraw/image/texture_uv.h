#pragma once
#include <foredraw/scene/texture.h>
#include <foredraw/scene/vertex_streams.h>

#include <glm/vec2.hpp>

#include <vector>

namespace foredraw {

/// Where each vertex lies in the texture's image, moved as KHR_texture_transform says: (0, 0) is the upper left corner,
/// (1, 1) the lower right one.
std::vector<glm::dvec2> texture_uv(const VertexStream& texcoords, const Texture& texture);

}  // namespace foredraw
