#include <foredraw/viewing/raster_part.h>

#include <foredraw/geometry/finite.h>
#include <foredraw/viewing/bounding_sphere.h>

#include <utility>

namespace foredraw {

namespace {

bool is_drawable(const RasterPart& part, const std::array<std::uint32_t, 3>& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(part.positions[t[0]]) &&
         is_finite(part.positions[t[1]]) && is_finite(part.positions[t[2]]);
}

template <class T>
void pad(std::vector<T>& values) {
  values.resize((values.size() + PreparedPart::padding - 1) / PreparedPart::padding * PreparedPart::padding);
}

PreparedPart prepared(const RasterPart& part, const BoundingSphere& sphere, std::uint32_t first) {
  PreparedPart result;
  result.culls_back_faces = part.culls_back_faces;
  result.mask = part.mask;
  for (const glm::vec3& position : part.positions) {
    const bool has_place = is_finite(position) && sphere.radius > 0;
    const glm::dvec3 place = has_place ? (glm::dvec3(position) - sphere.centre) / sphere.radius : glm::dvec3(0);
    for (int axis = 0; axis < 3; ++axis) result.positions[static_cast<std::size_t>(axis)].push_back(place[axis]);
  }
  for (std::uint32_t i = 0; i < part.indices.size() / 3; ++i) {
    std::array<std::uint32_t, 3> corners = {part.indices[3 * i], part.indices[3 * i + 1], part.indices[3 * i + 2]};
    if (!is_drawable(part, corners)) continue;
    if (part.is_mirrored) std::swap(corners[1], corners[2]);
    for (std::size_t corner = 0; corner < 3; ++corner) result.corners[corner].push_back(corners[corner]);
    result.numbers.push_back(first + (part.owners.empty() ? i : part.owners[i]));
  }
  for (std::vector<double>& axis : result.positions) pad(axis);
  for (std::vector<std::uint32_t>& corner : result.corners) pad(corner);
  pad(result.numbers);
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
    first += static_cast<std::uint32_t>(part.triangle_count());
  }
  return result;
}

}  // namespace foredraw
