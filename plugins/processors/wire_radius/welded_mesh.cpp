#include "welded_mesh.h"

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/geometry/triangle_area.h>

#include <algorithm>

namespace foredraw::processors::wire_radius {

namespace {

void add_points(std::span<const glm::vec3> positions, WeldedMesh& mesh) {
  const std::vector<std::uint32_t> first = welded(positions);
  mesh.point_of.resize(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (first[v] == v) {
      mesh.point_of[v] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.emplace_back(positions[v]);
    } else {
      mesh.point_of[v] = mesh.point_of[first[v]];
    }
  }
}

struct Keyed {
  std::array<std::uint32_t, 3> key;
  std::uint32_t number;
  auto operator<=>(const Keyed&) const = default;
};

void add_triangles(std::span<const std::uint32_t> indices, WeldedMesh& mesh) {
  std::vector<Keyed> order;
  mesh.triangle_of.assign(indices.size() / 3, none);
  for (std::uint32_t t = 0; t < mesh.triangle_of.size(); ++t) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.point_of[indices[3 * std::size_t{t} + i]];
    std::ranges::sort(corners);
    const bool is_one = corners[0] != corners[1] && corners[1] != corners[2] &&
                        std::ranges::all_of(corners, [&](std::uint32_t p) { return is_finite(mesh.points[p]); });
    if (is_one) order.push_back({corners, t});
  }
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_copy = i > 0 && order[i].key == order[i - 1].key;
    mesh.triangle_of[order[i].number] = is_copy ? mesh.triangle_of[order[i - 1].number] : order[i].number;
  }
  std::vector<std::uint32_t> number(mesh.triangle_of.size(), none);
  for (std::uint32_t t = 0; t < mesh.triangle_of.size(); ++t) {
    std::uint32_t& of = mesh.triangle_of[t];
    if (of == none) continue;
    if (of == t) {
      number[t] = static_cast<std::uint32_t>(mesh.triangles.size());
      const std::uint32_t* corner = &indices[3 * std::size_t{t}];
      mesh.triangles.push_back({mesh.point_of[corner[0]], mesh.point_of[corner[1]], mesh.point_of[corner[2]]});
    }
    of = number[of];
  }
}

void add_neighbours(WeldedMesh& mesh) {
  struct Edge {
    std::uint32_t low, high, triangle, edge;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3]);
      edges.push_back({low, high, t, e});
    }
  }
  std::ranges::sort(edges);
  mesh.across.assign(mesh.triangles.size(), {none, none, none});
  JoinedSets shells(mesh.triangles.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 2) {
      mesh.across[edges[i].triangle][edges[i].edge] = edges[i + 1].triangle;
      mesh.across[edges[i + 1].triangle][edges[i + 1].edge] = edges[i].triangle;
      shells.join(edges[i].triangle, edges[i + 1].triangle);
    }
    i = end;
  }
  mesh.shell.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t first = shells.of(t);
    if (first == t) {
      mesh.shell[t] = static_cast<std::uint32_t>(mesh.shell_area.size());
      mesh.shell_area.push_back(0);
    } else {
      mesh.shell[t] = mesh.shell[first];
    }
    const auto& [a, b, c] = mesh.triangles[t];
    mesh.shell_area[mesh.shell[t]] += triangle_area(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
}

}  // namespace

WeldedMesh weld_mesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  WeldedMesh mesh;
  add_points(positions, mesh);
  add_triangles(indices, mesh);
  add_neighbours(mesh);
  return mesh;
}

}  // namespace foredraw::processors::wire_radius
