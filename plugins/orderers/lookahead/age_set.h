#pragma once
// Which of the vertices in a first-in-first-out cache are waiting, by their age.

#include <array>
#include <bit>
#include <cstdint>

namespace foredraw {

/// Ages from 1 to the size of a cache, at most 256: those at which there is a vertex with triangles left.
class AgeSet {
 public:
  explicit AgeSet(std::uint32_t size) : words_((size + 63) / 64), oldest_(size) {}

  bool has(std::uint32_t age) const { return (bits_[(age - 1) / 64] >> ((age - 1) % 64) & 1) != 0; }
  void remove(std::uint32_t age) { bits_[(age - 1) / 64] &= ~(std::uint64_t{1} << ((age - 1) % 64)); }

  /// Everyone grows older by one, the oldest leaves, and one of age 1 comes in or not. Whether the oldest was there.
  bool grow_older(bool one_comes) {
    const bool had_oldest = has(oldest_);
    std::uint64_t carry = one_comes;
    for (std::uint32_t i = 0; i < words_; ++i) {
      const std::uint64_t bits = bits_[i];
      bits_[i] = bits << 1 | carry;
      carry = bits >> 63;
    }
    if (oldest_ % 64 != 0) bits_[words_ - 1] &= ~(std::uint64_t{1} << (oldest_ % 64));
    return had_oldest;
  }

  /// Calls visit(age) from young to old.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::uint32_t i = 0; i < words_; ++i) {
      for (std::uint64_t bits = bits_[i]; bits != 0; bits &= bits - 1) {
        visit(64 * i + static_cast<std::uint32_t>(std::countr_zero(bits)) + 1);
      }
    }
  }

 private:
  std::array<std::uint64_t, 4> bits_{};
  std::uint32_t words_, oldest_;
};

}  // namespace foredraw
