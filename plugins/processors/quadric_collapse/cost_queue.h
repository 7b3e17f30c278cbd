#pragma once
// A queue of edges by cost that is cheap rather than exact: costs within an eighth of an octave are alike. What came
// last among them goes first, as its neighbourhood is still at hand.

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace foredraw::processors::quadric_collapse {

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
  static constexpr std::size_t ranks = std::size_t{1} << 14;
  /// Below `ranks`.
  static std::size_t rank_of(double cost) { return std::bit_cast<std::uint64_t>(cost > 0 ? cost : 0.0) >> 49; }

  void push(std::size_t rank, const EdgeEntry& entry) {
    if (tops_.empty()) tops_.resize(ranks, none);
    std::uint32_t& top = tops_[rank];
    if (top == none || blocks_[top].size == Block::most) top = block_on(top);
    Block& block = blocks_[top];
    block.entries[block.size++] = entry;
    used_[rank / 64] |= std::uint64_t{1} << rank % 64;
    lowest_ = std::min(lowest_, rank);
  }

  /// Of one of the lowest rank, if that is at most `most`.
  std::optional<EdgeEntry> pop(std::size_t most = ranks) {
    lowest_ = next_rank(lowest_);
    if (lowest_ >= ranks || lowest_ > most) return std::nullopt;
    std::uint32_t& top = tops_[lowest_];
    Block& block = blocks_[top];
    const EdgeEntry entry = block.entries[--block.size];
    if (block.size == 0) {
      free_.push_back(top);
      top = block.below;
      if (top == none) used_[lowest_ / 64] &= ~(std::uint64_t{1} << lowest_ % 64);
    }
    return entry;
  }

  /// The rank of what pop() answered with last.
  std::size_t lowest() const { return lowest_; }

  /// The lowest rank of all; `ranks`: it is empty.
  std::size_t next() const { return next_rank(lowest_); }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Block {
    static constexpr std::uint32_t most = 15;
    std::array<EdgeEntry, most> entries;
    std::uint32_t size = 0;
    std::uint32_t below = none;  ///< of the same rank
  };

  /// The lowest one from there on that has an entry; `ranks`: none has.
  std::size_t next_rank(std::size_t from) const {
    if (from >= ranks) return ranks;
    std::uint64_t word = used_[from / 64] >> from % 64 << from % 64;
    for (std::size_t i = from / 64;;) {
      if (word != 0) return 64 * i + static_cast<std::size_t>(std::countr_zero(word));
      if (++i == used_.size()) return ranks;
      word = used_[i];
    }
  }

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

  std::vector<std::uint32_t> tops_;               ///< [rank] the block that was begun last
  std::array<std::uint64_t, ranks / 64> used_{};  ///< bit of a rank: it has entries
  std::deque<Block> blocks_;
  std::vector<std::uint32_t> free_;
  std::size_t lowest_ = ranks;
};

}  // namespace foredraw::processors::quadric_collapse
