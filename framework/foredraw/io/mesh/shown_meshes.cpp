#include <foredraw/io/mesh/private/shown_meshes.h>

#include <foredraw/scene/scaled_texcoords.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>

namespace foredraw::mesh_files {

namespace {

template <int n>
std::vector<glm::vec<n, float>> values(const VertexStreams& vertices, std::string_view semantic, float missing = 0) {
  std::vector<glm::vec<n, float>> rows;
  const VertexStream* stream = vertices.find(semantic);
  if (stream == nullptr) return rows;
  rows.resize(vertices.count, glm::vec<n, float>(missing));
  for (std::size_t v = 0; v < rows.size(); ++v) {
    for (int c = 0; c < std::min<int>(n, stream->format.components); ++c) {
      rows[v][c] = decode_component(*stream, v, static_cast<std::size_t>(c));
    }
  }
  return rows;
}

ShownMesh mesh_of(const Scene& scene, const Draw& draw, const glm::mat4& world) {
  const Level& level = draw.full();
  const auto indices = level.stream().indices.view();
  ShownMesh mesh{.name = draw.name,
                 .material = {},
                 .positions = values<3>(*level.vertices, "POSITION"),
                 .normals = values<3>(*level.vertices, "NORMAL"),
                 .texcoords = values<2>(*level.vertices, "TEXCOORD_0"),
                 .colors = values<4>(*level.vertices, "COLOR_0", 1),
                 .indices = {indices.begin(), indices.end()}};
  const Material* material = scene.material_of(draw);
  if (material != nullptr) mesh.material = material->name;
  const ScaledTexcoords plain = scaled_texcoords_of(material, 0);  // these files have no words for other units
  for (glm::vec2& uv : mesh.texcoords) uv = glm::vec2(plain.offset + plain.scale * glm::dvec2(uv));
  const glm::mat3 turn(world), of_normals = glm::inverseTranspose(turn);
  for (glm::vec3& position : mesh.positions) position = glm::vec3(world * glm::vec4(position, 1));
  for (glm::vec3& normal : mesh.normals) {
    const glm::vec3 turned = of_normals * normal;
    const float length = glm::length(turned);
    normal = length > 0 ? turned / length : normal;
  }
  if (glm::determinant(turn) < 0) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
  return mesh;
}

}  // namespace

std::vector<ShownMesh> shown_meshes(const Scene& scene, std::size_t& left_out) {
  std::vector<ShownMesh> meshes;
  const std::vector<glm::mat4> world = world_transforms(scene);
  for (NodeId id = 0; id < scene.nodes.size(); ++id) {
    const Node& node = scene.nodes[id];
    if (!node.mesh || !node.is_shown) continue;
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      if (scene.draws[draw].topology != Topology::triangles) {
        ++left_out;
        continue;
      }
      if (node.skin) {
        meshes.push_back(mesh_of(scene, scene.draws[draw], glm::mat4(1)));
      } else if (node.instances.empty()) {
        meshes.push_back(mesh_of(scene, scene.draws[draw], world[id]));
      } else {
        for (const Transform& at : node.instances.view()) {
          meshes.push_back(mesh_of(scene, scene.draws[draw], world[id] * at.matrix()));
        }
      }
    }
  }
  return meshes;
}

}  // namespace foredraw::mesh_files
