#include "grid_strips.h"

#include <algorithm>

namespace foredraw::bench {

StripWidth plain_strips(std::uint32_t cache_size) { return {cache_size / 2 - 1, cache_size / 2 - 1}; }

// A vertex of a strip w wide is used last when w + 1 others have entered behind it, and one more where the strip grows.
StripWidth primed_strips(std::uint32_t cache_size) { return {cache_size / 2 - 1, cache_size - 3}; }

std::vector<std::uint32_t> grid_strips(std::uint32_t columns, std::uint32_t rows, StripWidth width) {
  std::vector<std::uint32_t> order;
  order.reserve(2 * std::size_t{columns} * rows);
  const auto draw = [&](std::uint32_t row, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t t = 2 * (row * columns + from); t < 2 * (row * columns + to); ++t) order.push_back(t);
  };
  for (std::uint32_t begin = 0; begin < columns; begin += width.most) {
    const std::uint32_t end = std::min(begin + width.most, columns);
    const auto reached = [&](std::uint32_t row) { return std::min(begin + width.first + row, end); };
    for (std::uint32_t row = 0; row < rows && reached(row) < end; ++row) draw(row, reached(row), end);  // the corner
    for (std::uint32_t row = 0; row < rows; ++row) draw(row, begin, reached(row));
  }
  return order;
}

}  // namespace foredraw::bench
