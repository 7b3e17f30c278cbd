#include <foredraw/overdraw/private/large_triangles.h>

#include <foredraw/viewing/coverage.h>

#include <algorithm>
#include <tuple>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/overdraw/large_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <foredraw/overdraw/private/vectors.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

template <class Depth>
void draw(const std::array<Corner, 3>& c, const Camera& camera, std::uint32_t number, Fragments& fragments,
          const TakeFragments& take) {
  const Depth depth(camera, c[0], c[1], c[2], doubled_area(c[0], c[1], c[2]));
  for_each_covered(c[0], c[1], c[2], PixelBox(c[0], c[1], c[2]),
                   [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
                     if (fragments.is_full()) fragments.hand_over(take);
                     fragments.add(static_cast<std::uint32_t>(y * camera.size() + x), depth.at(weights), number);
                   });
}

void draw_large(const std::array<Corner, 3>& c, const Camera& camera, std::uint32_t number, Fragments& fragments,
                const TakeFragments& take) {
  camera.is_perspective() ? draw<PerspectiveDepth>(c, camera, number, fragments, take)
                          : draw<OrthographicDepth>(c, camera, number, fragments, take);
}

#else

/// OrthographicDepth. Of a numerator that grows evenly, the whole quotients are carried along from register to
/// register; what is left then is less than lanes + 1, so that rounding can not reach the next whole number.
class OrthographicRow {
 public:
  OrthographicRow(const Camera&, const std::array<Corner, 3>& c, const std::array<EdgeFunction, 3>& edges,
                  std::int64_t area)
      : depths_{c[0].depth, c[1].depth, c[2].depth}, area_(static_cast<std::uint64_t>(area)) {
    std::int64_t growth = 0;
    for (std::size_t i = 0; i < 3; ++i) growth += edges[i].per_column() * static_cast<std::int64_t>(depths_[i]);
    const std::int64_t whole = floor_quotient(growth, area);
    const std::int64_t rest = growth - whole * area;  // below the area
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(Ints()));
    whole_per_lane_ = hn::Mul(hn::Iota(Ints(), 0), all(static_cast<std::int32_t>(whole)));
    rest_per_lane_ = to_doubles(hn::Iota(Ints(), 0)) * both(static_cast<double>(rest)) + both(0.5);
    inverse_ = both(1 / static_cast<double>(area));
    whole_per_step_ = static_cast<std::uint32_t>(whole * lanes + rest * lanes / area);
    rest_per_step_ = rest * lanes % area;
  }

  HWY_INLINE void begin(const std::array<std::int64_t, 3>& weights) {
    const std::uint64_t numerator = static_cast<std::uint64_t>(weights[0]) * depths_[0] +
                                    static_cast<std::uint64_t>(weights[1]) * depths_[1] +
                                    static_cast<std::uint64_t>(weights[2]) * depths_[2];
    whole_ = static_cast<std::uint32_t>(numerator / area_);
    rest_ = static_cast<std::int64_t>(numerator % area_);
  }

  HWY_INLINE IntVector next() {
    const DoublePair rest = rest_per_lane_ + both(static_cast<double>(rest_));
    const IntVector depths =
        hn::Add(hn::Add(all(static_cast<std::int32_t>(whole_)), whole_per_lane_), to_ints(rest * inverse_));
    whole_ += whole_per_step_;
    rest_ += rest_per_step_;
    if (rest_ >= static_cast<std::int64_t>(area_)) {
      rest_ -= static_cast<std::int64_t>(area_);
      ++whole_;
    }
    return depths;
  }

 private:
  static std::int64_t floor_quotient(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

  std::array<std::uint64_t, 3> depths_;
  std::uint64_t area_;
  IntVector whole_per_lane_;
  DoublePair rest_per_lane_, inverse_;
  std::uint32_t whole_per_step_;
  std::int64_t rest_per_step_;
  std::uint32_t whole_ = 0;
  std::int64_t rest_ = 0;
};

