#include <foredraw/overdraw/private/small_triangles.h>

// Two ideas. What a triangle takes before its first pixel is worked out for as many triangles as a register holds, side
// by side, and so are the first pixels of those that have two by two at most. The others are drawn one after the other,
// a stamp of pixels at a time.

#include <array>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/overdraw/small_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <foredraw/overdraw/private/vectors.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

std::size_t draw_small(const PreparedPart&, const Corners&, const Camera&, const std::uint32_t*, std::size_t,
                       Fragments&) {
  return 0;  // nothing to gain: all are drawn as large ones
}

#else

constexpr std::int32_t stamp_width = 4;

using ThreeInts = std::array<IntVector, 3>;
using FourInts = std::array<IntVector, 4>;

HWY_INLINE IntVector least_of(const ThreeInts& v) { return hn::Min(v[0], hn::Min(v[1], v[2])); }
HWY_INLINE IntVector most_of(const ThreeInts& v) { return hn::Max(v[0], hn::Max(v[1], v[2])); }

HWY_INLINE ThreeInts sum(const ThreeInts& a, const ThreeInts& b) {
  return {hn::Add(a[0], b[0]), hn::Add(a[1], b[1]), hn::Add(a[2], b[2])};
}

/// `bit` where all three are 0 or more, else 0.
HWY_INLINE IntVector bit_inside(const ThreeInts& inside, std::int32_t bit) {
  const IntVector any = hn::Or(inside[0], hn::Or(inside[1], inside[2]));
  return hn::AndNot(hn::ShiftRight<31>(any), all(bit));
}

/// What drawing some triangles takes: [corner][triangle], a corner's edge being the one across from it.
struct Setup {
  alignas(64) std::int32_t at_first[3][most_lanes];  // edge functions at the first pixel of the box, less 1 where the
                                                     // edge does not own what lies on it: inside is 0 or more
  alignas(64) std::int32_t below[3][most_lanes];     // -1 there, else 0
  alignas(64) std::int32_t per_column[3][most_lanes];
  alignas(64) std::int32_t per_row[3][most_lanes];
  alignas(64) std::int32_t first_x[most_lanes], last_x[most_lanes], first_y[most_lanes], last_y[most_lanes];
  alignas(64) std::int32_t pixel[most_lanes];  // the first of the box
  alignas(64) std::int32_t nearest[most_lanes];
  alignas(64) double depths[4][most_lanes];               // a different thing to each kind of depth
  alignas(64) std::int32_t tiny_depths[4 * most_lanes];   // of the first two by two pixels
  alignas(64) std::int32_t tiny_covered[most_lanes];      // which of them are covered, bit after bit
  std::uint32_t is_large = 0, is_tiny = 0, is_empty = 0;  // a bit for each triangle
  std::uint32_t is_behind = 0;                            // drawn from behind
};

/// OrthographicDepth. Depths are taken from the nearest corner on. Numerators are whole numbers that grow evenly; they
/// and the half that is added stay below 2^52, and keep the quotient half an area's fraction from the whole number that
/// it is rounded down to. Two roundings of the quotient are less: it is below `spread`, and spread * area below 2^50.
struct OrthographicStamp {
  DoublePair numerator, inverse, per_stamp, per_stamp_row;
  IntVector nearest;

  static HWY_INLINE FourInts prepare(const Camera&, Setup& setup, const ThreeInts& at_first,
                                     const ThreeInts& per_column, const ThreeInts& per_row, const ThreeInts& depths,
                                     const DoublePair& area) {
    const IntVector nearest = least_of(depths);
    const ThreeInts beyond = {hn::Sub(depths[0], nearest), hn::Sub(depths[1], nearest), hn::Sub(depths[2], nearest)};
    const DoublePair first = weighted(at_first, beyond) + both(0.5);
    const DoublePair right = weighted(per_column, beyond), up = weighted(per_row, beyond);
    const DoublePair inverse = both(1) / area;
    hn::Store(nearest, Ints(), setup.nearest);
    store(first, setup.depths[0]);
    store(right, setup.depths[1]);
    store(up, setup.depths[2]);
    store(inverse, setup.depths[3]);
    return {hn::Add(to_ints(first * inverse), nearest), hn::Add(to_ints((first + right) * inverse), nearest),
            hn::Add(to_ints((first + up) * inverse), nearest),
            hn::Add(to_ints((first + right + up) * inverse), nearest)};
  }

  static HWY_INLINE IntMask is_inexact(const ThreeInts& depths, const DoublePair& box) {
    const DoublePair spread = to_doubles(hn::Sub(most_of(depths), least_of(depths)));
    return is_more(spread * box, 0x1p50);
  }

