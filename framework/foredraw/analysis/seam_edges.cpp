#include <foredraw/analysis/seam_edges.h>

#include <foredraw/analysis/welded_positions.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace foredraw {

namespace {

bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// Of the smaller point's: where it leads, and the number of its first corner among those of all meshes.
struct HalfEdge {
  std::uint32_t to;
  std::uint32_t corner;

  auto key() const { return std::tie(to, corner); }
};

/// Lists of points, one behind the other: [point] from starts[point] to starts[point + 1].
std::vector<std::uint32_t> starts_of(std::vector<std::uint32_t> counts) {
  std::uint32_t sum = 0;
  for (std::uint32_t& count : counts) sum += std::exchange(count, sum);
  counts.push_back(sum);
  return counts;
}

/// What the meshes' triangles say, one by one, for each point: a list that is sorted by points as it is made.
struct Collected {
  std::vector<std::uint32_t> first_corners;  ///< [mesh], among those of all
  std::vector<bool> is_reversed;             ///< [corner] whether its edge leads from the larger point to the smaller
  std::vector<std::uint32_t> edge_starts, wedge_starts;
  std::vector<HalfEdge> edges;
  std::vector<glm::vec2> wedges;  ///< uvs, one a vertex that a triangle uses, in the sequence of meshes and triangles
  std::size_t left_out = 0;
};

std::vector<std::uint32_t> points_of(std::span<const UvMesh> meshes) {
  if (meshes.size() == 1) return welded(meshes.front().positions);
  std::vector<glm::vec3> positions;
  for (const UvMesh& mesh : meshes) positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
  return welded(positions);
}

/// Goes over all triangles that are not left out.
class Triangles {
 public:
  explicit Triangles(std::span<const UvMesh> meshes) : meshes_(meshes), point_of_(points_of(meshes)) {}

  std::size_t points() const { return point_of_.size(); }

  /// edge(from, to, corner) of each side, and wedge(point, uv) of each vertex where it is met first. How many
  /// triangles are left out.
  template <class Edge, class Wedge>
  std::size_t visit(const std::atomic<bool>* cancel, const Edge& edge, const Wedge& wedge) const {
    std::size_t left_out = 0;
    std::uint32_t base = 0, first_corner = 0;
    for (const UvMesh& mesh : meshes_) {
      std::vector<bool> is_used(mesh.positions.size(), false);
      for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
        if (t % 4096 == 0 && is_cancelled(cancel)) return left_out;
        const std::uint32_t* v = &mesh.indices[3 * std::size_t{t}];
        const std::array point{point_of_[base + v[0]], point_of_[base + v[1]], point_of_[base + v[2]]};
        const bool is_usable = std::all_of(
            v, v + 3, [&](std::uint32_t one) { return is_finite(mesh.positions[one]) && is_finite(mesh.uvs[one]); });
        if (!is_usable || point[0] == point[1] || point[1] == point[2] || point[2] == point[0]) {
          ++left_out;
          continue;
        }
        for (std::uint32_t c = 0; c < 3; ++c) {
          edge(point[c], point[(c + 1) % 3], first_corner + 3 * t + c);
          if (is_used[v[c]]) continue;
          is_used[v[c]] = true;
          wedge(point[c], mesh.uvs[v[c]]);
        }
      }
      base += static_cast<std::uint32_t>(mesh.positions.size());
      first_corner += static_cast<std::uint32_t>(mesh.indices.size());
    }
    return left_out;
  }

 private:
  std::span<const UvMesh> meshes_;
  std::vector<std::uint32_t> point_of_;
};

