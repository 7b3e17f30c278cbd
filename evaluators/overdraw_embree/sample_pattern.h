#pragma once
// Where in a pixel it is looked at.

#include <foredraw/base/random.h>

#include <cstdint>

namespace foredraw {

/// The samples of one pixel. A single one lies in its middle. More of them are points of the R2 sequence (M. Roberts,
/// "The unreasonable effectiveness of quasirandom sequences", 2018), which spreads evenly however many there are, moved
/// in each pixel by another random vector (R. Cranley, T. Patterson, "Randomization of number theoretic methods for
/// multiple integration", 1976), so that each sample lies anywhere with the same probability.
class SamplePattern {
 public:
  /// In `steps`-th parts of a pixel from its lower left corner.
  struct Place {
    std::int32_t x, y;
  };
  static constexpr int steps = 1 << 18;

  SamplePattern(std::uint64_t seed, std::uint32_t x, std::uint32_t y, int samples) {
    if (samples > 1) start_ = Random(derive_seed(seed, x, y)).next();
  }

  Place operator[](int sample) const {
    // Steps of 2^32 / p and 2^32 / p^2, where p^3 = p + 1, around a pixel that is 2^32 wide.
    const auto i = static_cast<std::uint32_t>(sample);
    return {place(static_cast<std::uint32_t>(start_) + i * 3242174889u),
            place(static_cast<std::uint32_t>(start_ >> 32) + i * 2447445414u)};
  }

 private:
  static std::int32_t place(std::uint32_t turned) { return static_cast<std::int32_t>(turned >> 14); }

  std::uint64_t start_ = 0x80000000'80000000u;
};

}  // namespace foredraw
