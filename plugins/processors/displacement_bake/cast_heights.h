#pragma once
// How far a surface lies from points, along their directions.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/ray_tree.h>
#include <foredraw/base/parallel.h>
#include <foredraw/displaced/tessellated_mesh.h>

#include <vector>

namespace foredraw::processors::displacement_bake {

/// A surface that rays are cast at. It keeps copies.
class Target {
 public:
  explicit Target(const Surface& surface);

  /// How far the surface lies from a point along a direction of length 1, up or down: where a ray meets its nearer side
  /// that looks along the direction. Where rays meet nothing, as beside a border, or only another fold far behind the
  /// nearest point, that point counts, as far as it lies along the direction. 0 where there is no surface, or
  /// the point is not finite.
  double height_from(const glm::dvec3& point, const glm::dvec3& direction) const;

 private:
  RayTree fronts_, backs_;
  ClosestPoints points_;
};

/// A mesh of few triangles that stands for the surface.
struct Cage {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;
  std::span<const glm::vec3> directions;  ///< [vertex] smooth_directions()
};

/// [vertex of a mesh that the cage was divided into] its height. Vertices at one place with one direction get one
/// height, so that seams stay closed.
std::vector<float> cast_heights(const Cage& cage, const TessellatedMesh& mesh, const Target& target,
                                const Executor& executor);

}  // namespace foredraw::processors::displacement_bake
