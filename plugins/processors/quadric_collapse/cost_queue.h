#pragma once
// A queue of edges by cost that is cheap rather than exact: costs within an eighth of an octave are alike. What came
// last among them goes first, as its neighbourhood is still at hand.

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace foredraw::collapsing {

struct EdgeEntry {
  std::uint32_t p = 0, q = 0;
  std::uint32_t moves = 0;    ///< of both points, when the cost was reckoned
  std::uint32_t changes = 0;  ///< of both points
  bool is_checked = false;    ///< the cost counts how far the surface moves
};

class CostQueue {
 public:
  static std::size_t rank_of(double cost) { return std::bit_cast<std::uint64_t>(cost > 0 ? cost : 0.0) >> 49; }

  /// The least cost of a higher rank.
  static double cost_above(std::size_t rank) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(rank + 1) << 49);
  }

  void push(double cost, const EdgeEntry& entry) {
    const std::size_t rank = rank_of(cost);
    if (rank >= buckets_.size()) buckets_.resize(rank + 1);
    buckets_[rank].push_back(entry);
    if (rank < lowest_) lowest_ = rank;
  }

  std::optional<EdgeEntry> pop() {
    while (lowest_ < buckets_.size() && buckets_[lowest_].empty()) {
      std::vector<EdgeEntry>().swap(buckets_[lowest_]);
      ++lowest_;
    }
    if (lowest_ >= buckets_.size()) return std::nullopt;
    const EdgeEntry entry = buckets_[lowest_].back();
    buckets_[lowest_].pop_back();
    return entry;
  }

  /// What comes out so many entries later, if nothing goes in before; nothing where that is not known.
  const EdgeEntry* later(std::size_t entries) const {
    if (lowest_ >= buckets_.size() || buckets_[lowest_].size() < entries) return nullptr;
    return &buckets_[lowest_][buckets_[lowest_].size() - entries];
  }

  /// The rank of what pop() answered with last.
  std::size_t lowest() const { return lowest_; }

 private:
  std::vector<std::vector<EdgeEntry>> buckets_;
  std::size_t lowest_ = 0;
};

}  // namespace foredraw::collapsing
