#pragma once
// An image of many sprites cut into frames: by a grid, or where the gaps are.

#include <foredraw/image/alpha_image.h>
#include <foredraw/scene/sprite.h>

#include <cstdint>
#include <vector>

namespace foredraw {

struct SpriteFramesOptions {
  int columns = 1;  ///< of a grid of equal cells
  int rows = 1;
  bool find = false;     ///< look for the parts instead
  double threshold = 0;  ///< a texel shows that has more alpha than this, 0 to 1
  AlphaChannel channel = AlphaChannel::alpha;
  int gutter = 1;  ///< empty texels between parts, at least
};

/// The cells of a grid, row after row. Where the sides can not be divided, edges lie at the nearest whole texel, halves
/// rounded up. Throws std::invalid_argument where there are more cells than texels along a side.
std::vector<SpriteFrame> grid_frames(const SpriteFrame& whole, int columns, int rows);

/// The parts of an image inside a frame that lies in it. Two texels that show belong together where fewer than `gutter`
/// others lie between them along both axes, and whatever hangs together by such pairs is a part. Parts whose bounding
/// rectangles overlap or touch are one. Each gets a margin of one texel, for what samplers blend into the neighbours,
/// as far as the frame reaches.
///
/// In reading order: the highest part begins a line, which all parts belong to whose middle lies above its lower edge;
/// lines downwards, parts in a line from the left.
///
/// O(texels + parts^2). Throws std::runtime_error where there are more than 16384 parts.
std::vector<SpriteFrame> found_frames(const AlphaImage& image, const SpriteFrame& whole,
                                      const SpriteFramesOptions& options = {});

struct Plugin;
Plugin sprite_frames_plugin();

}  // namespace foredraw
