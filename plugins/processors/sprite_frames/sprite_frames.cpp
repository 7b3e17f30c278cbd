#include "sprite_frames.h"

#include "image_parts.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace foredraw {

namespace {

constexpr std::size_t most_parts = 16384;

bool overlap_or_touch(const TexelBox& a, const TexelBox& b) {
  return a.left <= b.right + 1 && b.left <= a.right + 1 && a.top <= b.bottom + 1 && b.top <= a.bottom + 1;
}

/// Until none overlap or touch.
std::vector<TexelBox> united(std::vector<TexelBox> boxes) {
  std::vector<TexelBox> apart;
  for (TexelBox box : boxes) {
    // A box that has grown may touch those that it was compared with before.
    for (auto other = apart.begin(); other != apart.end();) {
      if (overlap_or_touch(box, *other)) {
        box.add(*other);
        *other = apart.back();
        apart.pop_back();
        other = apart.begin();
      } else {
        ++other;
      }
    }
    apart.push_back(box);
  }
  return apart;
}

std::vector<TexelBox> in_reading_order(std::vector<TexelBox> boxes) {
  const auto from_the_left = [](const TexelBox& a, const TexelBox& b) {
    return a.left != b.left ? a.left < b.left : a.top < b.top;
  };
  const auto downwards = [&](const TexelBox& a, const TexelBox& b) {
    return a.top != b.top ? a.top < b.top : from_the_left(a, b);
  };
  std::ranges::sort(boxes, downwards);
  for (auto line = boxes.begin(); line != boxes.end();) {
    const std::int64_t below = line->bottom + 1;
    const auto next = std::stable_partition(
        line, boxes.end(), [below](const TexelBox& box) { return box.top + box.bottom + 1 < 2 * below; });
    std::sort(line, next, from_the_left);
    line = next;
  }
  return boxes;
}

SpriteFrame with_margin(const TexelBox& box, const SpriteFrame& whole) {
  const std::int64_t left = std::max<std::int64_t>(box.left - 1, whole.x);
  const std::int64_t top = std::max<std::int64_t>(box.top - 1, whole.y);
  const std::int64_t right = std::min<std::int64_t>(box.right + 2, std::int64_t{whole.x} + whole.width);
  const std::int64_t bottom = std::min<std::int64_t>(box.bottom + 2, std::int64_t{whole.y} + whole.height);
  const auto number = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
  return {number(left), number(top), number(right - left), number(bottom - top)};
}

}  // namespace

std::vector<SpriteFrame> grid_frames(const SpriteFrame& whole, int columns, int rows) {
  const auto edge = [](std::uint32_t side, int cell, int cells) {
    return static_cast<std::uint32_t>(
        (std::uint64_t{2} * side * static_cast<std::uint64_t>(cell) + static_cast<std::uint64_t>(cells)) /
        (2 * static_cast<std::uint64_t>(cells)));
  };
  if (static_cast<std::uint32_t>(columns) > whole.width || static_cast<std::uint32_t>(rows) > whole.height) {
    throw std::invalid_argument(std::to_string(whole.width) + " x " + std::to_string(whole.height) +
                                " texels cannot be cut into " + std::to_string(columns) + " columns and " +
                                std::to_string(rows) + " rows");
  }
  std::vector<SpriteFrame> frames;
  for (int row = 0; row < rows; ++row) {
    const std::uint32_t top = edge(whole.height, row, rows), bottom = edge(whole.height, row + 1, rows);
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t left = edge(whole.width, column, columns), right = edge(whole.width, column + 1, columns);
      frames.push_back({whole.x + left, whole.y + top, right - left, bottom - top});
    }
  }
  return frames;
}

std::vector<SpriteFrame> found_frames(const AlphaImage& image, const SpriteFrame& whole,
                                      const SpriteFramesOptions& options) {
  const auto limit = static_cast<std::uint16_t>(options.threshold * 65535);
  std::vector<TexelBox> parts = image_parts(image, whole, limit, static_cast<std::uint32_t>(options.gutter));
  if (parts.size() > most_parts) {
    throw std::runtime_error("it has " + std::to_string(parts.size()) + " parts, more than the limit of " +
                             std::to_string(most_parts) + "; raise threshold or gutter");
  }
  std::vector<SpriteFrame> frames;
  for (const TexelBox& box : in_reading_order(united(std::move(parts)))) frames.push_back(with_margin(box, whole));
  return frames;
}

}  // namespace foredraw
