#pragma once
#include <cstdint>

namespace foredraw {

/// The part of its material's image that a draw shows: what was drawn before it was trimmed, in texels from the image's
/// upper left corner.
struct SpriteFrame {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  friend bool operator==(const SpriteFrame&, const SpriteFrame&) = default;
};

}  // namespace foredraw
