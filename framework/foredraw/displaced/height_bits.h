#pragma once
#include <cstdint>

namespace foredraw {

/// Heights are read with so many bits: the sides of a seam agree in these.
inline constexpr std::uint32_t height_bits = 14;

}  // namespace foredraw
