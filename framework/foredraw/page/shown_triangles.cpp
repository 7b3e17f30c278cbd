#include <foredraw/page/shown_triangles.h>

#include <foredraw/geometry/box.h>
#include <foredraw/geometry/finite.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace foredraw {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

Box<glm::vec3> box_of(std::span<const glm::vec3> positions) {
  Box<glm::vec3> box;
  for (const glm::vec3& p : positions) {
    if (is_finite(p)) box.add(p);
  }
  return box;
}

/// [vertex] the first one in the same cell of a grid of so many cells along the longest edge.
std::vector<std::uint32_t> first_in_cell(std::span<const glm::vec3> positions, const Box<glm::vec3>& box,
                                         std::uint32_t cells) {
  const glm::vec3 extent = box.max - box.min;
  const float longest = std::max({extent.x, extent.y, extent.z});
  const float scale = longest > 0 ? static_cast<float>(cells) / longest : 0;
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  std::vector<std::uint32_t> result(positions.size(), nowhere);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (!is_finite(positions[v])) continue;
    const glm::vec3 place = (positions[v] - box.min) * scale;
    const auto cell = [&](float along) {
      return static_cast<std::uint64_t>(std::min(along, static_cast<float>(cells - 1)));
    };
    result[v] = first.try_emplace(cell(place.x) << 42 | cell(place.y) << 21 | cell(place.z), v).first->second;
  }
  return result;
}

using Corners = std::array<std::uint32_t, 3>;

/// Those of which all corners are somewhere.
template <class Wanted>
std::vector<std::uint32_t> triangles_with(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> vertex,
                                          Wanted is_wanted) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < indices.size() / 3; ++t) {
    const Corners corners = {vertex[indices[3 * t]], vertex[indices[3 * t + 1]], vertex[indices[3 * t + 2]]};
    if (std::ranges::find(corners, nowhere) == corners.end() && is_wanted(corners)) triangles.push_back(t);
  }
  return triangles;
}

/// Those with three corners apart.
std::vector<std::uint32_t> unflattened(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> vertex) {
  return triangles_with(indices, vertex, [](const Corners& corners) {
    return corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
  });
}

std::vector<std::uint32_t> every_finite(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> vertex(positions.size());
  for (std::uint32_t v = 0; v < vertex.size(); ++v) vertex[v] = is_finite(positions[v]) ? v : nowhere;
  return vertex;
}

}  // namespace

ShownTriangles shown_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               std::size_t at_most) {
  std::vector<std::uint32_t> vertex = every_finite(positions);
  ShownTriangles shown;
  shown.triangles = triangles_with(indices, vertex, [](const Corners&) { return true; });
  if (shown.triangles.size() > at_most) shown.triangles = unflattened(indices, vertex);
  if (shown.triangles.size() > at_most) {
    const Box<glm::vec3> box = box_of(positions);
    std::uint32_t few = 1, many = 1u << 20;  // cells: `few` leave few enough
    while (many - few > std::max(few / 50, 1u)) {
      const std::uint32_t cells = few + (many - few) / 2;
      (unflattened(indices, first_in_cell(positions, box, cells)).size() > at_most ? many : few) = cells;
    }
    vertex = first_in_cell(positions, box, few);
    shown.triangles = unflattened(indices, vertex);
  }
  for (const std::uint32_t t : shown.triangles) {
    for (std::size_t corner = 3 * std::size_t{t}; corner < 3 * std::size_t{t} + 3; ++corner) {
      shown.indices.push_back(vertex[indices[corner]]);
    }
  }
  shown.vertices = shown.indices;
  std::ranges::sort(shown.vertices);
  shown.vertices.erase(std::unique(shown.vertices.begin(), shown.vertices.end()), shown.vertices.end());
  std::vector<std::uint32_t> place(positions.size(), nowhere);
  for (std::uint32_t i = 0; i < shown.vertices.size(); ++i) place[shown.vertices[i]] = i;
  for (std::uint32_t& index : shown.indices) index = place[index];
  return shown;
}

ShownTriangles ShownTrianglesOnce::of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                      std::size_t at_most) {
  if (indices.size() / 3 <= at_most) return shown_triangles(positions, indices, at_most);
  const Stamp stamps[] = {content_hash(positions), content_hash(indices, at_most)};
  const auto [found, is_new] = found_.try_emplace(combine(stamps));
  if (is_new) found->second = shown_triangles(positions, indices, at_most);
  return found->second;
}

}  // namespace foredraw
