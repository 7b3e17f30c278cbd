#include <foredraw/displaced/displaced_mesh.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/runtime/displaced_surface.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {

namespace {

/// Heights are read with so many bits: the sides of a seam agree in these.
constexpr std::uint32_t height_bits = 14;

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

struct Edge {
  std::uint32_t a, b;
  std::uint32_t side;  ///< 3t + e
};

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
  const std::vector<std::uint32_t> first = welded(positions);
  std::vector<TessellationLevels> levels(source.size() / 3);
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < levels.size(); ++t) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      const std::uint32_t a = source[3 * t + (e + 1) % 3], b = source[3 * t + (e + 2) % 3];
      const double u = double(places[a][0]) - places[b][0], v = double(places[a][1]) - places[b][1];
      const double parts = std::sqrt(u * u + v * v) / (256 * texels_per_part);
      float level = 1;
      while (level < 64 && 2 * level <= parts) level *= 2;
      levels[t].outer[e] = level;
      edges.push_back({std::min(first[a], first[b]), std::max(first[a], first[b]), 3 * t + e});
    }
  }
  std::ranges::sort(
      edges, [](const Edge& x, const Edge& y) { return std::tie(x.a, x.b, x.side) < std::tie(y.a, y.b, y.side); });
  const auto level_of = [&](const Edge& edge) -> float& { return levels[edge.side / 3].outer[edge.side % 3]; };
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    float most = 1;
    for (; end < edges.size() && edges[end].a == edges[begin].a && edges[end].b == edges[begin].b; ++end)
      most = std::max(most, level_of(edges[end]));
    for (std::size_t i = begin; i < end; ++i) level_of(edges[i]) = most;
  }
  for (TessellationLevels& of : levels) of.inner = *std::ranges::max_element(of.outer);
  return levels;
}

}  // namespace foredraw
