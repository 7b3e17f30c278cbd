#include "tessellate.h"

#include <foredraw/displaced/displaced_streams.h>

namespace foredraw {

Tessellated tessellate(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                       std::span<const glm::vec3> directions, const TessellatedMesh& mesh,
                       std::span<const float> displacements, bool keeps_normals) {
  return {displaced_streams(vertices, indices, directions, mesh, displacements, keeps_normals), mesh.indices};
}

}  // namespace foredraw
