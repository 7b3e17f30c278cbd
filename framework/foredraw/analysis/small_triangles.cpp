#include "small_triangles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/analysis/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t draw_small(const PreparedPart&, const Corners&, const Camera&, const std::uint64_t*, std::size_t,
                       Fragments&) {
  return 0;  // nothing to gain: all are drawn as large ones
}

#else

// A stamp: four pixels wide, as many rows as the register holds.
using Ints = hn::CappedTag<std::int32_t, 16>;
using Words = hn::RebindToUnsigned<Ints>;
using HalfInts = hn::Half<Ints>;
using Doubles = hn::Rebind<double, HalfInts>;
constexpr std::int32_t stamp_width = 4;

using IntVector = hn::Vec<Ints>;
using DoubleVector = hn::Vec<Doubles>;

/// Edge functions and their products with depths stay exact: in 32 bits, and in doubles below 2^53.
constexpr std::int32_t most_extent = 32 * subpixels;

struct Triangle {
  std::array<std::int32_t, 3> x, y;
  std::array<std::uint32_t, 3> depth;
};

struct OrthographicDepths {
  DoubleVector a, b, c, inverse;

  OrthographicDepths(const Camera&, const Triangle& t, double area)
      : a(hn::Set(Doubles(), t.depth[0])),
        b(hn::Set(Doubles(), t.depth[1])),
        c(hn::Set(Doubles(), t.depth[2])),
        inverse(hn::Set(Doubles(), 1 / area)) {}

  DoubleVector at(DoubleVector u, DoubleVector v, DoubleVector w) const {
    const DoubleVector sum = hn::Add(hn::Add(hn::Mul(u, a), hn::Mul(v, b)), hn::Mul(w, c));
    return hn::Mul(hn::Add(sum, hn::Set(Doubles(), 0.5)), inverse);
  }
};

struct PerspectiveDepths {
  DoubleVector a, b, c, area, before;

  PerspectiveDepths(const Camera& camera, const Triangle& t, double doubled_area)
      : a(hn::Set(Doubles(), 1 / (camera.steps_before_sphere() + t.depth[0]))),
        b(hn::Set(Doubles(), 1 / (camera.steps_before_sphere() + t.depth[1]))),
        c(hn::Set(Doubles(), 1 / (camera.steps_before_sphere() + t.depth[2]))),
        area(hn::Set(Doubles(), doubled_area)),
        before(hn::Set(Doubles(), camera.steps_before_sphere())) {}

  DoubleVector at(DoubleVector u, DoubleVector v, DoubleVector w) const {
    const DoubleVector sum = hn::Add(hn::Add(hn::Mul(u, a), hn::Mul(v, b)), hn::Mul(w, c));
    const DoubleVector depth = hn::Add(hn::Sub(hn::Div(area, sum), before), hn::Set(Doubles(), 0.5));
    return hn::Max(depth, hn::Zero(Doubles()));
  }
};

