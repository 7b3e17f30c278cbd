#include "piece_order.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw {

constexpr std::uint32_t none = ~std::uint32_t{0};

PieceOrder::PieceOrder(const Occlusions& occlusions, std::vector<double> ranks)
    : occlusions_(occlusions),
      ranks_(std::move(ranks)),
      may_move_(ranks_.size(), true),
      change_(ranks_.size(), 0),
      is_step_(ranks_.size(), false) {}

void PieceOrder::add_step(std::uint32_t other, std::int64_t change) {
  if (!is_step_[other]) {
    is_step_[other] = true;
    change_[other] = 0;
    steps_.push_back(other);
  }
  change_[other] += change;
}

void PieceOrder::find_steps(std::uint32_t piece) {
  const Occlusions& all = occlusions_;
  for (const std::uint32_t other : steps_) is_step_[other] = false;
  steps_.clear();
  for (std::uint32_t i = all.first_pair[piece]; i < all.first_pair[piece + 1]; ++i) {
    add_step(all.pairs[i].other, all.pairs[i].net);
  }
  for (std::uint32_t i = all.first_list[piece]; i < all.first_list[piece + 1]; ++i) {
    const std::uint32_t list = all.lists[i];
    const std::int64_t weight = all.weights[list];
    std::uint32_t earliest = none;  // of all others that are nearer
    bool is_nearer = false;         // the piece itself
    for (std::uint32_t layer = all.first_layer[list]; layer < all.first_layer[list + 1]; ++layer) {
      const std::uint32_t other = all.layers[layer];
      if (other == piece) {
        if (earliest != none) add_step(earliest, -weight);  // drawn after that one, it is hidden
        is_nearer = true;
      } else if (earliest == none || ranks_[other] <= ranks_[earliest]) {
        earliest = other;
        if (is_nearer) add_step(other, weight);  // drawn after it, the piece does not hide it
      }
    }
  }
}

std::int64_t PieceOrder::improve_piece(std::uint32_t piece) {
  find_steps(piece);
  std::ranges::sort(steps_, {}, [&](std::uint32_t other) { return std::pair(ranks_[other], other); });
  std::int64_t cost = 0, least = 0, now = 0;  // relative to before all steps
  std::size_t best = 0;                       // steps before the cheapest gap
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    cost += change_[steps_[i]];
    if (ranks_[steps_[i]] < ranks_[piece]) now = cost;
    if (cost < least) {
      least = cost;
      best = i + 1;
    }
  }
  if (least == now) return 0;
  const double before = best == 0 ? ranks_[steps_[0]] - 2 : ranks_[steps_[best - 1]];
  const double behind = best == steps_.size() ? before + 2 : ranks_[steps_[best]];
  ranks_[piece] = (before + behind) / 2;
  for (const std::uint32_t other : steps_) may_move_[other] = true;
  return now - least;
}

void PieceOrder::improve(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<std::uint32_t> pieces = order();
    // Places come close together where many pieces moved.
    for (std::size_t rank = 0; rank < pieces.size(); ++rank) ranks_[pieces[rank]] = static_cast<double>(rank);
    std::int64_t saved = 0;
    for (const std::uint32_t piece : pieces) {
      if (!may_move_[piece]) continue;
      may_move_[piece] = false;
      saved += improve_piece(piece);
    }
    if (saved == 0) break;
  }
}

PieceOrder::CostOfJoining PieceOrder::cost_of_joining(std::uint32_t piece) {
  find_steps(piece);
  const double from = ranks_[piece];
  const double last = piece == 0 ? from : ranks_[piece - 1];
  const double next = piece + 1 == ranks_.size() ? from : ranks_[piece + 1];
  CostOfJoining cost;
  for (const std::uint32_t other : steps_) {
    const double at = ranks_[other];
    const std::int64_t change = change_[other];
    if (at < from) {
      cost.behind_last -= at > last ? change : 0;
      cost.before_next -= at >= next ? change : 0;
    } else {
      cost.behind_last += at <= last ? change : 0;
      cost.before_next += at < next ? change : 0;
    }
  }
  return cost;
}

std::vector<std::uint32_t> PieceOrder::order() const {
  std::vector<std::uint32_t> pieces(ranks_.size());
  std::iota(pieces.begin(), pieces.end(), 0u);
  std::ranges::sort(pieces, {}, [&](std::uint32_t piece) { return std::pair(ranks_[piece], piece); });
  return pieces;
}

}  // namespace foredraw
