#pragma once
#include <foredraw/image/alpha_image.h>
#include <foredraw/scene/sprite.h>

#include <cstdint>
#include <vector>

namespace foredraw {

/// A rectangle of texels, both ends included.
struct TexelBox {
  std::int64_t left = 0, top = 0, right = -1, bottom = -1;

  bool is_empty() const { return right < left; }
  void add(const TexelBox& other);
};

/// The bounding boxes of what hangs together inside the frame: texels above `limit` that are no more than `reach`
/// texels apart along both axes, through any number of others. In the sequence of their first texels. O(texels),
/// whatever the reach.
std::vector<TexelBox> image_parts(const AlphaImage& image, const SpriteFrame& frame, std::uint16_t limit,
                                  std::uint32_t reach);

}  // namespace foredraw
