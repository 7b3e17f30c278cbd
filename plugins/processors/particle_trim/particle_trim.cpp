#include "particle_trim.h"

#include "enclosing_polygon.h"
#include "footprint.h"
#include "shown_cells.h"
#include "stored_polygon.h"
#include "texel_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

using namespace processors::particle_trim;

namespace {

constexpr double texel_area = static_cast<double>(steps_per_texel * steps_per_texel);

/// Sides from a frame's upper left corner.
Box at_origin(const Box& frame) { return {{0, 0}, frame.most - frame.least}; }

std::vector<glm::dvec2> moved(std::span<const glm::dvec2> corners, const Point& by) {
  std::vector<glm::dvec2> made;
  for (const glm::dvec2& corner : corners) made.push_back(corner + glm::dvec2(by.x, by.y));
  return made;
}

/// May polygons reach so far? Not by more than the frame's longer side, so that coordinates stay small.
bool is_in_reach(const glm::dvec2& place, const Box& frame, const ShownImage& image, UvFormat format) {
  const Point size = frame.most - frame.least;
  const auto far = static_cast<double>(std::max(size.x, size.y));
  const auto is_between = [](double number, double least, double most) { return number >= least && number <= most; };
  if (!UvGrid(format).reaches_out()) {
    const glm::dvec2 whole =
        static_cast<double>(steps_per_texel) * glm::dvec2(image.image().width, image.image().height);
    return is_between(place.x, 0, whole.x) && is_between(place.y, 0, whole.y);
  }
  return is_between(place.x, static_cast<double>(frame.least.x) - far, static_cast<double>(frame.most.x) + far) &&
         is_between(place.y, static_cast<double>(frame.least.y) - far, static_cast<double>(frame.most.y) + far);
}

/// Where a convex polygon is at a height; least above most where it is not.
struct Span {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

Span span_at(const std::vector<glm::dvec2>& corners, double y) {
  Span span;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if ((p.y < y) == (q.y < y)) continue;
    const double x = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
    span = {std::min(span.least, x), std::max(span.most, x)};
  }
  return span;
}

/// The largest value that may show in the frame outside of the polygon: of the texels that the polygon does not hold
/// with all that they blend into, but no more than the threshold, as the rest is proven to lie inside.
double lost(const ShownImage& image, const Box& frame, const StoredPolygon& polygon) {
  if (image.limit() == 0) return 0;
  const std::int64_t reach = image.is_blended() ? steps_per_texel / 2 : 0;
  const std::vector<glm::dvec2> corners = polygon.places();
  const std::int64_t first = frame.least.x / steps_per_texel,
                     end = (frame.most.x + steps_per_texel - 1) / steps_per_texel;
  std::uint16_t most = 0;
  const std::int64_t last_row = (frame.most.y + steps_per_texel - 1) / steps_per_texel;
  for (std::int64_t row = frame.least.y / steps_per_texel; row < last_row && most <= image.limit(); ++row) {
    const std::int64_t up = std::max(row * steps_per_texel - reach, frame.least.y);
    const std::int64_t down = std::min((row + 1) * steps_per_texel + reach, frame.most.y);
    const Span above = span_at(corners, static_cast<double>(up)), below = span_at(corners, static_cast<double>(down));
    const double left = std::max(above.least, below.least), right = std::min(above.most, below.most);
    // Columns that are held whole; a texel too few does no harm. What ends at the frame's edge need not go beyond it.
    std::int64_t from = end, to = end;
    if (left < right) {
      const auto held_from =
          left <= static_cast<double>(frame.least.x)
              ? first
              : static_cast<std::int64_t>(std::ceil((left + static_cast<double>(reach)) / steps_per_texel));
      const auto held_end =
          right >= static_cast<double>(frame.most.x)
              ? end
              : static_cast<std::int64_t>(std::floor((right - static_cast<double>(reach)) / steps_per_texel));
      from = std::clamp(held_from, first, end);
      to = std::clamp(held_end, from, end);
    }
    const TexelRow texels(image.image(), image.sampling(), row);
    for (std::int64_t c = first; c < from; ++c) most = std::max(most, texels[c]);
    for (std::int64_t c = to; c < end; ++c) most = std::max(most, texels[c]);
  }
  return std::min(most, image.limit()) / 65535.0;
}

/// What is found for all frames that share a polygon.
class Trimming {
 public:
  Trimming(const ShownImage& image, std::span<const Box> frames, const ParticleTrimOptions& options)
      : image_(image), frames_(frames), options_(options), frame_(at_origin(frames.front())) {}