template <class Depths>
std::size_t draw(const PreparedPart& part, const Corners& corners, const Camera& camera,
                 const std::uint64_t* triangles, std::size_t count, Fragments& fragments) {
  const Ints d;
  const std::int32_t lanes = static_cast<std::int32_t>(hn::Lanes(d));
  const std::int32_t stamp_height = lanes / stamp_width;
  const std::int32_t size = camera.size();
  const IntVector column = hn::And(hn::Iota(d, 0), hn::Set(d, stamp_width - 1));
  const IntVector row = hn::ShiftRight<2>(hn::Iota(d, 0));
  const IntVector pixel_of_lane = hn::Add(column, hn::Mul(row, hn::Set(d, size)));
  const IntVector columns = hn::ShiftLeft<8>(column);
  const IntVector rows = hn::ShiftLeft<8>(row);
  std::uint32_t* pixels = fragments.pixels.data() + fragments.count;
  std::uint32_t* depths = fragments.depths.data() + fragments.count;
  std::uint32_t* numbers = fragments.triangles.data() + fragments.count;
  const std::uint32_t* const full = fragments.pixels.data() + Fragments::most;

  std::size_t done = 0;
  for (; done < count && pixels < full; ++done) {
    const std::size_t number = triangles[done];
    std::array<std::size_t, 3> vertex = {part.corners[0][number], part.corners[1][number], part.corners[2][number]};
    Triangle t;
    const auto fetch = [&](std::size_t to, std::size_t from) {
      const std::uint64_t place = corners.places[vertex[from]];
      t.x[to] = static_cast<std::int32_t>(place);
      t.y[to] = static_cast<std::int32_t>(place >> 32);
      t.depth[to] = corners.depths[vertex[from]];
    };
    for (std::size_t i = 0; i < 3; ++i) fetch(i, i);
    const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
    if (high_x - low_x > most_extent || high_y - low_y > most_extent) break;
    std::int32_t area = (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
    if (area < 0) {
      area = -area;
      std::swap(vertex[1], vertex[2]);
      fetch(1, 1);
      fetch(2, 2);
    }
    if (camera.is_perspective()) {
      // The least corner first, so that sums are rounded alike whichever corner the file names first.
      const auto key = [&](std::size_t i) { return std::tuple(t.x[i], t.y[i], t.depth[i]); };
      std::size_t least = 0;
      if (key(1) < key(least)) least = 1;
      if (key(2) < key(least)) least = 2;
      if (least > 0) {
        vertex = {vertex[least], vertex[(least + 1) % 3], vertex[(least + 2) % 3]};
        for (std::size_t i = 0; i < 3; ++i) fetch(i, i);
      }
    }
    const std::int32_t first_x = (low_x + subpixels / 2 - 1) >> 8;
    const std::int32_t last_x = (high_x - subpixels / 2) >> 8;
    const std::int32_t first_y = (low_y + subpixels / 2 - 1) >> 8;
    const std::int32_t last_y = (high_y - subpixels / 2) >> 8;
    const std::int32_t centre_x = first_x * subpixels + subpixels / 2;
    const std::int32_t centre_y = first_y * subpixels + subpixels / 2;
    const Depths depth(camera, t, area);
    const IntVector number_of_all = hn::Set(d, static_cast<std::int32_t>(part.numbers[number]));

    std::array<IntVector, 3> weights;
    std::array<std::int32_t, 3> per_column, per_row;
    std::array<IntVector, 3> owned;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = (i + 1) % 3, q = (i + 2) % 3;
      per_column[i] = t.y[p] - t.y[q];
      per_row[i] = t.x[q] - t.x[p];
      const std::int32_t at_first = per_row[i] * (centre_y - t.y[p]) + per_column[i] * (centre_x - t.x[p]);
      const bool is_top_or_left = per_column[i] > 0 || (per_column[i] == 0 && per_row[i] < 0);
      weights[i] = hn::Add(hn::Set(d, at_first), hn::Add(hn::Mul(columns, hn::Set(d, per_column[i])),
                                                         hn::Mul(rows, hn::Set(d, per_row[i]))));
      owned[i] = hn::Set(d, is_top_or_left ? 0 : -1);
      per_column[i] *= stamp_width * subpixels;
      per_row[i] *= stamp_height * subpixels;
    }
    for (std::int32_t y = first_y; y <= last_y; y += stamp_height) {
      std::array<IntVector, 3> w = weights;
      for (std::int32_t x = first_x; x <= last_x; x += stamp_width) {
        const auto outside =
            hn::Or(hn::Add(w[0], owned[0]), hn::Or(hn::Add(w[1], owned[1]), hn::Add(w[2], owned[2])));
        const auto inside = hn::Gt(outside, hn::Set(d, -1));
        const std::size_t covered = hn::CountTrue(d, inside);
        if (covered > 0) {
          const Doubles f;
          const HalfInts half;
          const auto lower = hn::DemoteTo(half, depth.at(hn::PromoteTo(f, hn::LowerHalf(half, w[0])),
                                                         hn::PromoteTo(f, hn::LowerHalf(half, w[1])),
                                                         hn::PromoteTo(f, hn::LowerHalf(half, w[2]))));
          const auto upper = hn::DemoteTo(half, depth.at(hn::PromoteTo(f, hn::UpperHalf(half, w[0])),
                                                         hn::PromoteTo(f, hn::UpperHalf(half, w[1])),
                                                         hn::PromoteTo(f, hn::UpperHalf(half, w[2]))));
          const auto put = [&](IntVector values, std::uint32_t* to) { hn::StoreU(hn::BitCast(Words(), values), Words(), to); };
          put(hn::Compress(hn::Add(pixel_of_lane, hn::Set(d, y * size + x)), inside), pixels);
          put(hn::Compress(hn::Combine(d, upper, lower), inside), depths);
          put(number_of_all, numbers);
          pixels += covered;
          depths += covered;
          numbers += covered;
        }
        for (std::size_t i = 0; i < 3; ++i) w[i] = hn::Add(w[i], hn::Set(d, per_column[i]));
      }
      for (std::size_t i = 0; i < 3; ++i) weights[i] = hn::Add(weights[i], hn::Set(d, per_row[i]));
    }
  }
  fragments.count = static_cast<std::size_t>(pixels - fragments.pixels.data());
  return done;
}

std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       const std::uint64_t* triangles, std::size_t count, Fragments& fragments) {
  return camera.is_perspective() ? draw<PerspectiveDepths>(part, corners, camera, triangles, count, fragments)
                                 : draw<OrthographicDepths>(part, corners, camera, triangles, count, fragments);
}

#endif

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

HWY_EXPORT(draw_small);

std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       std::span<const std::uint64_t> triangles, Fragments& fragments) {
  return HWY_DYNAMIC_DISPATCH(draw_small)(part, corners, camera, triangles.data(), triangles.size(), fragments);
}

}  // namespace foredraw
#endif
