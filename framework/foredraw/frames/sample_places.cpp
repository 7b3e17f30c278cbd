#include <foredraw/frames/sample_places.h>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace foredraw {

namespace {

/// In sixteenths of a pixel from its upper left corner (Vulkan 1.3, 25.3).
using Sixteenths = std::vector<std::pair<int, int>>;

Sixteenths sixteenths(int samples) {
  switch (samples) {
    case 1: return {{8, 8}};
    case 2: return {{12, 12}, {4, 4}};
    case 4: return {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
    case 8: return {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
    default:
      throw std::invalid_argument("no standard places of " + std::to_string(samples) +
                                  " samples; there are those of 1, 2, 4 and 8");
  }
}

std::uint32_t reversed(std::uint32_t value, int bits) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < bits; ++bit) result |= (value >> bit & 1u) << (bits - 1 - bit);
  return result;
}

}  // namespace

SamplePlaces standard_places(int samples) {
  SamplePlaces places;
  for (const auto& [right, down] : sixteenths(samples)) places.emplace_back((right - 8) / 16.0, (8 - down) / 16.0);
  return places;
}

SamplePlaces hammersley_places(int samples, bool other) {
  if (samples < 1 || samples > 1 << 16 || !std::has_single_bit(static_cast<unsigned>(samples))) {
    throw std::invalid_argument("a truth has a power of two of samples, at most 65536, and not " +
                                std::to_string(samples));
  }
  const int bits = std::countr_zero(static_cast<unsigned>(samples));
  // A digital shift keeps what is even about the set. Its mirror image would be the set itself.
  const std::uint32_t shift = other ? 0x5555u & (static_cast<std::uint32_t>(samples) - 1) : 0;
  SamplePlaces places;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(samples); ++i) {
    const double column = (i + 0.5) / samples - 0.5, row = ((reversed(i, bits) ^ shift) + 0.5) / samples - 0.5;
    places.emplace_back(column, row);
  }
  return places;
}

}  // namespace foredraw
