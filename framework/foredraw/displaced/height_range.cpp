#include <foredraw/displaced/height_range.h>

#include <cmath>
#include <span>

namespace foredraw {

namespace {

/// From the first to the last one.
struct TexelRun {
  std::int64_t first = 0, last = 0;
};

/// Which texels of a row or column stand at numbers that may lie beyond its ends: at most two ranges.
class Wrapped {
 public:
  Wrapped(TexelRun numbers, std::uint32_t size, std::uint8_t wrap) {
    const std::int64_t n = size, length = numbers.last - numbers.first;
    const auto at = [&](std::int64_t number) {
      // Foredraw_height_texel() takes 32 bits; whole periods change nothing.
      const bool is_clamped = wrap != FOREDRAW_HEIGHT_REPEAT && wrap != FOREDRAW_HEIGHT_MIRRORED;
      const std::int64_t near = is_clamped ? std::clamp<std::int64_t>(number, 0, n - 1) : number % (2 * n);
      return std::int64_t{foredraw_height_texel(static_cast<std::int32_t>(near), size, wrap)};
    };
    const std::int64_t a = at(numbers.first), b = at(numbers.last);
    if (wrap == FOREDRAW_HEIGHT_REPEAT && length < n) {
      if (a <= b) {
        add({a, b});
      } else {
        add({a, n - 1}), add({0, b});
      }
    } else if (wrap == FOREDRAW_HEIGHT_MIRRORED && length < n) {
      // Either it turns around at an end, or it does not.
      const std::int64_t low = std::min(a, b), high = std::max(a, b);
      if (high - low == length) {
        add({low, high});
      } else {
        const bool turns_at_zero = low + high + 1 == length;
        add(turns_at_zero ? TexelRun{0, high} : TexelRun{low, n - 1});
      }
    } else if (wrap == FOREDRAW_HEIGHT_REPEAT || wrap == FOREDRAW_HEIGHT_MIRRORED) {
      add({0, n - 1});
    } else {
      add({a, b});
    }
  }

  std::span<const TexelRun> ranges() const& { return {ranges_.data(), count_}; }
  std::span<const TexelRun> ranges() const&& = delete;  // they would be gone

 private:
  void add(TexelRun range) { ranges_[count_++] = range; }

  std::array<TexelRun, 2> ranges_{};
  std::size_t count_ = 0;
};

/// Where a triangle's part between two heights begins and ends, along the other axis.
struct Extent {
  double least = INFINITY, most = -INFINITY;
};

Extent between(const std::array<std::array<std::int32_t, 2>, 3>& corners, double low, double high) {
  Extent extent;
  for (std::size_t e = 0; e < 3; ++e) {
    const double ax = corners[e][0], ay = corners[e][1], bx = corners[(e + 1) % 3][0], by = corners[(e + 1) % 3][1];
    const double from = std::max(std::min(ay, by), low), to = std::min(std::max(ay, by), high);
    if (from > to) continue;
    for (const double y : {from, to}) {
      const double x = ay == by ? ax : ax + (bx - ax) * ((y - ay) / (by - ay));
      extent.least = std::min(extent.least, x), extent.most = std::max(extent.most, x);
    }
    if (ay == by) extent.least = std::min(extent.least, bx), extent.most = std::max(extent.most, bx);
  }
  return extent;
}

/// Which texels places between two have a part of: between the middles of two it is of both, but for a map without
/// filtering. A place may be rounded by one.
TexelRun texels_of(double least, double most, bool is_nearest) {
  const double half = is_nearest ? 0 : 128;
  return {static_cast<std::int64_t>(std::floor((least - 1 - half) / 256)),
          static_cast<std::int64_t>(std::floor((most + 1 + half) / 256))};
}

}  // namespace

HeightRanges::HeightRanges(const foredraw_height_map& map) : map_(map) {
  levels_.push_back({map.width, map.height, {}});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.cells.resize(std::size_t{coarse.width} * coarse.height);
    for (std::size_t y = 0; y < fine.height; ++y) {
      for (std::size_t x = 0; x < fine.width; ++x)
        coarse.cells[y / 2 * coarse.width + x / 2].add(cell(fine, y * fine.width + x));
    }
    levels_.push_back(std::move(coarse));
  }
}

HeightRange HeightRanges::cell(const Level& level, std::size_t at) const {
  if (level.cells.empty()) return {map_.texels[at], map_.texels[at]};
  return level.cells[at];
}

HeightRange HeightRanges::over(const std::array<std::array<std::int32_t, 2>, 3>& corners) const {
  std::array<TexelRun, 2> box;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    box[axis] = texels_of(least, most, map_.is_nearest != 0);
  }
  // Cells of 2^shift texels, so that there are not many.
  int shift = 0;
  while (std::max(box[0].last - box[0].first, box[1].last - box[1].first) >> shift > 64 + 3) ++shift;
  const std::size_t coarse = std::min(static_cast<std::size_t>(shift), levels_.size() - 1);
  const Level& level = levels_[coarse];
  HeightRange range;
  for (std::int64_t row = box[1].first >> shift; row <= box[1].last >> shift; ++row) {
    const TexelRun rows{std::max(row << shift, box[1].first), std::min(((row + 1) << shift) - 1, box[1].last)};
    // Whose places have a part of these rows.
    const double reach = 1 + (map_.is_nearest != 0 ? 0 : 128);
    const double low = 256.0 * static_cast<double>(rows.first) - reach;
    const double high = 256.0 * static_cast<double>(rows.last + 1) + reach;
    const Extent extent = between(corners, low, high);
    if (extent.least > extent.most) continue;
    const TexelRun columns = texels_of(extent.least, extent.most, map_.is_nearest != 0);
    const Wrapped along_v(rows, map_.height, map_.wrap[1]), along_u(columns, map_.width, map_.wrap[0]);
    for (const TexelRun& y : along_v.ranges()) {
      for (const TexelRun& x : along_u.ranges()) {
        for (std::int64_t at_y = y.first >> coarse; at_y <= y.last >> coarse; ++at_y) {
          for (std::int64_t at_x = x.first >> coarse; at_x <= x.last >> coarse; ++at_x)
            range.add(cell(level, static_cast<std::size_t>(at_y) * level.width + static_cast<std::size_t>(at_x)));
        }
      }
    }
  }
  return range;
}

}  // namespace foredraw
