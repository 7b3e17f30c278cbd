#pragma once
// An order of pieces that is bettered by moving one of them at a time.

#include "occlusions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

class PieceOrder {
 public:
  /// Each piece at its place: [piece], in any numbers that differ. The occlusions are only referred to.
  PieceOrder(const Occlusions& occlusions, std::vector<double> ranks);

  const std::vector<double>& ranks() const { return ranks_; }

  /// Moves every piece to where it costs least, everything else left where it is, again and again until nothing falls
  /// or it was done so many times.
  void improve(int sweeps);

  /// What it costs to draw the piece directly behind the one before it by number, and directly before the one after it.
  struct CostOfJoining {
    std::int64_t behind_last = 0;
    std::int64_t before_next = 0;
  };
  CostOfJoining cost_of_joining(std::uint32_t piece);

  /// The pieces as they are drawn.
  std::vector<std::uint32_t> order() const;

 private:
  void add_step(std::uint32_t other, std::int64_t change);
  void find_steps(std::uint32_t piece);
  std::int64_t improve_piece(std::uint32_t piece);

  const Occlusions& occlusions_;
  std::vector<double> ranks_;
  std::vector<bool> may_move_;  // [piece] whether anything it has to do with was moved since it was looked at
  // As a piece moves backwards past one of `steps_`, what it costs changes by change_[that].
  std::vector<std::uint32_t> steps_;
  std::vector<std::int64_t> change_;
  std::vector<bool> is_step_;
};

}  // namespace foredraw
