#include "shown_cells.h"

#include "texel_rows.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::particle_trim {

namespace {

constexpr std::int64_t cell = steps_per_texel / 2;

using Corners = std::vector<glm::dvec2>;

/// What of a convex polygon has a coordinate of at most, or at least, `bound`.
Corners cut(const Corners& corners, int axis, double bound, bool at_most) {
  const auto is_in = [&](const glm::dvec2& p) { return at_most ? p[axis] <= bound : p[axis] >= bound; };
  Corners made;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if (is_in(p)) made.push_back(p);
    if (is_in(p) != is_in(q)) made.push_back(p + (q - p) * ((bound - p[axis]) / (q[axis] - p[axis])));
  }
  return made;
}

/// Where a convex polygon is between two heights.
struct Span {
  double least = 0, most = -1;

  void add(double x) {
    if (most < least) {
      least = most = x;
    } else {
      least = std::min(least, x);
      most = std::max(most, x);
    }
  }
};

Span span_between(const Corners& corners, double upper, double lower) {
  Span span;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if (p.y >= upper && p.y <= lower) span.add(p.x);
    for (const double y : {upper, lower}) {
      if ((p.y < y) != (q.y < y)) span.add(p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
    }
  }
  return span;
}

bool any_bit(const std::uint64_t* words, std::int64_t from, std::int64_t to) {
  while (from < to) {
    const std::int64_t bit = from % 64, count = std::min<std::int64_t>(64 - bit, to - from);
    const std::uint64_t ones = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    if ((words[from / 64] >> bit & ones) != 0) return true;
    from += count;
  }
  return false;
}

// All but a sampler's step at either side.
std::int64_t first_cell(double place) { return static_cast<std::int64_t>(std::floor((place + 1) / cell)); }
std::int64_t end_cell(double place) { return static_cast<std::int64_t>(std::ceil((place - 1) / cell)); }

}  // namespace

ShownCells::ShownCells(const ShownImage& image)
    : width_(2 * std::int64_t{image.image().width}),
      height_(2 * std::int64_t{image.image().height}),
      wrap_(image.sampling().wrap),
      words_((static_cast<std::size_t>(width_) + 63) / 64),
      bits_(words_ * static_cast<std::size_t>(height_), 0) {
  const int reach = image.is_blended() ? 1 : 0;
  for (std::size_t i = 0; i < image.levels(); ++i) mark_level(image.level(i), image.limit(), reach);
  for (std::int64_t row = 0; row < height_; ++row) {
    const std::uint64_t* words = &bits_[static_cast<std::size_t>(row) * words_];
    left_.push_back(any_bit(words, 0, 1));
    right_.push_back(any_bit(words, width_ - 1, width_));
  }
}

/// Each run of texels that show, and half a texel round it where they are blended.
void ShownCells::mark_level(const AlphaImage& level, std::uint16_t limit, int reach) {
  const std::int64_t w = level.width, h = level.height;
  // A half texel of the level is width_ / 2w cells wide.
  const auto down = [](std::int64_t half, std::int64_t cells, std::int64_t texels) {
    const std::int64_t scaled = half * cells;
    return scaled >= 0 ? scaled / (2 * texels) : -((-scaled + 2 * texels - 1) / (2 * texels));
  };
  const auto up = [&](std::int64_t half, std::int64_t cells, std::int64_t texels) {
    return -down(-half, cells, texels);
  };
  for (std::int64_t y = 0; y < h; ++y) {
    const std::uint16_t* row = &level.alpha[static_cast<std::size_t>(y * w)];
    const std::int64_t upper = down(2 * y - reach, height_, h), lower = up(2 * y + 2 + reach, height_, h);
    for (std::int64_t x = 0; x < w;) {
      if (row[x] <= limit) {
        ++x;
        continue;
      }
      std::int64_t end = x + 1;
      while (end < w && row[end] > limit) ++end;
      const std::int64_t from = down(2 * x - reach, width_, w), to = up(2 * end + reach, width_, w);
      for (std::int64_t r = upper; r < lower; ++r) mark(r, from, to);
      x = end;
    }
  }
}

/// What reaches over an edge shows on the other side of an image that repeats.
void ShownCells::mark(std::int64_t row, std::int64_t from, std::int64_t to) {
  if (row < 0 || row >= height_) {
    if (wrap_[1] != Wrap::repeat) return;
    row = wrapped(row, static_cast<std::uint32_t>(height_), Wrap::repeat);
  }
  const auto set = [&](std::int64_t first, std::int64_t end) {
    std::uint64_t* words = &bits_[static_cast<std::size_t>(row) * words_];
    while (first < end) {
      const std::int64_t bit = first % 64, count = std::min<std::int64_t>(64 - bit, end - first);
      const std::uint64_t ones = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
      words[first / 64] |= ones << bit;
      first += count;
    }
  };
  set(std::max<std::int64_t>(from, 0), std::min(to, width_));
  if (wrap_[0] != Wrap::repeat) return;
  if (from < 0) set(std::max<std::int64_t>(from + width_, 0), width_);
  if (to > width_) set(0, std::min(to - width_, width_));
}

