#include <foredraw/analysis/seam_edges.h>

#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace foredraw {

namespace {

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
bool is_finite(const glm::vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

struct HalfEdge {
  std::array<std::uint32_t, 2> points;
  std::uint32_t mesh, triangle;
  std::uint8_t corner;
  bool is_reversed;

  auto key() const { return std::tie(points, mesh, triangle, corner); }
};

struct Wedge {
  std::uint32_t point;
  std::uint32_t at;  ///< how many came before it
  glm::vec2 uv;
};

/// What the meshes' triangles say, one by one.
struct Collected {
  std::vector<HalfEdge> edges;
  std::vector<Wedge> wedges;  ///< one a vertex that a triangle uses
  std::size_t left_out = 0;
};

Collected collected(std::span<const UvMesh> meshes) {
  std::vector<glm::vec3> positions;
  for (const UvMesh& mesh : meshes) positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
  const std::vector<std::uint32_t> point_of = welded(positions);
  Collected all;
  std::uint32_t base = 0;
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    const UvMesh& mesh = meshes[m];
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
      const std::uint32_t* v = &mesh.indices[3 * std::size_t{t}];
      const std::array point{point_of[base + v[0]], point_of[base + v[1]], point_of[base + v[2]]};
      const bool is_usable = std::all_of(
          v, v + 3, [&](std::uint32_t one) { return is_finite(mesh.positions[one]) && is_finite(mesh.uvs[one]); });
      if (!is_usable || point[0] == point[1] || point[1] == point[2] || point[2] == point[0]) {
        ++all.left_out;
        continue;
      }
      for (std::uint8_t c = 0; c < 3; ++c) {
        const std::uint32_t from = point[c], to = point[(c + 1) % 3];
        all.edges.push_back({{std::min(from, to), std::max(from, to)}, m, t, c, from > to});
        if (is_used[v[c]]) continue;
        is_used[v[c]] = true;
        all.wedges.push_back({point[c], static_cast<std::uint32_t>(all.wedges.size()), mesh.uvs[v[c]]});
      }
    }
    base += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return all;
}

EdgeSide side_of(const HalfEdge& edge, const UvMesh& mesh) {
  const std::uint32_t* v = &mesh.indices[3 * std::size_t{edge.triangle}];
  EdgeSide side{edge.mesh,
                edge.triangle,
                edge.corner,
                edge.is_reversed,
                {mesh.uvs[v[edge.corner]], mesh.uvs[v[(edge.corner + 1) % 3]]}};
  if (edge.is_reversed) std::swap(side.uv[0], side.uv[1]);
  return side;
}

void add_edges(std::vector<HalfEdge>& edges, std::span<const UvMesh> meshes, SeamEdges& to) {
  std::ranges::sort(edges, {}, &HalfEdge::key);
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].points == edges[i].points) ++end;
    const auto count = static_cast<std::uint32_t>(end - i);
    if (count > 2) ++to.of_many_faces;
    const EdgeSide first = side_of(edges[i], meshes[edges[i].mesh]);
    const bool is_seam = std::any_of(edges.begin() + i + 1, edges.begin() + end, [&](const HalfEdge& other) {
      return side_of(other, meshes[other.mesh]).uv != first.uv;
    });
    if (!is_seam && count > 1) continue;
    if (is_seam) ++to.seams;
    to.edges.push_back({edges[i].points, is_seam ? EdgeKind::seam : EdgeKind::border,
                        static_cast<std::uint32_t>(to.sides.size()), count});
    for (; i < end; ++i) to.sides.push_back(side_of(edges[i], meshes[edges[i].mesh]));
  }
}

void add_corners(std::vector<Wedge>& wedges, SeamEdges& to) {
  std::ranges::sort(wedges, {}, [](const Wedge& w) { return std::tuple(w.point, w.uv.x, w.uv.y, w.at); });
  const auto is_again = [](const Wedge& a, const Wedge& b) { return a.point == b.point && a.uv == b.uv; };
  wedges.erase(std::unique(wedges.begin(), wedges.end(), is_again), wedges.end());
  std::ranges::sort(wedges, {}, [](const Wedge& w) { return std::tuple(w.point, w.at); });
  for (std::size_t i = 0, end = 0; i < wedges.size(); i = end) {
    while (end < wedges.size() && wedges[end].point == wedges[i].point) ++end;
    if (end - i < 2) continue;
    to.corners.push_back(
        {wedges[i].point, static_cast<std::uint32_t>(to.uvs.size()), static_cast<std::uint32_t>(end - i)});
    for (std::size_t w = i; w < end; ++w) to.uvs.push_back(wedges[w].uv);
  }
}

}  // namespace

SeamEdges seam_edges(std::span<const UvMesh> meshes) {
  Collected all = collected(meshes);
  SeamEdges found;
  found.left_out = all.left_out;
  add_edges(all.edges, meshes, found);
  add_corners(all.wedges, found);
  return found;
}

}  // namespace foredraw
