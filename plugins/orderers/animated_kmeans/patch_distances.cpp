#include "patch_distances.h"

#include <foredraw/viewing/bounding_sphere.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace foredraw {

namespace {

struct Triangle {
  glm::dvec3 corner;
  glm::dvec3 normal;  // times twice the area; 0 where it has none, or is not finite
};

struct Patch {
  glm::dvec3 centroid{0};
  bool is_seen_from_behind = false;
  std::vector<Triangle> triangles;  // with an area
};

/// Triangles first to last - 1 of a part, in radii from the centre.
Patch patch_of(const RasterPart& part, std::uint32_t first, std::uint32_t last, const BoundingSphere& sphere) {
  Patch patch;
  patch.is_seen_from_behind = !part.culls_back_faces;
  glm::dvec3 moment(0);
  double areas = 0;
  const auto place = [&](std::uint32_t i) {
    return (glm::dvec3(part.positions[part.indices[i]]) - sphere.centre) / sphere.radius;
  };
  for (std::uint32_t t = first; t < last; ++t) {
    const glm::dvec3 a = place(3 * t), b = place(3 * t + 1), c = place(3 * t + 2);
    const glm::dvec3 normal = glm::cross(b - a, c - a) * (part.is_mirrored ? -1.0 : 1.0);
    const double area = std::sqrt(glm::dot(normal, normal));
    if (!std::isfinite(area) || area <= 0) continue;
    patch.triangles.push_back({a, normal});
    moment += (a + b + c) * (area / 3);
    areas += area;
  }
  if (areas > 0) patch.centroid = moment / areas;
  return patch;
}

bool is_facing(const Patch& patch, const View& view) {
  if (patch.is_seen_from_behind) return !patch.triangles.empty();
  const glm::dvec3 eye = view.direction * view.distance;
  for (const Triangle& triangle : patch.triangles) {
    const glm::dvec3 to_camera = view.distance > 0 ? eye - triangle.corner : view.direction;
    if (glm::dot(triangle.normal, to_camera) > 0) return true;
  }
  return false;
}

double distance_from(const View& view, const glm::dvec3& place) {
  if (view.distance <= 0) return -glm::dot(place, view.direction);
  const glm::dvec3 to_camera = view.direction * view.distance - place;
  return std::sqrt(glm::dot(to_camera, to_camera));
}

}  // namespace

void PatchDistances::add_pose(const SubjectLayers& subject, std::span<const RasterPart> parts,
                              const Executor& executor) {
  std::vector<DrawnPositions> drawn;
  for (const RasterPart& part : parts) drawn.push_back({part.positions, part.indices});
  const BoundingSphere sphere = bounding_sphere(drawn);
  std::vector<Patch> patches;
  std::vector<glm::dvec3>& centroids = centroids_.emplace_back();
  for (const LayerOwner& owner : subject.owners) {
    const auto& offsets = subject.draws[owner.draw].atoms.offsets;
    patches.push_back(patch_of(parts[owner.part], offsets[owner.piece], offsets[owner.piece + 1], sphere));
    centroids.push_back(patches.back().centroid);
  }
  const std::size_t first = facing_.size();
  facing_.resize(first + views_.size());
  executor.for_each(views_.size(), [&](std::size_t view) {
    for (const Patch& patch : patches) facing_[first + view].push_back(foredraw::is_facing(patch, views_[view]));
  });
}

double PatchDistances::distance(std::size_t look, std::size_t patch) const {
  return distance_from(view_of(look), centroids_[look / views_.size()][patch]);
}

void PatchDistances::integrate(std::size_t look, double weight, std::span<IntegratedDistance> patches) const {
  const View& view = view_of(look);
  const std::vector<glm::dvec3>& centroids = centroids_[look / views_.size()];
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    if (!facing_[look][patch]) continue;
    patches[patch].distance += weight * distance_from(view, centroids[patch]);
    patches[patch].looks += weight;
  }
}

}  // namespace foredraw
