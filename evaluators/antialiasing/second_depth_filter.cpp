#include "second_depth_filter.h"

#include <foredraw/runtime/second_depth.h>

#include <algorithm>
#include <array>

namespace foredraw::evaluators::antialiasing {

namespace {

constexpr int reach = FOREDRAW_SECOND_DEPTH_REACH;
using Samples = std::array<float, 2 * reach + 1>;

/// Rows from below, as the renderer has them.
std::vector<float> depth_of(const Frame& frame, const std::vector<std::uint32_t>* backs_of) {
  ReferenceRenderer renderer(frame.size);
  renderer.draw(frame.scene, frame.moment, frame.camera, frame.objects, FrameStyle::objects, {.backs_of = backs_of});
  std::vector<float> depth(renderer.nearness().begin(), renderer.nearness().end());
  for (float& d : depth) d *= static_cast<float>(frame.camera.near);
  return depth;
}

}  // namespace

PixelOffsets second_depth_offsets(const Frame& frame) {
  const std::vector<float> depth = depth_of(frame, nullptr), second = depth_of(frame, frame.closed);
  const foredraw_second_depth_rule rule = foredraw_second_depth_float(1);
  const int width = frame.size.width, height = frame.size.height;
  PixelOffsets offsets(depth.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto edge = [&](bool is_row) {
        Samples depths{}, seconds{};
        for (int i = -reach; i <= reach; ++i) {
          const int column = std::clamp(is_row ? x + i : x, 0, width - 1);
          const int row = std::clamp(is_row ? y : y + i, 0, height - 1);
          const auto sample = static_cast<std::size_t>((height - 1 - row) * width + column);
          depths[static_cast<std::size_t>(i + reach)] = depth[sample];
          seconds[static_cast<std::size_t>(i + reach)] = second[sample];
        }
        const int at = is_row ? x : y, size = is_row ? width : height;
        return foredraw_second_depth_edge(&rule, depths.data(), seconds.data(), std::min(at, reach),
                                          std::min(size - 1 - at, reach));
      };
      glm::vec2& offset = offsets[static_cast<std::size_t>(y * width + x)];
      foredraw_second_depth_offset(edge(true), edge(false), &offset.x);
    }
  }
  return offsets;
}

}  // namespace foredraw::evaluators::antialiasing
