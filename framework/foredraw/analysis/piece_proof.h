#pragma once
// How far a piece of a surface is at most from another surface, and what to do where that is not enough.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/convex_piece.h>
#include <foredraw/analysis/farthest_distance.h>

#include <optional>
#include <vector>

namespace foredraw {

/// What is to be proved.
struct FarthestGoal {
  double tolerance = 0;
  double slack = 0;               ///< what floats can not tell
  std::optional<double> asked{};  ///< whether anything is farther than that, and nothing else

  /// A piece that is within it is of no more interest.
  double limit(double found) const { return (asked ? *asked : found * (1 + tolerance)) + slack; }
  /// Less than the whole slack, so that what is nearer than that can always be proved to be.
  bool is_beyond(double found) const { return asked && found > *asked + slack / 2; }
};

/// What a task found out. Tasks of a round know what the rounds before found, and nothing of each other.
struct FarthestShare {
  Farthest result;
  std::uint64_t most_questions = 0;

  void find(double distance, const glm::dvec3& at) {
    if (distance <= result.found) return;
    result.found = distance;
    result.at = at;
  }
};

/// A piece that lies within the bound of the other surface.
struct BoundPiece {
  ConvexPiece shape;
  double bound = std::numeric_limits<double>::infinity();
  std::uint32_t by = no_triangle;  ///< a triangle that is near
};

class PieceProof {
 public:
  PieceProof(const ClosestPoints& to, const FarthestGoal& goal) : to_(to), goal_(goal) {}

  /// By that triangle, if it proves more. The distance from a triangle is convex, so no point of the piece is farther
  /// from it than the piece's corners are.
  void tighten(BoundPiece& piece, std::uint32_t by) const;

  /// Proves more of a piece that is not within the limit, or parts it: what is left of it goes to `pieces`. Some
  /// questions, at most two.
  void open_up(BoundPiece piece, FarthestShare& share, std::vector<BoundPiece>& pieces) const;

 private:
  Closest ask(const glm::dvec3& point, std::uint32_t hint, FarthestShare& share) const;
  bool cut_out(const BoundPiece& piece, std::uint32_t near, FarthestShare& share,
               std::vector<BoundPiece>& pieces) const;
  void halve(const BoundPiece& piece, std::uint32_t near, std::vector<BoundPiece>& pieces) const;
  void fan_out(const BoundPiece& piece, std::vector<BoundPiece>& pieces) const;
  BoundPiece part_of(const BoundPiece& piece, const ConvexPiece& shape, std::uint32_t near) const;
  double slack_of_cuts() const { return goal_.slack * 0x1p-20; }

  const ClosestPoints& to_;
  const FarthestGoal& goal_;
};

}  // namespace foredraw
