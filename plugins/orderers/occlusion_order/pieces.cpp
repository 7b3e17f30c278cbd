#include "pieces.h"

#include <algorithm>
#include <utility>

namespace foredraw {

std::vector<Joint> joints_of(PieceOrder& order, std::span<const std::uint32_t> saved) {
  std::vector<Joint> joints;
  std::int64_t moving_first = order.cost_of_joining(0).before_next;
  for (std::uint32_t second = 1; second < saved.size(); ++second) {
    const auto [moving_second, before_next] = order.cost_of_joining(second);
    const std::int64_t cost = std::min(moving_first, moving_second);
    if (saved[second] > 0) {
      joints.push_back({static_cast<double>(cost) / saved[second], second, moving_second <= moving_first});
    }
    moving_first = before_next;
  }
  std::ranges::sort(joints, {}, [](const Joint& joint) { return std::pair(joint.price, joint.second); });
  return joints;
}

std::vector<std::uint32_t> Pieces::join(std::span<const Joint> joints, double wanted, std::size_t most) {
  auto& [ranks, may_move, costs, may_differ] = places;
  std::vector<bool> is_taken(ranks.size(), false), is_joined(ranks.size(), false);
  double saving = 0;
  for (const auto& [price, second, at_first] : joints) {
    if (saving >= wanted || most == 0) break;
    if (is_taken[second - 1] || is_taken[second]) continue;
    is_taken[second - 1] = is_taken[second] = is_joined[second] = true;
    if (!at_first) ranks[second - 1] = ranks[second];
    saving += saved[second];
    --most;
  }
  std::vector<std::uint32_t> joined;
  std::uint32_t count = 0;
  for (std::uint32_t piece = 0; piece < ranks.size(); ++piece) {
    if (!is_joined[piece]) {
      ranges.offsets[count] = ranges.offsets[piece];
      saved[count] = saved[piece];
      ranks[count] = ranks[piece];
      may_move[count] = may_move[piece];
      costs[count] = costs[piece];
      may_differ[count] = may_differ[piece];
      ++count;
    }
    joined.push_back(count - 1);
  }
  ranges.offsets[count] = ranges.offsets.back();
  ranges.offsets.resize(count + 1);
  saved.resize(count);
  ranks.resize(count);
  may_move.resize(count);
  costs.resize(count);
  may_differ.resize(count);
  return joined;
}

}  // namespace foredraw
