#include "seen_triangles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/analysis/seen_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::uint64_t* seen) {
  std::size_t count = 0;
  for (std::size_t t = begin; t < end; ++t) {
    const Corner a = corners[part.corners[0][t]], b = corners[part.corners[1][t]], c = corners[part.corners[2][t]];
    const std::int64_t area = doubled_area(a, b, c);
    if (area == 0 || (area < 0 && part.culls_back_faces) || PixelBox(a, b, c).is_empty()) continue;
    seen[count++] = t;
  }
  return count;
}

#else

using Longs = hn::CappedTag<std::int64_t, PreparedPart::padding>;
using Halves = hn::Repartition<std::int32_t, Longs>;  // x, y, x, y...

hn::Vec<Halves> places_of(const std::uint32_t* vertices, const Corners& corners) {
  const Longs d;
  const auto indices = hn::BitCast(d, hn::PromoteTo(hn::RebindToUnsigned<Longs>(),
                                                    hn::LoadU(hn::Rebind<std::uint32_t, Longs>(), vertices)));
  return hn::BitCast(Halves(), hn::GatherIndex(d, reinterpret_cast<const std::int64_t*>(corners.places.data()), indices));
}

std::size_t find_seen(const PreparedPart& part, const Corners& corners, std::size_t begin, std::size_t end,
                      std::uint64_t* seen) {
  const Longs d;
  const Halves h;
  std::size_t count = 0;
  for (std::size_t t = begin; t < end; t += hn::Lanes(d)) {
    const auto a = places_of(&part.corners[0][t], corners);
    const auto b = places_of(&part.corners[1][t], corners);
    const auto c = places_of(&part.corners[2][t], corners);
    const auto ab = hn::Sub(b, a);
    const auto ac = hn::Sub(c, a);
    auto area = hn::Sub(hn::MulEven(ab, hn::Shuffle2301(ac)), hn::MulEven(hn::Shuffle2301(ab), ac));
    if (!part.culls_back_faces) area = hn::Abs(area);
    // As PixelBox says it.
    const auto first = hn::ShiftRight<8>(hn::Add(hn::Min(a, hn::Min(b, c)), hn::Set(h, subpixels / 2 - 1)));
    const auto last = hn::ShiftRight<8>(hn::Sub(hn::Max(a, hn::Max(b, c)), hn::Set(h, subpixels / 2)));
    const auto more = hn::Sub(last, first);  // negative where there is none
    // What is unseen is negative in one of three.
    const auto signs = hn::Or(hn::Sub(area, hn::Set(d, 1)), hn::BitCast(d, hn::Or(more, hn::Shuffle2301(more))));
    const auto is_seen = hn::Gt(signs, hn::Set(d, -1));
    hn::StoreU(hn::Compress(hn::Iota(d, static_cast<std::int64_t>(t)), is_seen), d,
               reinterpret_cast<std::int64_t*>(seen + count));
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
                      std::span<std::uint64_t> seen) {
  return HWY_DYNAMIC_DISPATCH(find_seen)(part, corners, begin, end, seen.data());
}

}  // namespace foredraw
#endif