/// PerspectiveDepth.
class PerspectiveRow {
 public:
  PerspectiveRow(const Camera& camera, const std::array<Corner, 3>& c, const std::array<EdgeFunction, 3>& edges,
                 std::int64_t area)
      : before_(both(camera.steps_before_sphere())), area_(both(static_cast<double>(area))) {
    for (std::size_t i = 0; i < 3; ++i) {
      inverses_[i] = both(1 / (camera.steps_before_sphere() + c[i].depth));
      const auto growth = static_cast<double>(edges[i].per_column());
      per_lane_[i] = to_doubles(hn::Iota(Ints(), 0)) * both(growth);
      per_step_[i] = both(static_cast<double>(hn::Lanes(Ints())) * growth);
    }
  }

  HWY_INLINE void begin(const std::array<std::int64_t, 3>& weights) {
    for (std::size_t i = 0; i < 3; ++i) weights_[i] = both(static_cast<double>(weights[i])) + per_lane_[i];
  }

  HWY_INLINE IntVector next() {
    const DoublePair inverse = weights_[0] * inverses_[0] + weights_[1] * inverses_[1] + weights_[2] * inverses_[2];
    for (std::size_t i = 0; i < 3; ++i) weights_[i] = weights_[i] + per_step_[i];
    return to_ints(at_least_zero(area_ / inverse - before_ + both(0.5)));
  }

 private:
  DoublePair before_, area_;
  std::array<DoublePair, 3> inverses_, per_lane_, per_step_, weights_;
};

/// So many fragments are handed over as a row; fewer wait for others.
constexpr std::int32_t least_row = 8;

template <class Row>
void draw(const std::array<Corner, 3>& c, const Camera& camera, std::uint32_t number, Fragments& fragments,
          const TakeFragments& take) {
  const Ints d;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
  const std::array<EdgeFunction, 3> edges = edges_of(c[0], c[1], c[2]);
  Row row(camera, c, edges, doubled_area(c[0], c[1], c[2]));
  for_each_span(edges, PixelBox(c[0], c[1], c[2]), [&](std::int32_t y, std::int32_t begin, std::int32_t end) HWY_ATTR {
    const bool is_row = end - begin >= least_row;
    if (fragments.is_full() || (is_row && fragments.count > 0)) fragments.hand_over(take);
    row.begin({edges[0].at(begin, y), edges[1].at(begin, y), edges[2].at(begin, y)});
    IntVector pixels = hn::Iota(d, y * camera.size() + begin);
    std::size_t to = fragments.count;
    fragments.count += static_cast<std::size_t>(end - begin);
    for (std::int32_t x = begin; x < end; x += lanes, to += static_cast<std::size_t>(lanes)) {
      store_words(pixels, &fragments.pixels[to]);
      store_words(row.next(), &fragments.depths[to]);
      store_words(all(static_cast<std::int32_t>(number)), &fragments.triangles[to]);
      pixels = hn::Add(pixels, all(lanes));
    }
    if (!is_row) return;
    fragments.is_row = true;
    fragments.hand_over(take);
    fragments.is_row = false;
  });
}

void draw_large(const std::array<Corner, 3>& c, const Camera& camera, std::uint32_t number, Fragments& fragments,
                const TakeFragments& take) {
  camera.is_perspective() ? draw<PerspectiveRow>(c, camera, number, fragments, take)
                          : draw<OrthographicRow>(c, camera, number, fragments, take);
}

#endif

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

HWY_EXPORT(draw_large);

void draw_large(const PreparedPart& part, const Corners& corners, const Camera& camera, std::uint32_t triangle,
                Fragments& fragments, const TakeFragments& take) {
  std::array<Corner, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = corners[part.corners[i][triangle]];
  const std::uint32_t number = part.number(triangle, normalise(c));
  HWY_DYNAMIC_DISPATCH(draw_large)(c, camera, number, fragments, take);
}

}  // namespace foredraw
#endif
