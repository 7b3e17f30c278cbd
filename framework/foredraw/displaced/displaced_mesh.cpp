#include <foredraw/displaced/displaced_mesh.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/displaced/height_bits.h>
#include <foredraw/displaced/shared_edges.h>
#include <foredraw/displaced/stored_levels.h>
#include <foredraw/runtime/displaced_surface.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {

namespace {

float displacement_at(const std::array<std::array<std::int32_t, 2>, 3>& corners,
                      const std::array<std::uint32_t, 3>& weights, const foredraw_height_map& map, float factor,
                      float offset) {
  std::int32_t place[2];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::int32_t along[3] = {corners[0][axis], corners[1][axis], corners[2][axis]};
    place[axis] = foredraw_height_between(along, weights.data());
  }
  const std::uint32_t height = foredraw_displaced_height(&map, place[0], place[1], height_bits);
  return offset + factor * foredraw_height_part(height, height_bits);
}

}  // namespace

std::vector<float> displacements(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                 std::span<const std::array<std::int32_t, 2>> places, const foredraw_height_map& map,
                                 float factor, float offset) {
  std::vector<float> result;
  result.reserve(mesh.vertices());
  for (std::uint32_t v = 0; v < mesh.kept; ++v) {
    result.push_back(displacement_at({places[v], places[v], places[v]}, {weight_one, 0, 0}, map, factor, offset));
  }
  for (const SurfaceSample& sample : mesh.samples) {
    const std::span<const std::uint32_t> corners = source.subspan(3 * std::size_t{sample.triangle}, 3);
    result.push_back(displacement_at({places[corners[0]], places[corners[1]], places[corners[2]]}, sample.at.weights(),
                                     map, factor, offset));
  }
  return result;
}

std::vector<float> height_displacements(std::span<const std::uint16_t> heights, std::uint32_t bits, float factor,
                                        float offset) {
  std::vector<float> result;
  result.reserve(heights.size());
  for (const std::uint16_t height : heights) result.push_back(offset + factor * foredraw_height_part(height, bits));
  return result;
}

TessellatedMesh tessellated_mesh(const DrawHeights& heights, const Level& level) {
  const auto indices = level.stream().indices.view();
  const auto levels = baked_levels(heights.levels.view(), indices, decode_vec3(*level.vertices->find("POSITION")));
  return tessellated_mesh(indices, level.vertices->count, levels, TessellationSpacing::equal);
}

std::vector<glm::vec3> displaced_positions(const TessellatedMesh& mesh, std::span<const std::uint32_t> source,
                                           std::span<const glm::vec3> positions, std::span<const glm::vec3> directions,
                                           std::span<const float> displacements) {
  std::vector<glm::vec3> result(mesh.vertices());
  const auto point = [&](const std::array<std::uint32_t, 3>& corners, const std::array<float, 3>& weights,
                         std::size_t vertex) {
    float position[3][3], direction[3][3];
    for (std::size_t c = 0; c < 3; ++c) {
      std::memcpy(position[c], &positions[corners[c]], sizeof(position[c]));
      std::memcpy(direction[c], &directions[corners[c]], sizeof(direction[c]));
    }
    foredraw_displaced_point(position, direction, weights.data(), displacements[vertex], &result[vertex].x);
  };
  for (std::uint32_t v = 0; v < mesh.kept; ++v) point({v, v, v}, {1, 0, 0}, v);
  for (std::size_t s = 0; s < mesh.samples.size(); ++s) {
    const SurfaceSample& sample = mesh.samples[s];
    const std::uint32_t* corners = &source[3 * std::size_t{sample.triangle}];
    point({corners[0], corners[1], corners[2]}, sample.at.coordinates(), mesh.kept + s);
  }
  return result;
}

std::vector<TessellationLevels> levels_by_texels(std::span<const std::uint32_t> source,
                                                 std::span<const glm::vec3> positions,
                                                 std::span<const std::array<std::int32_t, 2>> places,
                                                 double texels_per_part) {
  std::vector<float> sides(source.size());
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const EdgeEnds ends = edge_ends(source, side);
    const auto &a = places[ends.from], &b = places[ends.to];
    const double u = double(a[0]) - b[0], v = double(a[1]) - b[1];
    const double parts = std::sqrt(u * u + v * v) / (256 * texels_per_part);
    sides[side] = 1;
    while (sides[side] < 64 && 2 * sides[side] <= parts) sides[side] *= 2;
  }
  const std::vector<std::uint32_t> first = edges_at_places(source, positions);
  for (std::size_t side = 0; side < sides.size(); ++side)
    sides[first[side]] = std::min(sides[first[side]], sides[side]);
  std::vector<TessellationLevels> levels(source.size() / 3);
  for (std::size_t side = 0; side < sides.size(); ++side) levels[side / 3].outer[side % 3] = sides[first[side]];
  for (TessellationLevels& of : levels) of.inner = *std::ranges::max_element(of.outer);
  return levels;
}

std::vector<std::uint32_t> edges_at_places(std::span<const std::uint32_t> source,
                                           std::span<const glm::vec3> positions) {
  const std::vector<std::uint32_t> first = welded(positions);
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t corner : source) corners.push_back(first[corner]);
  return first_edges(corners, static_cast<std::uint32_t>(positions.size()));
}

}  // namespace foredraw
