#include "piece_order.h"

#include <algorithm>
#include <numeric>

namespace foredraw {

constexpr std::uint32_t none = ~std::uint32_t{0};

PiecePlaces PiecePlaces::as_numbered(std::size_t pieces) {
  PiecePlaces places{std::vector<double>(pieces), std::vector<bool>(pieces, true), std::vector<CostOfJoining>(pieces),
                     std::vector<bool>(pieces, true)};
  std::iota(places.ranks.begin(), places.ranks.end(), 0);
  return places;
}

PieceOrder::PieceOrder(const Occlusions& occlusions, PiecePlaces& places)
    : occlusions_(occlusions), places_(places), step_of_(places.ranks.size(), 0) {}

void PieceOrder::add_step_of_list(std::uint32_t other, std::int64_t change) {
  std::uint32_t& number = step_of_[other];
  if (number == 0) {
    steps_.push_back({places_.ranks[other], other, true, change});
    number = static_cast<std::uint32_t>(steps_.size());
    return;
  }
  Step& step = steps_[number - 1];
  step.change += change;
  step.is_of_list = true;
}

void PieceOrder::find_steps(std::uint32_t piece) {
  const Occlusions& all = occlusions_;
  const std::vector<double>& ranks = places_.ranks;
  steps_.clear();
  for (std::uint32_t i = all.first_pair[piece]; i < all.first_pair[piece + 1]; ++i) {
    const auto& [other, net] = all.pairs[i];
    steps_.push_back({ranks[other], other, false, net});
  }
  if (all.first_list[piece] == all.first_list[piece + 1]) return;
  for (std::uint32_t i = 0; i < steps_.size(); ++i) step_of_[steps_[i].piece] = i + 1;
  for (std::uint32_t i = all.first_list[piece]; i < all.first_list[piece + 1]; ++i) {
    const std::uint32_t list = all.lists[i];
    const std::int64_t weight = all.weights[list];
    std::uint32_t earliest = none;  // of all others that are nearer
    bool is_nearer = false;         // the piece itself
    for (std::uint32_t layer = all.first_layer[list]; layer < all.first_layer[list + 1]; ++layer) {
      const std::uint32_t other = all.layers[layer];
      if (other == piece) {
        if (earliest != none) add_step_of_list(earliest, -weight);  // drawn after that one, it is hidden
        is_nearer = true;
      } else if (earliest == none || ranks[other] <= ranks[earliest]) {
        earliest = other;
        if (is_nearer) add_step_of_list(other, weight);  // drawn after it, the piece does not hide it
      }
    }
  }
  for (const Step& step : steps_) step_of_[step.piece] = 0;
}

void PieceOrder::costs_may_differ_around(std::uint32_t piece) {
  places_.may_differ[piece] = true;
  if (piece > 0) places_.may_differ[piece - 1] = true;
  if (piece + 1 < places_.ranks.size()) places_.may_differ[piece + 1] = true;
  for (const Step& step : steps_) places_.may_differ[step.piece] = true;
}

std::int64_t PieceOrder::improve_piece(std::uint32_t piece) {
  find_steps(piece);
  std::ranges::sort(steps_, {}, [](const Step& step) { return std::pair(step.rank, step.piece); });
  const double from = places_.ranks[piece];
  std::int64_t cost = 0, least = 0, now = 0;  // relative to before all steps
  std::size_t best = 0;                       // steps before the cheapest gap
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    cost += steps_[i].change;
    if (steps_[i].rank < from) now = cost;
    if (cost < least) {
      least = cost;
      best = i + 1;
    }
  }
  if (least == now) return 0;
  const double before = best == 0 ? steps_[0].rank - 2 : steps_[best - 1].rank;
  const double behind = best == steps_.size() ? before + 2 : steps_[best].rank;
  const double to = places_.ranks[piece] = (before + behind) / 2;
  costs_may_differ_around(piece);
  for (const Step& step : steps_) {
    // What lies between the two places costs the other one more by this, or less where it is drawn now before the
    // piece.
    const std::int64_t more = from < to ? step.change : -step.change;
    const bool is_between = (step.rank < from) != (step.rank < to);
    if (step.is_of_list || (is_between ? more > 0 : more < 0)) places_.may_move[step.piece] = true;
  }
  return now - least;
}

void PieceOrder::improve(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<std::uint32_t> pieces = order();
    // Places come close together where many pieces moved.
    for (std::size_t rank = 0; rank < pieces.size(); ++rank) places_.ranks[pieces[rank]] = static_cast<double>(rank);
    std::int64_t saved = 0;
    for (const std::uint32_t piece : pieces) {
      if (!places_.may_move[piece]) continue;
      places_.may_move[piece] = false;
      saved += improve_piece(piece);
    }
    if (saved == 0) break;
  }
}

void PieceOrder::unsettle(std::uint32_t piece) {
  find_steps(piece);
  costs_may_differ_around(piece);
  places_.may_move[piece] = true;
  for (const Step& step : steps_) places_.may_move[step.piece] = true;
}

const CostOfJoining& PieceOrder::cost_of_joining(std::uint32_t piece) {
  CostOfJoining& cost = places_.costs[piece];
  if (!places_.may_differ[piece]) return cost;
  places_.may_differ[piece] = false;
  find_steps(piece);
  const std::vector<double>& ranks = places_.ranks;
  const double from = ranks[piece];
  const double last = piece == 0 ? from : ranks[piece - 1];
  const double next = piece + 1 == ranks.size() ? from : ranks[piece + 1];
  cost = {};
  for (const Step& step : steps_) {
    if (step.rank < from) {
      cost.behind_last -= step.rank > last ? step.change : 0;
      cost.before_next -= step.rank >= next ? step.change : 0;
    } else {
      cost.behind_last += step.rank <= last ? step.change : 0;
      cost.before_next += step.rank < next ? step.change : 0;
    }
  }
  return cost;
}

std::vector<std::uint32_t> PieceOrder::order() const {
  const std::vector<double>& ranks = places_.ranks;
  std::vector<std::uint32_t> pieces(ranks.size());
  std::iota(pieces.begin(), pieces.end(), 0u);
  std::ranges::sort(pieces, {}, [&](std::uint32_t piece) { return std::pair(ranks[piece], piece); });
  return pieces;
}

}  // namespace foredraw
