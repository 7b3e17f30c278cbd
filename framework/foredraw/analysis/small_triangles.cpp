#include "small_triangles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/analysis/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Edge functions and their products with depths stay exact: in 32 bits, and in doubles below 2^53.
constexpr std::int32_t most_extent = 32 * subpixels;

#if HWY_TARGET == HWY_SCALAR

std::size_t draw_small(const PreparedPart&, const Corners&, const Camera&, const std::uint32_t*, std::size_t,
                       Fragments&) {
  return 0;  // nothing to gain: all are drawn as large ones
}

#else

using Ints = hn::CappedTag<std::int32_t, 16>;
using Words = hn::RebindToUnsigned<Ints>;
using HalfInts = hn::Half<Ints>;
using Doubles = hn::Rebind<double, HalfInts>;
using IntVector = hn::Vec<Ints>;
using DoubleVector = hn::Vec<Doubles>;

constexpr std::size_t most_lanes = 16;

/// Two registers of doubles for one of integers.
struct DoublePair {
  DoubleVector lower, upper;
};

HWY_INLINE DoublePair to_doubles(IntVector values) {
  const Doubles f;
  const HalfInts half;
  return {hn::PromoteTo(f, hn::LowerHalf(half, values)), hn::PromoteTo(f, hn::UpperHalf(half, values))};
}

HWY_INLINE IntVector to_ints(const DoublePair& values) {
  return hn::Combine(Ints(), hn::DemoteTo(HalfInts(), values.upper), hn::DemoteTo(HalfInts(), values.lower));
}

HWY_INLINE DoublePair operator+(const DoublePair& a, const DoublePair& b) {
  return {hn::Add(a.lower, b.lower), hn::Add(a.upper, b.upper)};
}
HWY_INLINE DoublePair operator-(const DoublePair& a, const DoublePair& b) {
  return {hn::Sub(a.lower, b.lower), hn::Sub(a.upper, b.upper)};
}
HWY_INLINE DoublePair operator*(const DoublePair& a, const DoublePair& b) {
  return {hn::Mul(a.lower, b.lower), hn::Mul(a.upper, b.upper)};
}
HWY_INLINE DoublePair operator/(const DoublePair& a, const DoublePair& b) {
  return {hn::Div(a.lower, b.lower), hn::Div(a.upper, b.upper)};
}
HWY_INLINE DoublePair all(double value) { return {hn::Set(Doubles(), value), hn::Set(Doubles(), value)}; }

/// Of as many triangles as a register holds what drawing them takes, worked out side by side. [corner][triangle]; a
/// corner's edge is the one across from it.
struct Setup {
  alignas(64) std::int32_t at_first[3][most_lanes];    // edge functions at the first pixel of the box; centres on
  alignas(64) std::int32_t is_below[3][most_lanes];    // an edge count as inside where is_below is 0, else it is -1
  alignas(64) std::int32_t per_column[3][most_lanes];  // by how much they grow
  alignas(64) std::int32_t per_row[3][most_lanes];
  alignas(64) std::int32_t first_x[most_lanes], last_x[most_lanes], first_y[most_lanes], last_y[most_lanes];
  alignas(64) std::int32_t extent[most_lanes];
  alignas(64) double depth[4][most_lanes];  // what Depths makes of the corners'
};

/// The exact quotient, rounded down: numerators are whole, below 2^50, and grow evenly; the half that is added keeps
/// them farther from whole multiples of the area than the rounding of two operations reaches.
struct OrthographicDepths {
  static void prepare(const Camera&, Setup& setup, const std::array<IntVector, 3>& depths, IntVector area,
                      std::array<IntVector, 3> at_first, std::array<IntVector, 3> per_column,
                      std::array<IntVector, 3> per_row) {
    const auto weighted = [&](const std::array<IntVector, 3>& weights) HWY_ATTR {
      return to_doubles(weights[0]) * to_doubles(depths[0]) + to_doubles(weights[1]) * to_doubles(depths[1]) +
             to_doubles(weights[2]) * to_doubles(depths[2]);
    };
    store(weighted(at_first) + all(0.5), setup.depth[0]);
    store(weighted(per_column), setup.depth[1]);
    store(weighted(per_row), setup.depth[2]);
    store(all(1) / to_doubles(area), setup.depth[3]);
  }

  static HWY_INLINE void store(const DoublePair& values, double* to) {
    hn::Store(values.lower, Doubles(), to);
    hn::Store(values.upper, Doubles(), to + hn::Lanes(Doubles()));
  }
};

