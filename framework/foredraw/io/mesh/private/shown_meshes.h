#pragma once
// What the nodes of a scene show, in one space: for files that know no nodes. Private to io.

#include <foredraw/scene/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace foredraw::mesh_files {

struct ShownMesh {
  std::string name, material;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;    ///< of length 1; as many, or none
  std::vector<glm::vec2> texcoords;  ///< TEXCOORD_0, from the upper left corner; as many, or none
  std::vector<glm::vec4> colors;     ///< COLOR_0, 0 to 1, as stored; as many, or none
  std::vector<std::uint32_t> indices;
};

/// The triangles of full detail as each node that is shown places them, instances one by one; meshes with skins as they
/// are bound, morph targets at rest without their weights. Lines and points are counted in `left_out`.
std::vector<ShownMesh> shown_meshes(const Scene& scene, std::size_t& left_out);

}  // namespace foredraw::mesh_files