  std::vector<TrimmedSprite> run() {
    using Outcome = TrimmedSprite::Outcome;
    std::vector<Point> all;
    for (const Box& frame : frames_) {
      shown_.push_back(image_.shown_points(frame));
      for (const Point& point : shown_.back()) all.push_back(point - frame.least);
    }
    if (all.empty()) return unchanged(Outcome::empty);
    const std::vector<Point> hull = padded_hull(all, frame_, image_.options());
    const double hull_area = Pockets(hull, {}).hull_area();
    if (hull_area >= frame_.area()) return unchanged(Outcome::full);
    if (hull_area > frame_.area() * (1 - options_.least_saving)) return unchanged(Outcome::no_saving);

    const Allowed allowed = [this](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
      return is_allowed(a, b, c);
    };
    const std::vector<glm::dvec2> rectangle = rectangle_round(hull);
    const double rectangle_area = (rectangle[2].x - rectangle[0].x) * (rectangle[2].y - rectangle[0].y);
    // A larger polygon would not be used.
    const double most_area = options_.vertices < 4 ? frame_.area() : rectangle_area;
    const auto polygon = options_.method == TrimMethod::optimal
                             ? smallest_enclosing(hull, options_.vertices, allowed, most_area)
                             : reduced_enclosing(hull, options_.vertices, options_.hull_edges, allowed);
    if (polygon && polygon->area <= most_area) {
      if (auto made = stored(polygon->corners, Outcome::trimmed)) return *made;
    }
    if (auto made = stored(rectangle, Outcome::rectangle)) return *made;
    return unchanged(Outcome::no_saving);
  }

 private:
  static std::vector<glm::dvec2> rectangle_round(const std::vector<Point>& hull) {
    const auto [left, right] = std::ranges::minmax(hull, {}, &Point::x);
    const auto [up, down] = std::ranges::minmax(hull, {}, &Point::y);
    return {{left.x, up.y}, {right.x, up.y}, {right.x, down.y}, {left.x, down.y}};
  }

  bool is_allowed(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
    return std::ranges::all_of(frames_, [&](const Box& frame) {
      const glm::dvec2 origin(frame.least.x, frame.least.y);
      for (const glm::dvec2& place : {a, b, c}) {
        if (!is_in_reach(place + origin, frame, image_, options_.uv)) return false;
      }
      return is_within(a, b, c) || !image_.cells().shows_outside(frame, a + origin, b + origin, c + origin);
    });
  }

  bool is_within(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
    const auto width = static_cast<double>(frame_.most.x), height = static_cast<double>(frame_.most.y);
    for (const glm::dvec2& place : {a, b, c}) {
      if (!(place.x >= 0 && place.x <= width && place.y >= 0 && place.y <= height)) return false;
    }
    return true;
  }

  TrimmedSprite left_alone(std::size_t i, TrimmedSprite::Outcome outcome) const {
    const double area = frames_[i].area() / texel_area;
    return {outcome, {}, area, area, texels_of(frames_[i]), 0};
  }

  std::vector<TrimmedSprite> unchanged(TrimmedSprite::Outcome outcome) const {
    std::vector<TrimmedSprite> made;
    for (std::size_t i = 0; i < frames_.size(); ++i) made.push_back(left_alone(i, outcome));
    return made;
  }

  static std::uint64_t texels_of(const Box& frame) {
    return static_cast<std::uint64_t>(std::ceil(frame.area() / texel_area));
  }

  /// The polygon for every frame, rounded and proven; none where it can not be.
  std::optional<std::vector<TrimmedSprite>> stored(const std::vector<glm::dvec2>& corners,
                                                   TrimmedSprite::Outcome outcome) const {
    std::vector<TrimmedSprite> made;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const Box& frame = frames_[i];
      const auto polygon = StoredPolygon::round(moved(corners, frame.least), image_.image(), options_.uv);
      if (!polygon || !is_proven(*polygon, i)) return std::nullopt;
      const double area = polygon->area(), frame_area = frame.area() / texel_area;
      if (area > frame_area * (1 - options_.least_saving)) {
        made.push_back(left_alone(i, TrimmedSprite::Outcome::no_saving));
        continue;
      }
      made.push_back(
          {outcome, polygon->texture_coordinates(), area, frame_area, texels_of(frame), lost(image_, frame, *polygon)});
    }
    return made;
  }

  bool is_proven(const StoredPolygon& polygon, std::size_t i) const {
    if (!std::ranges::all_of(shown_[i], [&](const Point& point) { return polygon.holds(point); })) return false;
    const Point& origin = frames_[i].least;
    const std::vector<glm::dvec2> places = moved(polygon.places(), {-origin.x, -origin.y});
    for (std::size_t k = 1; k + 1 < places.size(); ++k) {
      if (!is_within(places[0], places[k], places[k + 1]) &&
          image_.cells().shows_outside(frames_[i], places[0] + glm::dvec2(origin.x, origin.y),
                                       places[k] + glm::dvec2(origin.x, origin.y),
                                       places[k + 1] + glm::dvec2(origin.x, origin.y))) {
        return false;
      }
    }
    return true;
  }

  const ShownImage& image_;
  std::span<const Box> frames_;
  const ParticleTrimOptions& options_;
  Box frame_;                              ///< from its own upper left corner
  std::vector<std::vector<Point>> shown_;  ///< in each frame
};

}  // namespace

std::vector<TrimmedSprite> particle_trim(const AlphaImage& image, const Sampling& sampling,
                                         std::span<const TrimFrame> frames, const ParticleTrimOptions& options) {
  return particle_trim(ShownImage(image, sampling, footprint_of(options)), frames, options);
}

std::vector<TrimmedSprite> particle_trim(const ShownImage& image, std::span<const TrimFrame> frames,
                                         const ParticleTrimOptions& options) {
  if (frames.empty()) return {};
  return Trimming(image, frames, options).run();
}

}  // namespace foredraw
