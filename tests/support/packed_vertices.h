#pragma once
// Vertices to pack, layouts to pack them by, and scenes that hold both.

#include "support/meshes.h"

#include <foredraw/packing/packed_vertices.h>
#include <plugins/processors/vertex_pack/layout_search.h>
#include <plugins/processors/vertex_pack/vertex_pack.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw::testing {

inline float part(Random& random) { return static_cast<float>(random.unit()); }

inline glm::vec3 random_direction(Random& random) {
  for (;;) {
    const glm::vec3 v(2 * part(random) - 1, 2 * part(random) - 1, 2 * part(random) - 1);
    if (glm::dot(v, v) > 0.01f && glm::dot(v, v) < 1) return glm::normalize(v);
  }
}

struct FloatVertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec2> uvs;

  explicit FloatVertices(std::size_t count) : positions(count), normals(count), tangents(count), uvs(count) {}

  /// Within the box of 0 to 1, with axes among the normals, and tangents of any length at right angles to them.
  static FloatVertices random(std::size_t count, std::uint64_t seed) {
    Random numbers(seed);
    FloatVertices all(count);
    for (std::size_t v = 0; v < count; ++v) {
      all.positions[v] = {part(numbers), part(numbers), part(numbers)};
      all.normals[v] = random_direction(numbers);
      if (v % 16 == 0) all.normals[v] = glm::vec3(v % 3 == 0, v % 3 == 1, v % 3 == 2) * (v % 32 == 0 ? 1.0f : -1.0f);
      const glm::vec3 tangent = glm::cross(all.normals[v], random_direction(numbers));
      all.tangents[v] = {tangent, numbers.below(2) == 0 ? 1 : -1};
      all.uvs[v] = {part(numbers), part(numbers)};
    }
    return all;
  }

  PlainVertices plain() const { return {positions, normals, tangents, uvs}; }
  UnpackedVertices unpacked() { return {positions, normals, tangents, uvs}; }

  foredraw_packed_vertex vertex(std::size_t v) const {
    const glm::vec3 &p = positions[v], &n = normals[v];
    const glm::vec4& t = tangents[v];
    return {{p.x, p.y, p.z}, {n.x, n.y, n.z}, {t.x, t.y, t.z, t.w}, {uvs[v].x, uvs[v].y}};
  }
};

inline processors::vertex_pack::Demand unit_demand(bool is_spherical = false) {
  processors::vertex_pack::Demand demand{.normals = true,
                                         .tangents = true,
                                         .uvs = true,
                                         .uv_extent = glm::dvec2(1),
                                         .displacement = 0.002,
                                         .slope = 0.2,
                                         .most_angle_error = 0.065,
                                         .is_spherical = is_spherical};
  demand.box.add({0, 0, 0});
  demand.box.add({1, 1, 1});
  return demand;
}

inline PackedLayout unit_layout(bool is_spherical = false) {
  return processors::vertex_pack::best_layout(unit_demand(is_spherical)).value();
}

inline double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

}  // namespace foredraw::testing
