#include <foredraw/analysis/seam_edges.h>

#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace foredraw {

namespace {

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
bool is_finite(const glm::vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Known by the number of its first corner among those of all meshes.
struct HalfEdge {
  std::array<std::uint32_t, 2> points;
  std::uint32_t corner;

  auto key() const { return std::tie(points, corner); }
};

struct Wedge {
  std::uint32_t point;
  std::uint32_t at;  ///< how many came before it
  glm::vec2 uv;
};

/// What the meshes' triangles say, one by one.
struct Collected {
  std::vector<std::uint32_t> first_corners;  ///< [mesh], among those of all
  std::vector<bool> is_reversed;             ///< [corner] whether its edge leads from the larger point to the smaller
  std::vector<HalfEdge> edges;
  std::vector<Wedge> wedges;  ///< one a vertex that a triangle uses
  std::size_t left_out = 0;
};

std::vector<std::uint32_t> points_of(std::span<const UvMesh> meshes) {
  if (meshes.size() == 1) return welded(meshes.front().positions);
  std::vector<glm::vec3> positions;
  for (const UvMesh& mesh : meshes) positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
  return welded(positions);
}

Collected collected(std::span<const UvMesh> meshes) {
  const std::vector<std::uint32_t> point_of = points_of(meshes);
  Collected all;
  std::size_t corners = 0;
  for (const UvMesh& mesh : meshes) {
    all.first_corners.push_back(static_cast<std::uint32_t>(corners));
    corners += mesh.indices.size();
  }
  if (corners > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more than 2^32 - 1 indices on one map: give the draws maps of their own");
  all.edges.reserve(corners);
  all.wedges.reserve(point_of.size());
  all.is_reversed.resize(corners);
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
        const std::uint32_t corner = all.first_corners[m] + 3 * t + c;
        all.edges.push_back({{std::min(from, to), std::max(from, to)}, corner});
        all.is_reversed[corner] = from > to;
        if (is_used[v[c]]) continue;
        is_used[v[c]] = true;
        all.wedges.push_back({point[c], static_cast<std::uint32_t>(all.wedges.size()), mesh.uvs[v[c]]});
      }
    }
    base += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return all;
}

EdgeSide side_of(std::uint32_t corner, const Collected& all, std::span<const UvMesh> meshes) {
  const auto mesh = std::ranges::upper_bound(all.first_corners, corner) - all.first_corners.begin() - 1;
  const auto of_mesh = corner - all.first_corners[static_cast<std::size_t>(mesh)];
  const UvMesh& from = meshes[static_cast<std::size_t>(mesh)];
  const std::uint32_t triangle = of_mesh / 3, first = of_mesh % 3;
  const std::uint32_t* v = &from.indices[3 * std::size_t{triangle}];
  EdgeSide side{static_cast<std::uint32_t>(mesh),
                triangle,
                static_cast<std::uint8_t>(first),
                all.is_reversed[corner],
                {from.uvs[v[first]], from.uvs[v[(first + 1) % 3]]}};
  if (side.is_reversed) std::swap(side.uv[0], side.uv[1]);
  return side;
}

void add_edges(Collected& all, std::span<const UvMesh> meshes, SeamEdges& to) {
  std::vector<HalfEdge>& edges = all.edges;
  std::ranges::sort(edges, {}, &HalfEdge::key);
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].points == edges[i].points) ++end;
    const auto count = static_cast<std::uint32_t>(end - i);
    if (count > 2) ++to.of_many_faces;
    const EdgeSide first = side_of(edges[i].corner, all, meshes);
    const bool is_seam = std::any_of(edges.begin() + i + 1, edges.begin() + end, [&](const HalfEdge& other) {
      return side_of(other.corner, all, meshes).uv != first.uv;
    });
    if (!is_seam && count > 1) continue;
    if (is_seam) ++to.seams;
    to.edges.push_back({edges[i].points, is_seam ? EdgeKind::seam : EdgeKind::border,
                        static_cast<std::uint32_t>(to.sides.size()), count});
    for (; i < end; ++i) to.sides.push_back(side_of(edges[i].corner, all, meshes));
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
  add_edges(all, meshes, found);
  all.edges = {};
  add_corners(all.wedges, found);
  return found;
}

}  // namespace foredraw
