#include "raster_part.h"

#include "bounding_sphere.h"
#include "mesh_facts.h"

namespace foredraw {

namespace {

bool is_drawable(const RasterPart& part, const std::array<std::uint32_t, 3>& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(part.positions[t[0]]) &&
         is_finite(part.positions[t[1]]) && is_finite(part.positions[t[2]]);
}

PreparedPart prepared(const RasterPart& part, const BoundingSphere& sphere, std::uint32_t first) {
  PreparedPart result;
  result.culls_back_faces = part.culls_back_faces;
  result.is_mirrored = part.is_mirrored;
  for (const glm::vec3& position : part.positions) {
    const bool has_place = is_finite(position) && sphere.radius > 0;
    result.positions.push_back(has_place ? (glm::dvec3(position) - sphere.centre) / sphere.radius : glm::dvec3(0));
  }
  for (std::uint32_t i = 0; i < part.indices.size() / 3; ++i) {
    const std::array<std::uint32_t, 3> corners = {part.indices[3 * i], part.indices[3 * i + 1],
                                                  part.indices[3 * i + 2]};
    if (is_drawable(part, corners)) result.triangles.push_back({corners, first + i});
  }
  return result;
}

}  // namespace

std::vector<PreparedPart> prepared(std::span<const RasterPart> parts) {
  std::vector<DrawnPositions> drawn;
  for (const RasterPart& part : parts) drawn.push_back({part.positions, part.indices});
  const BoundingSphere sphere = bounding_sphere(drawn);
  std::vector<PreparedPart> result;
  std::uint32_t first = 0;
  for (const RasterPart& part : parts) {
    result.push_back(prepared(part, sphere, first));
    first += static_cast<std::uint32_t>(part.indices.size() / 3);
  }
  return result;
}

}  // namespace foredraw
