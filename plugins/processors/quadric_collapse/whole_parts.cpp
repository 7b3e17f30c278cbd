#include "whole_parts.h"

#include <foredraw/geometry/joined_sets.h>

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw::processors::quadric_collapse {

namespace {

/// [point] = the least point of its piece.
std::vector<std::uint32_t> roots_of(const CollapsingMesh& mesh) {
  JoinedSets pieces(mesh.point_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const Face& face = mesh.face(f);
    for (const int k : {1, 2}) pieces.join(face.point[0], face.point[k]);
  }
  std::vector<std::uint32_t> roots(mesh.point_count());
  for (std::uint32_t p = 0; p < roots.size(); ++p) roots[p] = pieces.of(p);
  return roots;
}

/// Points by their roots, those of one root as they come.
std::vector<std::uint32_t> by_root(const std::vector<std::uint32_t>& root) {
  std::vector<std::uint32_t> next(root.size() + 1, 0), points(root.size());
  for (const std::uint32_t one : root) ++next[one + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t p = 0; p < root.size(); ++p) points[next[root[p]]++] = p;
  return points;
}

/// Of the box around those of the points that are finite.
double squared_diagonal(const CollapsingMesh& mesh, std::span<const std::uint32_t> points) {
  glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
  for (const std::uint32_t p : points) {
    if (mesh.point(p).is_fixed) continue;
    least = glm::min(least, glm::dvec3(mesh.point(p).place));
    most = glm::max(most, glm::dvec3(mesh.point(p).place));
  }
  return most.x >= least.x ? dot(most - least, most - least) : 0;
}

}  // namespace

WholeParts::WholeParts(const CollapsingMesh& mesh, double largest, std::span<const std::uint32_t> stream)
    : mesh_(mesh) {
  constexpr double distance = 0.6;  // from what is left, in diagonals
  const std::vector<std::uint32_t> root = roots_of(mesh);
  by_part_ = by_root(root);
  const double most = squared_diagonal(mesh, by_part_) * largest * largest;
  for (std::uint32_t first = 0; first < by_part_.size();) {
    Piece piece{first, first, 0};
    while (piece.end < by_part_.size() && root[by_part_[piece.end]] == root[by_part_[first]]) ++piece.end;
    first = piece.end;
    const auto points = std::span(by_part_).first(piece.end).subspan(piece.first);
    const double squared = squared_diagonal(mesh, points);
    if (!(squared <= most)) continue;
    double area = 0;
    for (const std::uint32_t p : points) {
      for (const std::uint32_t f : mesh.ring(p)) area += mesh.plane(f).area() / 3;
    }
    piece.cost = area * squared * distance * distance;
    if (piece.cost > 0 && can_vanish(piece, stream)) pieces_.push_back(piece);
  }
}

bool WholeParts::can_vanish(const Piece& piece, std::span<const std::uint32_t> stream) const {
  const auto is_fixed = [&](std::uint32_t p) { return mesh_.point(p).is_fixed; };
  if (std::any_of(by_part_.begin() + piece.first, by_part_.begin() + piece.end, is_fixed)) return false;
  if (stream.empty()) return true;
  const std::uint32_t one = stream[mesh_.name_of(by_part_[piece.first])];
  return std::all_of(by_part_.begin() + piece.first, by_part_.begin() + piece.end, [&](std::uint32_t p) {
    return std::ranges::all_of(mesh_.ring(p), [&](std::uint32_t f) {
      return stream[mesh_.face(f).vertex[mesh_.face(f).corner_of(p)]] == one;
    });
  });
}

bool WholeParts::is_all(std::size_t part, std::size_t faces_left) const {
  std::size_t corners = 0;
  for (std::uint32_t i = pieces_[part].first; i < pieces_[part].end; ++i) {
    if (!mesh_.point(by_part_[i]).is_gone) corners += mesh_.ring(by_part_[i]).size();
  }
  return corners == 3 * faces_left;
}

std::optional<WholeParts::Step> WholeParts::next(std::size_t part, std::vector<VertexPair>& pairs) {
  Piece& piece = pieces_[part];
  const auto is_done = [&](std::uint32_t p) { return mesh_.point(p).is_gone || mesh_.ring(p).empty(); };
  while (piece.first < piece.end && is_done(by_part_[piece.first])) ++piece.first;
  if (piece.first == piece.end) return std::nullopt;
  const std::uint32_t removed = by_part_[piece.first];
  const Face& first = mesh_.face(mesh_.ring(removed).front());
  const int k = first.corner_of(removed), other = (k + 1) % 3;
  const std::uint32_t kept = first.point[other];
  // Vertices become those that are beside them in a face, or else any.
  pairs.clear();
  const auto pair = [&](std::uint32_t from, std::uint32_t to) {
    if (std::ranges::find(pairs, from, &VertexPair::removed) == pairs.end()) pairs.push_back({from, to});
  };
  for (const std::uint32_t f : mesh_.ring(removed)) {
    const Face& face = mesh_.face(f);
    if (face.has(kept)) pair(face.vertex[face.corner_of(removed)], face.vertex[face.corner_of(kept)]);
  }
  for (const std::uint32_t f : mesh_.ring(removed)) {
    const Face& face = mesh_.face(f);
    pair(face.vertex[face.corner_of(removed)], first.vertex[other]);
  }
  return Step{removed, kept};
}

}  // namespace foredraw::processors::quadric_collapse