  static HWY_INLINE DoublePair weighted(const ThreeInts& weights, const ThreeInts& depths) {
    return to_doubles(weights[0]) * to_doubles(depths[0]) + to_doubles(weights[1]) * to_doubles(depths[1]) +
           to_doubles(weights[2]) * to_doubles(depths[2]);
  }

  HWY_INLINE OrthographicStamp(const Camera&, const Setup& setup, std::size_t i, const DoublePair& columns,
                               const DoublePair& rows, int stamp_height)
      : numerator(both(setup.depths[0][i]) + columns * both(setup.depths[1][i]) + rows * both(setup.depths[2][i])),
        inverse(both(setup.depths[3][i])),
        per_stamp(both(stamp_width * setup.depths[1][i])),
        per_stamp_row(both(stamp_height * setup.depths[2][i])),
        nearest(all(setup.nearest[i])) {}

  HWY_INLINE IntVector at(const ThreeInts&) const { return hn::Add(to_ints(numerator * inverse), nearest); }
  HWY_INLINE void right() { numerator = numerator + per_stamp; }
  HWY_INLINE void up() { numerator = numerator + per_stamp_row; }
};

/// PerspectiveDepth.
struct PerspectiveStamp {
  std::array<DoublePair, 3> inverses;
  DoublePair area, before;
  ThreeInts below;

  static HWY_INLINE FourInts prepare(const Camera& camera, Setup& setup, const ThreeInts& at_first,
                                     const ThreeInts& per_column, const ThreeInts& per_row, const ThreeInts& depths,
                                     const DoublePair& area) {
    const DoublePair before = both(camera.steps_before_sphere());
    std::array<DoublePair, 3> inverses;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      inverses[corner] = both(1) / (before + to_doubles(depths[corner]));
      store(inverses[corner], setup.depths[corner]);
    }
    store(area, setup.depths[3]);
    const ThreeInts right = sum(at_first, per_column), up = sum(at_first, per_row);
    return {depth(at_first, inverses, area, before), depth(right, inverses, area, before),
            depth(up, inverses, area, before), depth(sum(right, per_row), inverses, area, before)};
  }

  static HWY_INLINE IntMask is_inexact(const ThreeInts&, const DoublePair&) {
    return hn::MaskFromVec(hn::Zero(Ints()));
  }

  static HWY_INLINE IntVector depth(const ThreeInts& weights, const std::array<DoublePair, 3>& inverses,
                                    const DoublePair& area, const DoublePair& before) {
    const DoublePair inverse = to_doubles(weights[0]) * inverses[0] + to_doubles(weights[1]) * inverses[1] +
                               to_doubles(weights[2]) * inverses[2];
    return to_ints(at_least_zero(area / inverse - before + both(0.5)));
  }

  HWY_INLINE PerspectiveStamp(const Camera& camera, const Setup& setup, std::size_t i, const DoublePair&,
                              const DoublePair&, int)
      : inverses{both(setup.depths[0][i]), both(setup.depths[1][i]), both(setup.depths[2][i])},
        area(both(setup.depths[3][i])),
        before(both(camera.steps_before_sphere())),
        below{all(setup.below[0][i]), all(setup.below[1][i]), all(setup.below[2][i])} {}

  HWY_INLINE IntVector at(const ThreeInts& inside) const {
    return depth({hn::Sub(inside[0], below[0]), hn::Sub(inside[1], below[1]), hn::Sub(inside[2], below[2])}, inverses,
                 area, before);
  }
  HWY_INLINE void right() {}
  HWY_INLINE void up() {}
};

HWY_INLINE IntVector cross(IntVector ax, IntVector ay, IntVector bx, IntVector by) {
  return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

HWY_INLINE void exchange(IntMask where, IntVector& a, IntVector& b) {
  const IntVector old = a;
  a = hn::IfThenElse(where, b, a);
  b = hn::IfThenElse(where, old, b);
}

/// v[i] becomes v[i + 1] where `once`, v[i + 2] where `twice`.
HWY_INLINE void turn(IntMask once, IntMask twice, ThreeInts& v) {
  const ThreeInts old = v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = hn::IfThenElse(once, old[(i + 1) % 3], hn::IfThenElse(twice, old[(i + 2) % 3], old[i]));
  }
}

HWY_INLINE void fetch(const Corners& corners, const std::vector<std::uint32_t>& vertices, IntVector triangles,
                      IntVector& x, IntVector& y, IntVector& depth) {
  const Ints d;
  const hn::Repartition<std::uint64_t, Ints> longs;
  const auto vertex = hn::BitCast(d, hn::GatherIndex(Words(), vertices.data(), triangles));
  alignas(64) std::uint32_t at[most_lanes];
  store_words(vertex, at);
  const auto lower = hn::BitCast(d, gathered(longs, at, corners.points.data()));
  const auto upper = hn::BitCast(d, gathered(longs, at + hn::Lanes(longs), corners.points.data()));
  x = hn::ConcatEven(d, upper, lower);
  y = hn::ConcatOdd(d, upper, lower);
  depth = hn::BitCast(d, hn::GatherIndex(Words(), corners.depths.data(), vertex));
}

