#pragma once
// Pictures for tests of their kinds of files.

#include <foredraw/io/image/images.h>

#include <cstdint>
#include <vector>

namespace foredraw::testing {

using Values = std::vector<std::uint16_t>;

/// Smooth, so that JPEG keeps it nearly as it is.
inline Values values_of(const ImageFacts& facts) {
  Values values;
  for (std::uint32_t y = 0; y < facts.height; ++y) {
    for (std::uint32_t x = 0; x < facts.width; ++x) {
      for (int c = 0; c < facts.channels; ++c) {
        const std::uint32_t value = 20 + 3 * x + 2 * y + 10 * static_cast<std::uint32_t>(c);
        values.push_back(static_cast<std::uint16_t>(facts.bits == 16 ? value * 211 : value));
      }
    }
  }
  return values;
}

}  // namespace foredraw::testing
