#pragma once
// A queue of edges by cost that is cheap rather than exact: costs within an eighth of an octave are alike. What came
// last among them goes first, as its neighbourhood is still at hand.

#include "smooth_edges.h"

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace foredraw::collapsing {

struct EdgeEntry {
  double cost = 0;     ///< where it is least
  glm::vec3 place{0};  ///< there
  std::uint32_t p = 0, q = 0;
  std::uint32_t moves = 0;           ///< of both points, when the cost was reckoned
  std::uint32_t changes : 31 = 0;    ///< of both points
  std::uint32_t is_checked : 1 = 0;  ///< the surface moves farther than the cost says, and the rank counts that
};

class CostQueue {
 public:
  static std::size_t rank_of(double cost) { return std::bit_cast<std::uint64_t>(cost > 0 ? cost : 0.0) >> 49; }

  void push(double cost, const EdgeEntry& entry) {
    const std::size_t rank = rank_of(cost);
    if (rank >= tops_.size()) tops_.resize(rank + 1, none);
    std::uint32_t& top = tops_[rank];
    if (top == none || blocks_[top].size == Block::most) top = block_on(top);
    Block& block = blocks_[top];
    block.entries[block.size++] = entry;
    if (rank < lowest_) lowest_ = rank;
  }

  std::optional<EdgeEntry> pop() {
    while (lowest_ < tops_.size() && tops_[lowest_] == none) ++lowest_;
    if (lowest_ >= tops_.size()) return std::nullopt;
    std::uint32_t& top = tops_[lowest_];
    Block& block = blocks_[top];
    const EdgeEntry entry = block.entries[--block.size];
    if (block.size == 0) {
      free_.push_back(top);
      top = block.below;
    }
    return entry;
  }

  /// The rank of what pop() answered with last.
  std::size_t lowest() const { return lowest_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Block {
    static constexpr std::uint32_t most = 31;
    std::array<EdgeEntry, most> entries;
    std::uint32_t size = 0;
    std::uint32_t below = none;  ///< of the same rank
  };

  std::uint32_t block_on(std::uint32_t below) {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(blocks_.size()));
      blocks_.emplace_back();
    }
    const std::uint32_t block = free_.back();
    free_.pop_back();
    blocks_[block].size = 0;
    blocks_[block].below = below;
    return block;
  }

  std::vector<std::uint32_t> tops_;  ///< [rank] the block that was begun last
  std::deque<Block> blocks_;
  std::vector<std::uint32_t> free_;
  std::size_t lowest_ = 0;
};

}  // namespace foredraw::collapsing
