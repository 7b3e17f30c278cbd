#pragma once
// Which pixels are worth a ray?

#include <foredraw/viewing/coverage.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foredraw {

/// In each row of a picture the columns from the first to the last that the boxes of some triangles reach.
class RowSpans {
 public:
  struct Span {
    std::int32_t begin, end;
  };

  explicit RowSpans(int size) : rows_(static_cast<std::size_t>(size), {size, 0}) {}

  /// A pixel is `steps` of the corners' units wide.
  void add(const Corner& a, const Corner& b, const Corner& c, std::int32_t steps) {
    const std::int32_t last_row = pixel(std::max({a.y, b.y, c.y}), steps);
    const std::int32_t first_column = pixel(std::min({a.x, b.x, c.x}), steps);
    const std::int32_t last_column = pixel(std::max({a.x, b.x, c.x}), steps);
    for (std::int32_t y = pixel(std::min({a.y, b.y, c.y}), steps); y <= last_row; ++y) {
      Span& span = rows_[static_cast<std::size_t>(y)];
      span.begin = std::min(span.begin, first_column);
      span.end = std::max(span.end, last_column + 1);
    }
  }

  const Span& operator[](std::int32_t y) const { return rows_[static_cast<std::size_t>(y)]; }

 private:
  /// A coordinate at the very end of the picture belongs to its last pixel.
  std::int32_t pixel(std::int32_t coordinate, std::int32_t steps) const {
    return std::min(coordinate / steps, static_cast<std::int32_t>(rows_.size()) - 1);
  }

  std::vector<Span> rows_;
};

}  // namespace foredraw