bool ShownCells::any(std::int64_t row, std::int64_t from, std::int64_t to) const {
  const std::uint64_t* words = &bits_[wrapped(row, static_cast<std::uint32_t>(height_), wrap_[1]) * words_];
  if (wrap_[0] == Wrap::clamped) {
    // What lies on the edge goes on beyond it.
    const std::int64_t first = std::clamp<std::int64_t>(from, 0, width_ - 1);
    return any_bit(words, first, std::clamp<std::int64_t>(to, first + 1, width_));
  }
  to = std::min(to, from + 2 * width_);  // there and back
  while (from < to) {
    const std::int64_t place = wrapped(from, static_cast<std::uint32_t>(2 * width_), Wrap::repeat);
    const std::int64_t count = std::min(to - from, width_ - place % width_);
    const bool is_mirrored = wrap_[0] == Wrap::mirrored && place >= width_;
    const std::int64_t first = is_mirrored ? 2 * width_ - place - count : place % width_;
    if (any_bit(words, first, first + count)) return true;
    from += count;
  }
  return false;
}

/// Of a convex polygon, but for a sampler's step at its sides.
bool ShownCells::any_within(const std::vector<glm::dvec2>& corners) const {
  if (corners.size() < 3) return false;
  const auto [upper, lower] = std::ranges::minmax(corners, {}, [](const glm::dvec2& p) { return p.y; });
  const std::int64_t last_row = end_cell(lower.y);
  for (std::int64_t row = first_cell(upper.y), next; row < last_row; row = next) {
    next = row + 1;
    if (wrap_[1] == Wrap::clamped) {  // rows beyond an edge are all alike
      if (row < 0) next = std::min<std::int64_t>(0, last_row);
      if (row >= height_) next = last_row;
    }
    const Span span = span_between(corners, static_cast<double>(row * cell), static_cast<double>(next * cell));
    const std::int64_t from = first_cell(span.least), to = end_cell(span.most);
    if (from < to && any(row, from, to)) return true;
  }
  return false;
}

/// Of a convex polygon that lies to the left or to the right of an image that ends there as its edge is.
bool ShownCells::any_beyond(const std::vector<bool>& edge, const std::vector<glm::dvec2>& corners) const {
  if (corners.size() < 3) return false;
  const auto [upper, lower] = std::ranges::minmax(corners, {}, [](const glm::dvec2& p) { return p.y; });
  for (std::int64_t row = first_cell(upper.y); row < end_cell(lower.y); ++row) {
    if (edge[wrapped(row, static_cast<std::uint32_t>(height_), wrap_[1])]) return true;
  }
  return false;
}

bool ShownCells::shows_outside(const Box& frame, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
  const auto left = static_cast<double>(frame.least.x), right = static_cast<double>(frame.most.x);
  const auto upper = static_cast<double>(frame.least.y), lower = static_cast<double>(frame.most.y);
  const auto [least_x, most_x] = std::minmax({a.x, b.x, c.x});
  const auto [least_y, most_y] = std::minmax({a.y, b.y, c.y});
  if (least_x >= left - 1 && most_x <= right + 1 && least_y >= upper - 1 && most_y <= lower + 1) return false;
  // What lies above and below the frame, and beside it.
  const Corners all{a, b, c};
  if (least_y < upper - 1 && any_within(cut(all, 1, upper, true))) return true;
  if (most_y > lower + 1 && any_within(cut(all, 1, lower, false))) return true;
  if (least_x >= left - 1 && most_x <= right + 1) return false;
  const Corners beside = cut(cut(all, 1, upper, false), 1, lower, true);
  const bool ends = wrap_[0] == Wrap::clamped;
  if (least_x < left - 1) {
    const Corners part = cut(beside, 0, left, true);
    if (ends && frame.least.x <= 0 ? any_beyond(left_, part) : any_within(part)) return true;
  }
  if (most_x <= right + 1) return false;
  const Corners part = cut(beside, 0, right, false);
  return ends && frame.most.x >= width_ * cell ? any_beyond(right_, part) : any_within(part);
}

}  // namespace foredraw::processors::particle_trim