Collected collected(std::span<const UvMesh> meshes, const std::atomic<bool>* cancel) {
  const Triangles triangles(meshes);
  Collected all;
  std::size_t corners = 0;
  for (const UvMesh& mesh : meshes) {
    all.first_corners.push_back(static_cast<std::uint32_t>(corners));
    corners += mesh.indices.size();
  }
  if (corners > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more than 2^32 - 1 indices on one map: give the draws maps of their own");
  all.is_reversed.resize(corners);
  std::vector<std::uint32_t> edges(triangles.points(), 0), wedges(triangles.points(), 0);
  all.left_out = triangles.visit(
      cancel, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) { ++edges[std::min(from, to)]; },
      [&](std::uint32_t point, const glm::vec2&) { ++wedges[point]; });
  all.edge_starts = starts_of(edges);
  all.wedge_starts = starts_of(wedges);
  all.edges.resize(all.edge_starts.back());
  all.wedges.resize(all.wedge_starts.back());
  std::copy_n(all.edge_starts.begin(), edges.size(), edges.begin());
  std::copy_n(all.wedge_starts.begin(), wedges.size(), wedges.begin());
  if (is_cancelled(cancel)) return all;
  triangles.visit(
      cancel,
      [&](std::uint32_t from, std::uint32_t to, std::uint32_t corner) {
        all.edges[edges[std::min(from, to)]++] = {std::max(from, to), corner};
        all.is_reversed[corner] = from > to;
      },
      [&](std::uint32_t point, const glm::vec2& uv) { all.wedges[wedges[point]++] = uv; });
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

void add_edges(Collected& all, std::span<const UvMesh> meshes, const std::atomic<bool>* cancel, SeamEdges& to) {
  for (std::uint32_t point = 0; point + 1 < all.edge_starts.size() && !is_cancelled(cancel); ++point) {
    const auto edges =
        std::span(all.edges).subspan(all.edge_starts[point], all.edge_starts[point + 1] - all.edge_starts[point]);
    std::ranges::sort(edges, {}, &HalfEdge::key);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
      while (end < edges.size() && edges[end].to == edges[i].to) ++end;
      const auto same = edges.subspan(i, end - i);
      if (same.size() > 2) ++to.of_many_faces;
      const EdgeSide first = side_of(same.front().corner, all, meshes);
      const bool is_seam = std::ranges::any_of(
          same.subspan(1), [&](const HalfEdge& other) { return side_of(other.corner, all, meshes).uv != first.uv; });
      if (!is_seam && same.size() > 1) continue;
      if (is_seam) ++to.seams;
      to.edges.push_back({{point, same.front().to},
                          is_seam ? EdgeKind::seam : EdgeKind::border,
                          static_cast<std::uint32_t>(to.sides.size()),
                          static_cast<std::uint32_t>(same.size())});
      for (const HalfEdge& one : same) to.sides.push_back(side_of(one.corner, all, meshes));
    }
  }
}

/// [uv] each once, the first of equal ones, in the sequence that they have.
void keep_first(std::vector<glm::vec2>& uvs) {
  std::vector<std::uint32_t> order(uvs.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t at) { return std::tuple(uvs[at].x, uvs[at].y, at); });
  const auto is_again = [&](std::uint32_t a, std::uint32_t b) { return uvs[a] == uvs[b]; };
  order.erase(std::unique(order.begin(), order.end(), is_again), order.end());
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) uvs[i] = uvs[order[i]];
  uvs.resize(order.size());
}

void add_corners(const Collected& all, const std::atomic<bool>* cancel, SeamEdges& to) {
  std::vector<glm::vec2> uvs;
  for (std::uint32_t point = 0; point + 1 < all.wedge_starts.size() && !is_cancelled(cancel); ++point) {
    const auto wedges =
        std::span(all.wedges).subspan(all.wedge_starts[point], all.wedge_starts[point + 1] - all.wedge_starts[point]);
    if (std::ranges::all_of(wedges, [&](const glm::vec2& uv) { return uv == wedges.front(); })) continue;
    uvs.assign(wedges.begin(), wedges.end());
    keep_first(uvs);
    to.corners.push_back({point, static_cast<std::uint32_t>(to.uvs.size()), static_cast<std::uint32_t>(uvs.size())});
    to.uvs.insert(to.uvs.end(), uvs.begin(), uvs.end());
  }
}

}  // namespace

SeamEdges seam_edges(std::span<const UvMesh> meshes, const std::atomic<bool>* cancel) {
  Collected all = collected(meshes, cancel);
  SeamEdges found;
  found.left_out = all.left_out;
  add_edges(all, meshes, cancel, found);
  all.edges = {};
  add_corners(all, cancel, found);
  return found;
}

}  // namespace foredraw