template <class Depths>
HWY_INLINE void set_up(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       const std::uint32_t* triangles, Setup& setup) {
  const Ints d;
  const Words u;
  const hn::Repartition<std::int64_t, Ints> longs;
  const IntVector number = hn::BitCast(d, hn::LoadU(u, triangles));
  std::array<IntVector, 3> x, y, depth;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex = hn::GatherIndex(u, part.corners[i].data(), number);
    const auto gather = [&](auto half) HWY_ATTR {
      return hn::BitCast(d, hn::GatherIndex(longs, reinterpret_cast<const std::int64_t*>(corners.places.data()),
                                            hn::BitCast(longs, hn::PromoteTo(hn::RebindToUnsigned<decltype(longs)>(), half))));
    };
    const auto lower = gather(hn::LowerHalf(vertex));
    const auto upper = gather(hn::UpperHalf(hn::Half<Words>(), vertex));
    x[i] = hn::ConcatEven(d, upper, lower);
    y[i] = hn::ConcatOdd(d, upper, lower);
    depth[i] = hn::BitCast(d, hn::GatherIndex(u, corners.depths.data(), hn::BitCast(d, vertex)));
  }
  const auto least = [](const std::array<IntVector, 3>& v) HWY_ATTR { return hn::Min(v[0], hn::Min(v[1], v[2])); };
  const auto most = [](const std::array<IntVector, 3>& v) HWY_ATTR { return hn::Max(v[0], hn::Max(v[1], v[2])); };
  const IntVector low_x = least(x), high_x = most(x), low_y = least(y), high_y = most(y);
  hn::Store(hn::Max(hn::Sub(high_x, low_x), hn::Sub(high_y, low_y)), d, setup.extent);
  const auto first_centre = [&](IntVector from) HWY_ATTR {
    return hn::ShiftRight<8>(hn::Add(from, hn::Set(d, subpixels / 2 - 1)));
  };
  const auto last_centre = [&](IntVector to) HWY_ATTR {
    return hn::ShiftRight<8>(hn::Sub(to, hn::Set(d, subpixels / 2)));
  };
  const IntVector first_x = first_centre(low_x), first_y = first_centre(low_y);
  hn::Store(first_x, d, setup.first_x);
  hn::Store(first_y, d, setup.first_y);
  hn::Store(last_centre(high_x), d, setup.last_x);
  hn::Store(last_centre(high_y), d, setup.last_y);

  const auto cross = [](IntVector ax, IntVector ay, IntVector bx, IntVector by) HWY_ATTR {
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
  };
  IntVector area = cross(hn::Sub(x[1], x[0]), hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0]), hn::Sub(y[2], y[0]));
  if (!part.culls_back_faces) {
    const auto turns = hn::Lt(area, hn::Zero(d));
    const auto exchange = [&](std::array<IntVector, 3>& v) HWY_ATTR {
      const IntVector second = v[1];
      v[1] = hn::IfThenElse(turns, v[2], second);
      v[2] = hn::IfThenElse(turns, second, v[2]);
    };
    exchange(x);
    exchange(y);
    exchange(depth);
    area = hn::Abs(area);
  }
  if (camera.is_perspective()) {
    // The least corner first, so that sums are rounded alike whichever corner the file names first. One step each turns
    // the corners until the least leads: it does after two at most.
    const auto less = [&](std::size_t i, std::size_t j) HWY_ATTR {
      const auto same_x = hn::Eq(x[i], x[j]), same_y = hn::Eq(y[i], y[j]);
      return hn::Or(hn::Lt(x[i], x[j]),
                    hn::And(same_x, hn::Or(hn::Lt(y[i], y[j]), hn::And(same_y, hn::Lt(depth[i], depth[j])))));
    };
    const auto second = hn::And(less(1, 0), hn::Not(less(2, 1)));
    const auto third = hn::And(less(2, 0), less(2, 1));
    const auto turn = [&](std::array<IntVector, 3>& v) HWY_ATTR {
      const std::array<IntVector, 3> old = v;
      for (std::size_t i = 0; i < 3; ++i) {
        v[i] = hn::IfThenElse(second, old[(i + 1) % 3], hn::IfThenElse(third, old[(i + 2) % 3], old[i]));
      }
    };
    turn(x);
    turn(y);
    turn(depth);
  }
  const IntVector centre_x = hn::Add(hn::ShiftLeft<8>(first_x), hn::Set(d, subpixels / 2));
  const IntVector centre_y = hn::Add(hn::ShiftLeft<8>(first_y), hn::Set(d, subpixels / 2));
  std::array<IntVector, 3> at_first, per_column, per_row;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t p = (i + 1) % 3, q = (i + 2) % 3;
    const IntVector dx = hn::Sub(x[q], x[p]), dy = hn::Sub(y[q], y[p]);
    at_first[i] = cross(dx, dy, hn::Sub(centre_x, x[p]), hn::Sub(centre_y, y[p]));
    per_column[i] = hn::ShiftLeft<8>(hn::Neg(dy));
    per_row[i] = hn::ShiftLeft<8>(dx);
    // Falling lines and those to the left own the centres on them.
    const auto owns = hn::Or(hn::Lt(dy, hn::Zero(d)), hn::And(hn::Eq(dy, hn::Zero(d)), hn::Lt(dx, hn::Zero(d))));
    hn::Store(hn::IfThenElse(owns, hn::Zero(d), hn::Set(d, -1)), d, setup.is_below[i]);
    hn::Store(at_first[i], d, setup.at_first[i]);
    hn::Store(per_column[i], d, setup.per_column[i]);
    hn::Store(per_row[i], d, setup.per_row[i]);
  }
  Depths::prepare(camera, setup, depth, area, at_first, per_column, per_row);
}

