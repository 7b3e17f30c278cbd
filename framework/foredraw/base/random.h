#pragma once
// Random numbers that are the same everywhere: the standard library's distributions are not.

#include <cstdint>

namespace foredraw {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1), 53 bits.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// Uniform in [0, bound); bound > 0.
  std::uint64_t below(std::uint64_t bound) {
    return static_cast<std::uint64_t>((static_cast<unsigned __int128>(next()) * bound) >> 64);
  }

 private:
  std::uint64_t state_;
};

/// A seed of its own for each (seed, stage, draw).
inline std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t stage, std::uint64_t draw) {
  Random mix(seed ^ (stage * 0x9e3779b97f4a7c15ull) ^ (draw * 0xd1342543de82ef95ull));
  return mix.next();
}

}  // namespace foredraw
