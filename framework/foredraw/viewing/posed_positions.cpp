#include <foredraw/viewing/posed_positions.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace foredraw {

namespace {

/// One JOINTS_n with its WEIGHTS_n.
struct Influences {
  const VertexStream* joints;
  const VertexStream* weights;
  std::size_t components;
};

std::vector<Influences> influences_of(const VertexStreams& vertices) {
  std::vector<Influences> sets;
  for (int n = 0;; ++n) {
    const VertexStream* joints = vertices.find("JOINTS_" + std::to_string(n));
    const VertexStream* weights = vertices.find("WEIGHTS_" + std::to_string(n));
    if (joints == nullptr || weights == nullptr) return sets;
    sets.push_back({joints, weights, std::min(joints->format.components, weights->format.components)});
  }
}

std::vector<glm::dmat4> joint_matrices(const Skin& skin, std::span<const glm::mat4> world) {
  std::vector<glm::dmat4> matrices;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const glm::dmat4 from_bind = i < skin.inverse_bind_matrices.size() ? skin.inverse_bind_matrices[i] : glm::mat4(1);
    matrices.push_back(glm::dmat4(world[skin.joints[i]]) * from_bind);
  }
  return matrices;
}

glm::dvec3 moved(const glm::dmat4& by, const glm::dvec3& position) { return glm::dvec3(by * glm::dvec4(position, 1)); }

/// By the joints, or `otherwise` where none has a weight.
glm::dmat4 blended(std::span<const glm::dmat4> joints, std::span<const Influences> sets, std::size_t vertex,
                   const glm::dmat4& otherwise) {
  glm::dmat4 sum(0);
  double weights = 0;
  for (const Influences& set : sets) {
    for (std::size_t c = 0; c < set.components; ++c) {
      const double weight = decode_component(*set.weights, vertex, c);
      const float joint = decode_component(*set.joints, vertex, c);
      if (weight == 0 || !(joint >= 0 && joint < static_cast<float>(joints.size()))) continue;
      sum += weight * joints[static_cast<std::size_t>(joint)];
      weights += weight;
    }
  }
  return weights == 0 ? otherwise : sum / weights;
}

void add_morph_targets(std::vector<glm::dvec3>& values, std::string_view semantic, const VertexStreams& vertices,
                       std::span<const float> weights) {
  for (std::size_t target = 0; target < std::min(weights.size(), vertices.morph_targets.size()); ++target) {
    if (weights[target] == 0) continue;
    for (const VertexStream& stream : vertices.morph_targets[target]) {
      if (stream.semantic != semantic) continue;
      const std::vector<glm::vec3> offsets = decode_vec3(stream);
      for (std::size_t v = 0; v < std::min(values.size(), offsets.size()); ++v) {
        values[v] += static_cast<double>(weights[target]) * glm::dvec3(offsets[v]);
      }
    }
  }
}

/// With what morph targets add; empty where there is no such stream.
std::vector<glm::dvec3> morphed(const VertexStreams& vertices, std::string_view semantic,
                                std::span<const float> weights) {
  const VertexStream* stream = vertices.find(semantic);
  if (stream == nullptr) return {};
  const std::vector<glm::vec3> stored = decode_vec3(*stream);
  std::vector<glm::dvec3> values(stored.begin(), stored.end());
  add_morph_targets(values, semantic, vertices, weights);
  return values;
}

/// What a vertex's transform does to normals, up to their length: that of its cofactors, turned if it mirrors.
glm::dvec3 turned(const glm::dmat4& by, const glm::dvec3& normal) {
  const glm::dvec3 x(by[0]), y(by[1]), z(by[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < 0 ? -(cofactors * normal) : cofactors * normal;
}

/// Calls move(vertex, transform) for each vertex: that of its joints, or of the node.
template <class Move>
void move_each(const Scene& scene, const VertexStreams& vertices, NodeId id, const PosedNodes& nodes, Move move) {
  const Node& node = scene.nodes[id];
  const glm::dmat4 by_node(nodes.world[id]);
  std::vector<glm::dmat4> joints;
  std::vector<Influences> sets;
  if (node.skin) {
    joints = joint_matrices(scene.skins[*node.skin], nodes.world);
    sets = influences_of(vertices);
  }
  for (std::size_t v = 0; v < vertices.count; ++v) move(v, node.skin ? blended(joints, sets, v, by_node) : by_node);
}

}  // namespace

std::vector<glm::vec3> posed_positions(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes) {
  const VertexStreams& vertices = *scene.draws[part.draw].full().vertices;
  const VertexStream* stream = vertices.find("POSITION");
  if (stream == nullptr) return {};
  if (!part.node) return decode_vec3(*stream);
  std::vector<glm::dvec3> positions = morphed(vertices, "POSITION", nodes.weights[*part.node]);
  move_each(scene, vertices, *part.node, nodes, [&](std::size_t v, const glm::dmat4& by) {
    if (v < positions.size()) positions[v] = moved(by, positions[v]);
  });
  return {positions.begin(), positions.end()};
}

VerticesInPose vertices_in_pose(const Scene& scene, const VertexStreams& vertices, NodeId node,
                                const PosedNodes& nodes) {
  std::vector<glm::dvec3> positions = morphed(vertices, "POSITION", nodes.weights[node]);
  std::vector<glm::dvec3> normals = morphed(vertices, "NORMAL", nodes.weights[node]);
  move_each(scene, vertices, node, nodes, [&](std::size_t v, const glm::dmat4& by) {
    if (v < positions.size()) positions[v] = moved(by, positions[v]);
    if (v < normals.size()) normals[v] = turned(by, normals[v]);
  });
  return {{positions.begin(), positions.end()}, {normals.begin(), normals.end()}};
}

std::vector<glm::dmat4x3> vertex_maps(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes) {
  const VertexStreams& vertices = *scene.draws[part.draw].full().vertices;
  std::vector<glm::dmat4x3> maps(vertices.count, glm::dmat4x3(1));
  if (!part.node) return maps;
  std::vector<glm::dvec3> by_targets(vertices.count, glm::dvec3(0));
  add_morph_targets(by_targets, "POSITION", vertices, nodes.weights[*part.node]);
  move_each(scene, vertices, *part.node, nodes, [&](std::size_t v, const glm::dmat4& by) {
    maps[v] = glm::dmat4x3(by);
    maps[v][3] = moved(by, by_targets[v]);
  });
  return maps;
}

bool is_mirrored(const SubjectPart& part, const PosedNodes& nodes) {
  return part.node && glm::determinant(glm::dmat3(nodes.world[*part.node])) < 0;
}

}  // namespace foredraw
