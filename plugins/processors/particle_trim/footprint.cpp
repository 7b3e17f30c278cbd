#include "footprint.h"

#include "blend_cell.h"
#include "shown_cells.h"
#include "texel_rows.h"

#include <cmath>

namespace foredraw::processors::particle_trim {

namespace {

constexpr std::int64_t texel = steps_per_texel;

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }
std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

/// What of a box lies in the frame, if it has an area.
bool clip(Box& box, const Box& frame) {
  box.least = {std::max(box.least.x, frame.least.x), std::max(box.least.y, frame.least.y)};
  box.most = {std::min(box.most.x, frame.most.x), std::min(box.most.y, frame.most.y)};
  return box.least.x < box.most.x && box.least.y < box.most.y;
}

void add_corners(const Box& box, std::vector<Point>& points) {
  points.insert(points.end(), {box.least, {box.most.x, box.least.y}, {box.least.x, box.most.y}, box.most});
}

/// One axis of a level: where its texels lie in the image that it is a level of, in half texels of the level, rounded
/// outwards to steps.
struct Axis {
  std::int64_t steps;   ///< of the whole image
  std::int64_t halves;  ///< in which it has so many half texels

  std::int64_t down(std::int64_t half) const { return floor_div(half * steps, halves); }
  std::int64_t up(std::int64_t half) const { return ceil_div(half * steps, halves); }
  /// The first texel that reaches to behind a place, where each reaches `reach` halves over its own edges.
  std::int64_t first_behind(std::int64_t place, int reach) const {
    return floor_div(place * halves - reach * steps, 2 * steps);
  }
  std::int64_t last_before(std::int64_t place, int reach) const {
    return ceil_div(place * halves + reach * steps, 2 * steps) - 1;
  }
};

/// The texels of a level that may show in the frame.
struct Range {
  std::int64_t first, last;
};

/// Of each row of texels the rectangle from the first that shows to the last, each texel `reach` halves larger on all
/// sides.
void add_rows(const AlphaImage& level, const AlphaImage& image, const Sampling& sampling, std::uint16_t limit,
              int reach, const Box& frame, std::vector<Point>& points) {
  const Axis x{image.width * texel, 2 * std::int64_t{level.width}};
  const Axis y{image.height * texel, 2 * std::int64_t{level.height}};
  const Range columns{x.first_behind(frame.least.x, reach), x.last_before(frame.most.x, reach)};
  const Range rows{y.first_behind(frame.least.y, reach), y.last_before(frame.most.y, reach)};
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    const auto extent = TexelRow(level, sampling, row).extent(columns.first, columns.last, limit);
    if (!extent) continue;
    Box box{{x.down(2 * extent->first - reach), y.down(2 * row - reach)},
            {x.up(2 * extent->last + 2 + reach), y.up(2 * row + 2 + reach)}};
    if (clip(box, frame)) add_corners(box, points);
  }
}

/// Of each row of cells between texels' centres, what shows in those that may have a part in the outline. In the others
/// it lies between what shows on the lines through the centres, above and below; only, what the frame cuts in two has
/// no such line on one side, and is looked at whole.
void add_cells(const AlphaImage& image, const Sampling& sampling, double threshold, std::uint16_t limit,
               const Box& frame, std::vector<Point>& points) {
  constexpr std::int64_t half = texel / 2;
  const Range columns{floor_div(frame.least.x - half, texel), ceil_div(frame.most.x + half, texel) - 1};
  const Range rows{floor_div(frame.least.y - half, texel), ceil_div(frame.most.y + half, texel) - 1};
  const auto extent_of = [&](const TexelRow& row) {  // of those whose centres lie in the frame
    return row.extent(ceil_div(frame.least.x - half, texel), floor_div(frame.most.x - half, texel), limit);
  };
  TexelRow above(image, sampling, rows.first);
  auto above_extent = extent_of(above);
  for (std::int64_t row = rows.first; row < rows.last; ++row) {
    const TexelRow below(image, sampling, row + 1);
    const auto below_extent = extent_of(below);
    const auto add = [&](std::int64_t from, std::int64_t to) {
      for (std::int64_t c = std::max(from, columns.first); c <= std::min(to, columns.last - 1); ++c) {
        const BlendCell cell{{c * texel + half, row * texel + half}, {above[c], above[c + 1], below[c], below[c + 1]}};
        cell.add_shown(threshold * 65535, frame, points);
      }
    };
    const bool is_cut = row * texel + half < frame.least.y || (row + 1) * texel + half > frame.most.y;
    if (is_cut) {
      add(columns.first, columns.last);
    } else {
      add(columns.first, columns.first);
      add(columns.last - 1, columns.last - 1);
      if (above_extent && below_extent) {
        add(std::min(above_extent->first, below_extent->first) - 1, std::max(above_extent->first, below_extent->first));
        add(std::min(above_extent->last, below_extent->last) - 1, std::max(above_extent->last, below_extent->last));
      } else if (above_extent || below_extent) {
        const Extent& only = above_extent ? *above_extent : *below_extent;
        add(only.first - 1, only.last);
      }
    }
    above = below;
    above_extent = below_extent;
  }
}

}  // namespace

