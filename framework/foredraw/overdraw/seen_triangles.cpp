#include <foredraw/overdraw/private/seen_triangles.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/overdraw/seen_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <foredraw/overdraw/private/vectors.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::uint32_t* seen) {
  std::size_t count = 0;
  for (std::size_t t = begin; t < end; ++t) {
    const Corner a = corners[part.corners[0][t]], b = corners[part.corners[1][t]], c = corners[part.corners[2][t]];
    const std::int64_t area = doubled_area(a, b, c);
    if (area == 0 || (area < 0 && part.culls_back_faces) || PixelBox(a, b, c).is_empty()) continue;
    seen[count++] = static_cast<std::uint32_t>(t);
  }
  return count;
}

#else

using Longs = hn::Repartition<std::int64_t, Ints>;
using Places = IntVector;  // x, y, x, y...
static_assert(PreparedPart::padding % most_lanes == 0);

HWY_INLINE Places places_of(const std::uint32_t* vertices, const Corners& corners) {
  return hn::BitCast(Ints(), gathered(hn::RebindToUnsigned<Longs>(), vertices, corners.points.data()));
}

/// The odd ones are negative where a triangle is unseen.
HWY_INLINE Places signs_of(const PreparedPart& part, const Corners& corners, std::size_t triangle) {
  const Longs d;
  const Ints h;
  const Places a = places_of(&part.corners[0][triangle], corners);
  const Places b = places_of(&part.corners[1][triangle], corners);
  const Places c = places_of(&part.corners[2][triangle], corners);
  const Places ab = hn::Sub(b, a);
  const Places ac = hn::Sub(c, a);
  auto area = hn::Sub(hn::MulEven(ab, hn::Shuffle2301(ac)), hn::MulEven(hn::Shuffle2301(ab), ac));
  if (!part.culls_back_faces) area = hn::Abs(area);
  // As PixelBox says it.
  const Places first = hn::ShiftRight<8>(hn::Add(hn::Min(a, hn::Min(b, c)), hn::Set(h, subpixels / 2 - 1)));
  const Places last = hn::ShiftRight<8>(hn::Sub(hn::Max(a, hn::Max(b, c)), hn::Set(h, subpixels / 2)));
  const Places more = hn::Sub(last, first);
  return hn::Or(hn::BitCast(h, hn::Sub(area, hn::Set(d, 1))), hn::Or(more, hn::Shuffle2301(more)));
}

std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::uint32_t* seen) {
  const Ints d;
  std::size_t count = 0;
  for (std::size_t t = begin; t < end; t += hn::Lanes(d)) {
    const Places lower = signs_of(part, corners, t), upper = signs_of(part, corners, t + hn::Lanes(d) / 2);
    const IntMask is_seen = hn::Gt(hn::ConcatOdd(d, upper, lower), all(-1));
    store_words(compressed(hn::Iota(d, static_cast<std::int32_t>(t)), is_seen), seen + count);
    count += hn::CountTrue(d, is_seen);
  }
  return count;
}

#endif

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

HWY_EXPORT(find_seen);

std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::span<std::uint32_t> seen) {
  return HWY_DYNAMIC_DISPATCH(find_seen)(part, corners, begin, end, seen.data());
}

}  // namespace foredraw
#endif
