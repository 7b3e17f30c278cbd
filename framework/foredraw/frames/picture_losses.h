#pragma once
// What pictures lose where an object is drawn coarser or by a cheaper rendering, measured on the object itself.

#include <foredraw/frames/reference_renderer.h>

#include <array>
#include <vector>

namespace foredraw {

/// Squared differences from full detail, summed over a picture's pixels and channels (0 to 1 each) and divided by the
/// pixels that the object covers. At sizes of 2, 8, 32, 128 and 512 pixels across the object's sphere.
struct PictureLosses {
  static constexpr std::size_t sizes = 5;
  using BySize = std::array<double, sizes>;

  std::vector<std::array<BySize, all_renderings.size()>> of;  ///< [level][rendering][size]
  BySize without{};                                           ///< where the object is not drawn at all

  /// At so many pixels across: between two sizes in proportion to the logarithm, beyond them what the last one has.
  static double at(const BySize& losses, double across);
};

/// Of the object's mesh as the object stands, alone before the sky, from four sides; at the largest size from two, as
/// it takes most of the time.
PictureLosses picture_losses(const FrameScene& scene, const FrameMoment& moment, std::uint32_t object);

/// How near each rendering of full detail comes to the full rendering, 0 to 1, at 128 pixels across: 1 is the same, 0
/// as far as a picture without the object.
std::array<double, all_renderings.size()> rendering_accuracies(const PictureLosses& losses);

/// The same of an object whose losses are not wanted, with the pictures of that level and size alone.
std::array<double, all_renderings.size()> rendering_accuracies(const FrameScene& scene, const FrameMoment& moment,
                                                               std::uint32_t object);

}  // namespace foredraw