// A stamp: four pixels wide, as many rows as the register holds.
constexpr std::int32_t stamp_width = 4;

template <class Depths>
std::size_t draw(const PreparedPart& part, const Corners& corners, const Camera& camera,
                 const std::uint32_t* triangles, std::size_t count, Fragments& fragments) {
  const Ints d;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
  const std::int32_t stamp_height = lanes / stamp_width;
  const std::int32_t size = camera.size();
  const IntVector column = hn::And(hn::Iota(d, 0), hn::Set(d, stamp_width - 1));
  const IntVector row = hn::ShiftRight<2>(hn::Iota(d, 0));
  const IntVector pixel = hn::Add(column, hn::Mul(row, hn::Set(d, size)));
  const DoublePair columns = to_doubles(column);
  const DoublePair rows = to_doubles(row);
  std::uint32_t* pixels = fragments.pixels.data() + fragments.count;
  std::uint32_t* depths = fragments.depths.data() + fragments.count;
  std::uint32_t* numbers = fragments.triangles.data() + fragments.count;
  const std::uint32_t* const full = fragments.pixels.data() + Fragments::most;

  Setup setup;
  std::size_t done = 0;
  for (; done < count && pixels < full; ++done) {
    const std::size_t i = done % hn::Lanes(d);
    if (i == 0 || done == 0) set_up<Depths>(part, corners, camera, triangles + done - i, setup);
    if (setup.extent[i] > most_extent) break;
    const auto all_ints = [&](std::int32_t value) HWY_ATTR { return hn::Set(d, value); };
    const auto across = [&](std::size_t edge) HWY_ATTR {
      return hn::Add(hn::Add(all_ints(setup.at_first[edge][i] + setup.is_below[edge][i]),
                             hn::Mul(column, all_ints(setup.per_column[edge][i]))),
                     hn::Mul(row, all_ints(setup.per_row[edge][i])));
    };
    IntVector a = across(0), b = across(1), c = across(2);
    DoublePair z = all(setup.depth[0][i]) + columns * all(setup.depth[1][i]) + rows * all(setup.depth[2][i]);
    const DoublePair inverse = all(setup.depth[3][i]);
    const IntVector number = hn::Set(d, static_cast<std::int32_t>(part.numbers[triangles[done]]));
    for (std::int32_t y = setup.first_y[i];;) {
      IntVector a_here = a, b_here = b, c_here = c;
      DoublePair z_here = z;
      for (std::int32_t x = setup.first_x[i];;) {
        const auto is_inside = hn::Gt(hn::Or(a_here, hn::Or(b_here, c_here)), hn::Set(d, -1));
        hn::StoreU(hn::BitCast(Words(), hn::Compress(hn::Add(pixel, hn::Set(d, y * size + x)), is_inside)), Words(), pixels);
        hn::StoreU(hn::BitCast(Words(), hn::Compress(to_ints(z_here * inverse), is_inside)), Words(), depths);
        hn::StoreU(hn::BitCast(Words(), number), Words(), numbers);
        const std::size_t covered = hn::CountTrue(d, is_inside);
        pixels += covered;
        depths += covered;
        numbers += covered;
        x += stamp_width;
        if (x > setup.last_x[i]) break;
        a_here = hn::Add(a_here, all_ints(stamp_width * setup.per_column[0][i]));
        b_here = hn::Add(b_here, all_ints(stamp_width * setup.per_column[1][i]));
        c_here = hn::Add(c_here, all_ints(stamp_width * setup.per_column[2][i]));
        z_here = z_here + all(stamp_width * setup.depth[1][i]);
      }
      y += stamp_height;
      if (y > setup.last_y[i]) break;
      a = hn::Add(a, all_ints(stamp_height * setup.per_row[0][i]));
      b = hn::Add(b, all_ints(stamp_height * setup.per_row[1][i]));
      c = hn::Add(c, all_ints(stamp_height * setup.per_row[2][i]));
      z = z + all(stamp_height * setup.depth[2][i]);
    }
  }
  fragments.count = static_cast<std::size_t>(pixels - fragments.pixels.data());
  return done;
}

std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       const std::uint32_t* triangles, std::size_t count, Fragments& fragments) {
  if (camera.is_perspective()) return 0;
  return draw<OrthographicDepths>(part, corners, camera, triangles, count, fragments);
}

#endif

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

HWY_EXPORT(draw_small);

std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       std::span<const std::uint32_t> triangles, Fragments& fragments) {
  return HWY_DYNAMIC_DISPATCH(draw_small)(part, corners, camera, triangles.data(), triangles.size(), fragments);
}

}  // namespace foredraw
#endif
