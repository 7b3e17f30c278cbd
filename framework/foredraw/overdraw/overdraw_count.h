#pragma once
#include <cstdint>
#include <vector>

namespace foredraw {

/// Fragments of one part of a subject in one view. Overdraw is shaded / visible; 1 is the limit.
struct OverdrawCount {
  std::uint64_t shaded = 0;     ///< fragments that pass the depth test, in draw order
  std::uint64_t visible = 0;    ///< fragments that stay
  std::uint64_t ties = 0;       ///< fragments equally near as what was there before them
  std::uint64_t discarded = 0;  ///< fragments that pass, but that a mask discards; not among the others

  OverdrawCount& operator+=(const OverdrawCount& other) {
    shaded += other.shaded;
    visible += other.visible;
    ties += other.ties;
    discarded += other.discarded;
    return *this;
  }
  friend bool operator==(const OverdrawCount&, const OverdrawCount&) = default;
};

/// [part][view]
using OverdrawCounts = std::vector<std::vector<OverdrawCount>>;

}  // namespace foredraw