/// For the first `count` triangles, at most as many as there are lanes.
template <class Stamp>
HWY_INLINE void set_up(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       const std::uint32_t* triangles, std::size_t count, Setup& setup) {
  const Ints d;
  const IntVector zero = hn::Zero(d);
  ThreeInts x, y, depth;
  const IntVector triangle = hn::IfThenElseZero(hn::FirstN(d, count), load_words(triangles));
  for (std::size_t i = 0; i < 3; ++i) fetch(corners, part.corners[i], triangle, x[i], y[i], depth[i]);

  IntVector area = cross(hn::Sub(x[1], x[0]), hn::Sub(y[1], y[0]), hn::Sub(x[2], x[0]), hn::Sub(y[2], y[0]));
  if (!part.culls_back_faces) {
    const IntMask is_back = hn::Lt(area, zero);
    exchange(is_back, x[1], x[2]);
    exchange(is_back, y[1], y[2]);
    exchange(is_back, depth[1], depth[2]);
    area = hn::Abs(area);
    setup.is_behind = bits_of(is_back);
  }
  if (camera.is_perspective()) {
    // The least corner first, so that sums are rounded alike whichever corner the file names first.
    const IntMask second = hn::And(is_less(x[1], y[1], depth[1], x[0], y[0], depth[0]),
                                   hn::Not(is_less(x[2], y[2], depth[2], x[1], y[1], depth[1])));
    const IntMask third = hn::And(is_less(x[2], y[2], depth[2], x[0], y[0], depth[0]),
                                  is_less(x[2], y[2], depth[2], x[1], y[1], depth[1]));
    turn(second, third, x);
    turn(second, third, y);
    turn(second, third, depth);
  }

  const IntVector low_x = least_of(x), high_x = most_of(x), low_y = least_of(y), high_y = most_of(y);
  const IntVector first_x = hn::ShiftRight<8>(hn::Add(low_x, all(subpixels / 2 - 1)));
  const IntVector first_y = hn::ShiftRight<8>(hn::Add(low_y, all(subpixels / 2 - 1)));
  const IntVector last_x = hn::ShiftRight<8>(hn::Sub(high_x, all(subpixels / 2)));
  const IntVector last_y = hn::ShiftRight<8>(hn::Sub(high_y, all(subpixels / 2)));
  const IntVector centre_x = hn::Add(hn::ShiftLeft<8>(first_x), all(subpixels / 2));
  const IntVector centre_y = hn::Add(hn::ShiftLeft<8>(first_y), all(subpixels / 2));
  ThreeInts at_first, inside, per_column, per_row;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t p = (i + 1) % 3, q = (i + 2) % 3;
    const IntVector dx = hn::Sub(x[q], x[p]), dy = hn::Sub(y[q], y[p]);
    at_first[i] = cross(dx, dy, hn::Sub(centre_x, x[p]), hn::Sub(centre_y, y[p]));
    per_column[i] = hn::ShiftLeft<8>(hn::Neg(dy));
    per_row[i] = hn::ShiftLeft<8>(dx);
    const IntMask is_top_or_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Lt(dx, zero)));
    const IntVector below = hn::IfThenElse(is_top_or_left, zero, all(-1));
    inside[i] = hn::Add(at_first[i], below);
    hn::Store(inside[i], d, setup.at_first[i]);
    hn::Store(below, d, setup.below[i]);
    hn::Store(per_column[i], d, setup.per_column[i]);
    hn::Store(per_row[i], d, setup.per_row[i]);
  }
  hn::Store(first_x, d, setup.first_x);
  hn::Store(first_y, d, setup.first_y);
  hn::Store(last_x, d, setup.last_x);
  hn::Store(last_y, d, setup.last_y);
  hn::Store(hn::Add(hn::Mul(first_y, all(camera.size())), first_x), d, setup.pixel);

  const FourInts depths = Stamp::prepare(camera, setup, at_first, per_column, per_row, depth, to_doubles(area));
  hn::StoreInterleaved4(depths[0], depths[1], depths[2], depths[3], d, setup.tiny_depths);
  const ThreeInts right = sum(inside, per_column), up = sum(inside, per_row);
  const IntVector covered = hn::Or(hn::Or(bit_inside(inside, 1), bit_inside(right, 2)),
                                   hn::Or(bit_inside(up, 4), bit_inside(sum(right, per_row), 8)));
  hn::Store(covered, d, setup.tiny_covered);
  const IntMask is_tiny = hn::Lt(hn::Max(hn::Sub(last_x, first_x), hn::Sub(last_y, first_y)), all(2));
  const IntVector width = hn::Sub(high_x, low_x), height = hn::Sub(high_y, low_y);
  setup.is_large = bits_of(hn::Or(hn::Gt(hn::Max(width, height), all(most_small_extent)),
                                  Stamp::is_inexact(depth, to_doubles(width) * to_doubles(height))));
  setup.is_tiny = bits_of(is_tiny);
  setup.is_empty = bits_of(hn::And(is_tiny, hn::Eq(covered, zero)));
}

