#include "post_filter.h"

#include <algorithm>
#include <cmath>

namespace foredraw::evaluators::antialiasing {

namespace {

// As filters of this kind are usually set.
constexpr float least_contrast = 0.0312f;    ///< that is an edge
constexpr float relative_contrast = 0.125f;  ///< of the brightest neighbour
constexpr int farthest_end = 12;             ///< pixels
constexpr float most_of_lone = 0.75f;        ///< how far a pixel that stands alone fetches from its neighbours

class Luminance {
 public:
  explicit Luminance(const FramePicture& picture) : width_(picture.size.width), height_(picture.size.height) {
    for (const glm::vec3& colour : picture.colours) {
      const float sum = 0.2126f * colour.x + 0.7152f * colour.y + 0.0722f * colour.z;
      values_.push_back(std::sqrt(std::max(0.0f, sum)));
    }
  }
  float at(int x, int y) const {
    return values_[static_cast<std::size_t>(std::clamp(y, 0, height_ - 1) * width_ + std::clamp(x, 0, width_ - 1))];
  }

 private:
  int width_, height_;
  std::vector<float> values_;
};

/// A pixel's neighbourhood, turned so that its edge runs along x: `along` and `across` are steps in the picture.
struct Turned {
  const Luminance& of;
  int x, y;
  bool is_horizontal;
  float at(int along, int across) const {
    return is_horizontal ? of.at(x + along, y + across) : of.at(x + across, y + along);
  }
};

/// How much luminance bends across an edge that runs along.
float bend(const Turned& t) {
  return std::abs(t.at(-1, -1) - 2 * t.at(-1, 0) + t.at(-1, 1)) +
         2 * std::abs(t.at(0, -1) - 2 * t.at(0, 0) + t.at(0, 1)) + std::abs(t.at(1, -1) - 2 * t.at(1, 0) + t.at(1, 1));
}

/// Pixels to where the edge between the pixel's row and the one across ends, and luminance there from the edge's own.
struct End {
  int pixels;
  float apart;
};
End end_of(const Turned& t, int step, int side, float edge, float contrast) {
  End end{farthest_end, 0};
  for (int i = 1; i <= farthest_end; ++i) {
    end = {i, (t.at(step * i, 0) + t.at(step * i, side)) / 2 - edge};
    if (std::abs(end.apart) >= contrast / 4) return end;
  }
  return end;
}

glm::vec2 offset_at(const Luminance& luminance, int x, int y) {
  const float middle = luminance.at(x, y), up = luminance.at(x, y - 1), down = luminance.at(x, y + 1),
              left = luminance.at(x - 1, y), right = luminance.at(x + 1, y);
  const auto [least, most] = std::minmax({middle, up, down, left, right});
  const float range = most - least;
  if (range < std::max(least_contrast, most * relative_contrast)) return glm::vec2(0);

  const float corners =
      luminance.at(x - 1, y - 1) + luminance.at(x + 1, y - 1) + luminance.at(x - 1, y + 1) + luminance.at(x + 1, y + 1);
  const float lone = std::min(1.0f, std::abs((2 * (up + down + left + right) + corners) / 12 - middle) / range);
  const float smooth = lone * lone * (3 - 2 * lone);

  Turned t{luminance, x, y, true};
  const float of_horizontal = bend(t);
  t.is_horizontal = false;
  t.is_horizontal = of_horizontal >= bend(t);
  const int side = std::abs(t.at(0, 1) - middle) > std::abs(t.at(0, -1) - middle) ? 1 : -1;
  const float contrast = std::abs(t.at(0, side) - middle), edge = (middle + t.at(0, side)) / 2;
  const End before = end_of(t, -1, side, edge, contrast), behind = end_of(t, 1, side, edge, contrast);
  const End& nearer = before.pixels <= behind.pixels ? before : behind;
  // The edge ends towards the other row, or else it is not this pixel that it cuts.
  const bool is_cut = (middle < edge) != (nearer.apart < 0);
  const float by_end =
      is_cut ? 0.5f - static_cast<float>(nearer.pixels) / static_cast<float>(before.pixels + behind.pixels) : 0;
  const float offset = static_cast<float>(side) * std::max(by_end, smooth * smooth * most_of_lone);
  return t.is_horizontal ? glm::vec2(0, offset) : glm::vec2(offset, 0);
}

}  // namespace

PixelOffsets post_offsets(const FramePicture& picture) {
  const Luminance luminance(picture);
  PixelOffsets offsets;
  offsets.reserve(picture.colours.size());
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) offsets.push_back(offset_at(luminance, x, y));
  }
  return offsets;
}

}  // namespace foredraw::evaluators::antialiasing
