#include <foredraw/analysis/piece_proof.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw {

namespace {

double largest_distance(const TriangleCorners& from, const ConvexPiece& piece) {
  double most = 0;
  for (const glm::dvec3& corner : piece.corners()) most = std::max(most, squared_distance(from, corner));
  return std::sqrt(most);
}

}  // namespace

void PieceProof::tighten(BoundPiece& piece, std::uint32_t by) const {
  if (by == piece.by) return;
  const double bound = largest_distance(to_.corners(by), piece.shape);
  if (bound >= piece.bound) return;
  piece.bound = bound;
  piece.by = by;
}

void PieceProof::open_up(BoundPiece piece, FarthestShare& share, std::vector<BoundPiece>& pieces) const {
  const glm::dvec3 middle = piece.shape.middle();
  const Closest closest = ask(middle, piece.by, share);
  tighten(piece, closest.triangle);
  // No point is farther than the middle by more than its way from there, so what is small enough is always proved.
  piece.bound = std::min(piece.bound, closest.distance + piece.shape.reach_from(middle));
  if (piece.bound <= goal_.limit(share.result.found)) return pieces.push_back(std::move(piece));
  if (piece.shape.size() + 3 > ConvexPiece::most_corners) return fan_out(piece, pieces);
  if (!cut_out(piece, closest.triangle, share, pieces)) halve(piece, closest.triangle, pieces);
}

Closest PieceProof::ask(const glm::dvec3& point, std::uint32_t hint, FarthestShare& share) const {
  const Closest closest = to_.nearest(point, hint);
  ++share.result.questions;
  share.find(closest.distance, point);
  return closest;
}

/// Cuts along the triangle's outline, at right angles to it, where the piece is not much larger.
bool PieceProof::cut_out(const BoundPiece& piece, std::uint32_t near, FarthestShare& share,
                         std::vector<BoundPiece>& pieces) const {
  constexpr double much_larger = 16;
  const TriangleCorners t = to_.corners(near);
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  if (piece.shape.area() > much_larger * glm::length(normal)) return false;
  std::array<ConvexPiece, 3> outside;
  ConvexPiece inside = piece.shape;
  for (std::size_t e = 0; e < 3; ++e) {
    const glm::dvec3 outwards = glm::cross(t[(e + 1) % 3] - t[e], normal);
    CutPiece parts = cut(inside, outwards, glm::dot(outwards, t[e]), slack_of_cuts());
    if (parts.behind.size() == 0) return false;
    inside = parts.behind;
    outside[e] = parts.before;
  }
  bool is_cut = false;
  for (const ConvexPiece& part : outside) {
    if (part.size() == 0) continue;
    is_cut = true;
    pieces.push_back(part_of(piece, part, near));
  }
  if (!is_cut) return false;
  BoundPiece rest = part_of(piece, inside, near);
  if (rest.bound > goal_.limit(share.result.found)) {
    // Whether it is the triangle that is nearest to its farthest corner is then known.
    const TriangleCorners by = to_.corners(rest.by);
    const auto corners = rest.shape.corners();
    const auto farthest =
        std::ranges::max_element(corners, {}, [&](const glm::dvec3& corner) { return squared_distance(by, corner); });
    tighten(rest, ask(*farthest, rest.by, share).triangle);
    if (rest.bound > goal_.limit(share.result.found)) {
      halve(rest, near, pieces);
      return true;
    }
  }
  pieces.push_back(std::move(rest));
  return true;
}

void PieceProof::halve(const BoundPiece& piece, std::uint32_t near, std::vector<BoundPiece>& pieces) const {
  const glm::dvec3 across = piece.shape.longest();
  const CutPiece halves = cut(piece.shape, across, glm::dot(across, piece.shape.middle()), slack_of_cuts());
  if (halves.behind.size() == 0 || halves.before.size() == 0) return fan_out(piece, pieces);
  for (const ConvexPiece& half : {halves.before, halves.behind}) pieces.push_back(part_of(piece, half, near));
}

void PieceProof::fan_out(const BoundPiece& piece, std::vector<BoundPiece>& pieces) const {
  const auto corners = piece.shape.corners();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const TriangleCorners part{corners[0], corners[i - 1], corners[i]};
    pieces.push_back(part_of(piece, ConvexPiece(part), piece.by));
  }
}

BoundPiece PieceProof::part_of(const BoundPiece& piece, const ConvexPiece& shape, std::uint32_t near) const {
  BoundPiece part{shape, piece.bound, no_triangle};
  tighten(part, piece.by);
  tighten(part, near);
  if (part.by == no_triangle) part.by = piece.by;
  return part;
}

}  // namespace foredraw