template <class Stamp>
std::size_t draw(const PreparedPart& part, const Corners& corners, const Camera& camera, const std::uint32_t* triangles,
                 std::size_t count, Fragments& fragments) {
  const Ints d;
  const std::size_t lanes = hn::Lanes(d);
  const std::int32_t stamp_height = static_cast<std::int32_t>(lanes) / stamp_width;
  const IntVector column = hn::And(hn::Iota(d, 0), all(stamp_width - 1));
  const IntVector row = hn::ShiftRight<2>(hn::Iota(d, 0));
  const IntVector pixel_of_lane = hn::Add(column, hn::Mul(row, all(camera.size())));
  const DoublePair columns = to_doubles(column);
  const DoublePair rows = to_doubles(row);

  const hn::CappedTag<std::int32_t, 4> four;
  const hn::RebindToUnsigned<decltype(four)> four_words;
  alignas(16) const std::int32_t tiny_pixels[4] = {0, 1, camera.size(), camera.size() + 1};
  const auto pixel_of_four = hn::Load(four, tiny_pixels);

  Setup setup;
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t some = std::min(lanes, count - begin);
    set_up<Stamp>(part, corners, camera, triangles + begin, some, setup);
    std::uint32_t left = ((1u << some) - 1) & ~setup.is_empty;
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t number = part.number(triangles[begin + i], (setup.is_behind >> i & 1) != 0);
      if (setup.is_tiny >> i & 1) {
        const auto bits = static_cast<std::uint32_t>(setup.tiny_covered[i]);
        const auto pixels = hn::Add(hn::Set(four, setup.pixel[i]), pixel_of_four);
        const std::size_t to = fragments.count;
        hn::StoreU(hn::BitCast(four_words, compressed(four, pixels, bits)), four_words, &fragments.pixels[to]);
        hn::StoreU(hn::BitCast(four_words, compressed(four, hn::Load(four, &setup.tiny_depths[4 * i]), bits)),
                   four_words, &fragments.depths[to]);
        hn::StoreU(hn::Set(four_words, number), four_words, &fragments.triangles[to]);
        fragments.count += static_cast<std::size_t>(std::popcount(bits));
        continue;
      }
      if (fragments.is_full() || (setup.is_large >> i & 1) != 0) return begin + i;
      ThreeInts inside;
      for (std::size_t e = 0; e < 3; ++e) {
        inside[e] = hn::Add(all(setup.at_first[e][i]), hn::Add(hn::Mul(column, all(setup.per_column[e][i])),
                                                               hn::Mul(row, all(setup.per_row[e][i]))));
      }
      Stamp stamp(camera, setup, i, columns, rows, stamp_height);
      std::int32_t pixel = setup.pixel[i];
      for (std::int32_t y = setup.first_y[i]; y <= setup.last_y[i]; y += stamp_height) {
        ThreeInts here = inside;
        Stamp stamp_here = stamp;
        for (std::int32_t x = setup.first_x[i]; x <= setup.last_x[i]; x += stamp_width) {
          const IntMask is_covered = hn::Gt(hn::Or(here[0], hn::Or(here[1], here[2])), all(-1));
          const std::size_t to = fragments.count;
          const IntVector pixels = hn::Add(pixel_of_lane, all(pixel + x - setup.first_x[i]));
          store_words(compressed(pixels, is_covered), &fragments.pixels[to]);
          store_words(compressed(stamp_here.at(here), is_covered), &fragments.depths[to]);
          store_words(all(static_cast<std::int32_t>(number)), &fragments.triangles[to]);
          fragments.count += hn::CountTrue(d, is_covered);
          for (std::size_t e = 0; e < 3; ++e) here[e] = hn::Add(here[e], all(stamp_width * setup.per_column[e][i]));
          stamp_here.right();
        }
        for (std::size_t e = 0; e < 3; ++e) inside[e] = hn::Add(inside[e], all(stamp_height * setup.per_row[e][i]));
        stamp.up();
        pixel += stamp_height * camera.size();
      }
    }
  }
  return count;
}

std::size_t draw_small(const PreparedPart& part, const Corners& corners, const Camera& camera,
                       const std::uint32_t* triangles, std::size_t count, Fragments& fragments) {
  return camera.is_perspective() ? draw<PerspectiveStamp>(part, corners, camera, triangles, count, fragments)
                                 : draw<OrthographicStamp>(part, corners, camera, triangles, count, fragments);
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
