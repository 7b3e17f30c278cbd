#include "offset_picture.h"

#include <algorithm>
#include <cmath>

namespace foredraw::evaluators::antialiasing {

SampledPicture offset_picture(const SampledPicture& picture, const PixelOffsets& offsets) {
  SampledPicture made = picture;
  const int width = picture.picture.size.width, height = picture.picture.size.height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * width + x);
      const glm::vec2 offset = offsets[pixel];
      if (offset == glm::vec2(0)) continue;
      const float left = std::floor(offset.x), up = std::floor(offset.y);
      const float part_x = offset.x - left, part_y = offset.y - up;
      const auto place = [&](int right, int down) {
        const int column = std::clamp(x + static_cast<int>(left) + right, 0, width - 1);
        const int row = std::clamp(y + static_cast<int>(up) + down, 0, height - 1);
        return static_cast<std::size_t>(row * width + column);
      };
      const auto between = [&](const auto& of) {
        return (of[place(0, 0)] * (1 - part_x) + of[place(1, 0)] * part_x) * (1 - part_y) +
               (of[place(0, 1)] * (1 - part_x) + of[place(1, 1)] * part_x) * part_y;
      };
      made.picture.colours[pixel] = between(picture.picture.colours);
      if (!picture.wires.empty()) made.wires[pixel] = between(picture.wires);
    }
  }
  return made;
}

}  // namespace foredraw::evaluators::antialiasing
