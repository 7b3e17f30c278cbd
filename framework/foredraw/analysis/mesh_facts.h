#pragma once
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace foredraw {

/// What is unusual about a triangle list. Every count is exact.
struct MeshFacts {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t unreferenced_vertices = 0;
  std::size_t non_finite_positions = 0;  ///< with an infinity or a NaN, referenced or not
  std::size_t repeated_corners = 0;      ///< triangles that name a vertex twice
  std::size_t zero_area = 0;             ///< of the others with finite positions, those whose corners lie on a line
  std::size_t duplicate_triangles = 0;   ///< the same three vertices in the same turn as an earlier triangle
  std::size_t non_manifold_edges = 0;    ///< with more than two triangles; those with repeated corners are not asked
  friend bool operator==(const MeshFacts&, const MeshFacts&) = default;
};

/// Indices are below the number of positions. O(n log n).
MeshFacts mesh_facts(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// The counts by the names that reports give them: "zero-area" and so on.
std::vector<std::pair<std::string_view, std::size_t>> named_counts(const MeshFacts& facts);

/// Whether the points lie on one line, exactly. Finite coordinates.
bool are_collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace foredraw