FootprintOptions footprint_of(const ParticleTrimOptions& options) {
  return {options.threshold, options.footprint, options.mip_levels, options.padding};
}

ShownImage::ShownImage(const AlphaImage& image, const Sampling& sampling, const FootprintOptions& options)
    : image_(image),
      sampling_(sampling),
      options_(options),
      limit_(static_cast<std::uint16_t>(std::floor(std::clamp(options.threshold, 0.0, 1.0) * 65535))) {
  for (int i = 0; i < options.mip_levels; ++i) {
    const AlphaImage& last = level(smaller_.size());
    if (last.width == 1 && last.height == 1) break;
    smaller_.push_back(next_level(last));
  }
}

ShownImage::~ShownImage() = default;

const ShownCells& ShownImage::cells() const {
  std::call_once(finding_cells_, [this] { cells_ = std::make_unique<const ShownCells>(*this); });
  return *cells_;
}

std::vector<Point> ShownImage::shown_points(const Box& frame) const {
  std::vector<Point> points;
  const int reach = is_blended() ? 1 : 0;
  if (options_.footprint == Footprint::bilinear && is_blended() && limit_ > 0) {
    add_cells(image_, sampling_, options_.threshold, limit_, frame, points);
  } else {
    add_rows(image_, image_, sampling_, limit_, reach, frame,
             points);  // all of what blends with more than 0 is above 0
  }
  for (const AlphaImage& level : smaller_) add_rows(level, image_, sampling_, limit_, reach, frame, points);
  return points;
}

namespace {

/// Where the line through a and b crosses x = at, rounded down and up.
void add_crossing(const Point& a, const Point& b, std::int64_t at, std::vector<Point>& points) {
  if ((a.x < at) == (b.x < at) || a.x == b.x) return;
  const std::int64_t rise = (b.y - a.y) * (at - a.x);
  const std::int64_t run = b.x - a.x;
  const std::int64_t down = run > 0 ? floor_div(rise, run) : floor_div(-rise, -run);
  points.push_back({at, a.y + down});
  points.push_back({at, a.y + down + (rise != down * run ? 1 : 0)});
}

Point turned(const Point& point) { return {point.y, point.x}; }

/// Points whose hull is what of a hull has x in a range; y is rounded outwards.
std::vector<Point> cut(const std::vector<Point>& hull, std::int64_t least, std::int64_t most) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point& a = hull[i];
    const Point& b = hull[(i + 1) % hull.size()];
    if (a.x >= least && a.x <= most) points.push_back(a);
    add_crossing(a, b, least, points);
    add_crossing(a, b, most, points);
  }
  return points;
}

}  // namespace

std::vector<Point> padded_hull(const std::vector<Point>& shown, const Box& frame, const FootprintOptions& options) {
  std::vector<Point> hull = convex_hull(shown);
  if (hull.empty()) return hull;
  // A sampler rounds a place to the next step, and a rasteriser a corner to 1/256 pixel: of the smallest version of the
  // image that is sampled, a pixel is as large as so many texels.
  const std::int64_t rounding = 1 + (std::int64_t{1} << options.mip_levels);
  const std::int64_t more =
      rounding + static_cast<std::int64_t>(std::ceil(options.padding * static_cast<double>(texel)));
  std::vector<Point> padded;
  for (const Point& p : hull) add_corners({{p.x - more, p.y - more}, {p.x + more, p.y + more}}, padded);
  hull = convex_hull(std::move(padded));
  std::vector<Point> points = cut(hull, frame.least.x, frame.most.x);
  for (Point& point : points) point = turned(point);
  hull = convex_hull(std::move(points));
  points = cut(hull, frame.least.y, frame.most.y);
  for (Point& point : points) {
    point = turned(point);
    // Rounded outwards, which may have gone a step beyond the frame.
    point.x = std::clamp(point.x, frame.least.x, frame.most.x);
  }
  return convex_hull(std::move(points));
}

}  // namespace foredraw::processors::particle_trim
