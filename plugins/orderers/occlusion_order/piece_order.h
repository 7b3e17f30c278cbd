#pragma once
// An order of pieces that is bettered by moving one of them at a time.

#include "occlusions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// What it costs to draw a piece directly behind the one before it by number, and directly before the one after it.
struct CostOfJoining {
  std::int64_t behind_last = 0;
  std::int64_t before_next = 0;
};

/// Where the pieces are, and what is known of them; kept from one search to the next.
struct PiecePlaces {
  std::vector<double> ranks;         ///< [piece] its place, in any numbers that differ
  std::vector<bool> may_move;        ///< [piece] whether anything it has to do with was moved since it was looked at
  std::vector<CostOfJoining> costs;  ///< [piece] as they were when last asked
  std::vector<bool> may_differ;      ///< [piece] whether they may have changed since

  /// Each at its number, and nothing known.
  static PiecePlaces as_numbered(std::size_t pieces);
};

class PieceOrder {
 public:
  /// Both are only referred to, and the places are changed.
  PieceOrder(const Occlusions& occlusions, PiecePlaces& places);

  /// Moves every piece to where it costs least, everything else left where it is, again and again until nothing falls
  /// or it was done so many times. Pieces that may not move are left.
  void improve(int sweeps);

  /// To be called of pieces that are not what they were: they may move, and so may all that they have to do with.
  void unsettle(std::uint32_t piece);

  const CostOfJoining& cost_of_joining(std::uint32_t piece);

  /// The pieces as they are drawn.
  std::vector<std::uint32_t> order() const;

 private:
  /// As a piece moves backwards past another one, what it costs changes.
  struct Step {
    double rank;
    std::uint32_t piece;
    bool is_of_list;  ///< what it costs the other one depends on more pieces
    std::int64_t change;
  };

  void add_step_of_list(std::uint32_t other, std::int64_t change);
  void find_steps(std::uint32_t piece);
  std::int64_t improve_piece(std::uint32_t piece);
  void costs_may_differ_around(std::uint32_t piece);

  const Occlusions& occlusions_;
  PiecePlaces& places_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> step_of_;  // [piece] 1 + its number among the steps while they are found, else 0
};

}  // namespace foredraw
