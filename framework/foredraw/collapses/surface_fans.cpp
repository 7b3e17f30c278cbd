#include <foredraw/collapses/surface_fans.h>
#include <foredraw/geometry/joined_sets.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace foredraw {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// From corner `at` of a triangle to the next.
struct Side {
  std::uint32_t from = 0, to = 0, triangle = 0, at = 0;
  std::uint32_t low() const { return std::min(from, to); }
  std::uint32_t high() const { return std::max(from, to); }
};

std::vector<Side> sides_of(std::span<const CollapseRecorder::Corners> corners) {
  std::vector<Side> sides;
  sides.reserve(3 * corners.size());
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) sides.push_back({corners[t][k], corners[t][(k + 1) % 3], t, k});
  }
  return sides;
}

class Fans {
 public:
  explicit Fans(std::span<const CollapseRecorder::Corners> points) : points_(points), is_apart_(points.size(), false) {
    for (const auto& corners : points) {
      for (const std::uint32_t p : corners) count_ = std::max(count_, p + 1);
    }
    is_torn_.assign(count_, false);
  }

  SurfaceFans find() {
    SurfaceFans fans;
    do {
      join();
      fans = numbered();
    } while (takes_apart(fans));  // each time another triangle at least, so that it ends
    return fans;
  }

 private:
  void join() {
    together_ = JoinedSets(3 * points_.size());
    std::vector<Side> sides = sides_of(points_);
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low(), s.high(), s.triangle); });
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low() == sides[i].low() && sides[end].high() == sides[i].high()) ++end;
      if (end - i == 2 && fit(sides[i], sides[i + 1])) {
        join(sides[i], sides[i + 1]);
      } else if (end - i > 1) {
        is_torn_[sides[i].from] = is_torn_[sides[i].to] = true;
      }
      i = end;
    }
  }

  bool fit(const Side& a, const Side& b) const {
    const auto third = [&](const Side& s) { return points_[s.triangle][(s.at + 2) % 3]; };
    return a.from == b.to && third(a) != third(b) && !is_apart_[a.triangle] && !is_apart_[b.triangle];
  }

  void join(const Side& a, const Side& b) {
    together_.join(3 * a.triangle + a.at, 3 * b.triangle + (b.at + 1) % 3);
    together_.join(3 * a.triangle + (a.at + 1) % 3, 3 * b.triangle + b.at);
  }

  SurfaceFans numbered() {
    SurfaceFans fans;
    fans.corners.resize(points_.size());
    std::vector<std::uint32_t> number(3 * points_.size(), none), fans_at(count_, 0);
    for (std::uint32_t c = 0; c < number.size(); ++c) {
      const std::uint32_t set = together_.of(c), point = points_[c / 3][c % 3];
      if (number[set] == none) {
        number[set] = static_cast<std::uint32_t>(fans.point.size());
        fans.point.push_back(point);
        ++fans_at[point];
      }
      fans.corners[c / 3][c % 3] = number[set];
    }
    for (const std::uint32_t point : fans.point) fans.is_held.push_back(is_torn_[point] || fans_at[point] > 1);
    return fans;
  }

  /// Fans that meet again at an edge they do not fit at, as on a Moebius strip: one of the triangles there stands
  /// alone.
  bool takes_apart(const SurfaceFans& fans) {
    std::vector<Side> sides = sides_of(fans.corners);
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.from, s.to, s.triangle); });
    bool has_found = false;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].from != sides[i - 1].from || sides[i].to != sides[i - 1].to) continue;
      is_apart_[sides[i].triangle] = has_found = true;
      for (const std::uint32_t p : points_[sides[i].triangle]) is_torn_[p] = true;
    }
    return has_found;
  }

  std::span<const CollapseRecorder::Corners> points_;
  std::vector<bool> is_apart_;  // [triangle]
  std::vector<bool> is_torn_;   // [point]
  JoinedSets together_{0};
  std::uint32_t count_ = 0;
};

}  // namespace

SurfaceFans surface_fans(std::span<const CollapseRecorder::Corners> points) { return Fans(points).find(); }

}  // namespace foredraw
