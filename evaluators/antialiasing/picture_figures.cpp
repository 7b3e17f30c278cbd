#include "picture_figures.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::evaluators::antialiasing {

namespace {

constexpr float least_spread = 1.0f / 64;

/// Calls visit(neighbour) for the 3 x 3 pixels around one, as far as they are in the picture.
template <class Visit>
void for_each_near(FrameSize size, int x, int y, Visit visit) {
  for (int row = std::max(0, y - 1); row <= std::min(size.height - 1, y + 1); ++row) {
    for (int column = std::max(0, x - 1); column <= std::min(size.width - 1, x + 1); ++column) {
      visit(static_cast<std::size_t>(row * size.width + column));
    }
  }
}

float contrast(const std::vector<float>& wires, FrameSize size, int x, int y) {
  float least = 1, most = 0;
  for_each_near(size, x, y, [&](std::size_t pixel) {
    least = std::min(least, wires[pixel]);
    most = std::max(most, wires[pixel]);
  });
  return most - least;
}

double squared(const glm::vec3& v) {
  const glm::dvec3 exact(v);
  return glm::dot(exact, exact);
}

}  // namespace

PixelMask touched_pixels(const SampledPicture& truth) {
  const FrameSize size = truth.picture.size;
  PixelMask mask(truth.spreads.size());
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (truth.spreads[static_cast<std::size_t>(y * size.width + x)] <= least_spread) continue;
      for_each_near(size, x, y, [&](std::size_t pixel) { mask[pixel] = true; });
    }
  }
  return mask;
}

PixelMask both(const PixelMask& a, const PixelMask& b) {
  PixelMask mask = a;
  for (std::size_t i = 0; i < b.size(); ++i) mask[i] = mask[i] || b[i];
  return mask;
}

Sum squared_errors(const FramePicture& picture, const FramePicture& truth, const PixelMask& mask) {
  Sum sum;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) sum += {squared(picture.colours[i] - truth.colours[i]), 3};
  }
  return sum;
}

Sum squared_flicker(const FramePicture& before, const FramePicture& after, const FramePicture& truth_before,
                    const FramePicture& truth_after, const PixelMask& mask) {
  Sum sum;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const glm::vec3 change = after.colours[i] - before.colours[i];
    sum += {squared(change - (truth_after.colours[i] - truth_before.colours[i])), 3};
  }
  return sum;
}

Sum broken_pixels(const SampledPicture& picture, const SampledPicture& truth) {
  const FrameSize size = truth.picture.size;
  Sum sum;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (truth.wires[static_cast<std::size_t>(y * size.width + x)] == 0) continue;
      const bool is_broken = 2 * contrast(picture.wires, size, x, y) < contrast(truth.wires, size, x, y);
      sum += {is_broken ? 1.0 : 0.0, 1};
    }
  }
  return sum;
}

Sum ink(const SampledPicture& picture, const SampledPicture& truth) {
  Sum sum;
  for (std::size_t i = 0; i < truth.wires.size(); ++i) {
    sum += {static_cast<double>(picture.wires[i]), static_cast<double>(truth.wires[i])};
  }
  return sum;
}

}  // namespace foredraw::evaluators::antialiasing
