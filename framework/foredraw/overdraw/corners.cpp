#include <foredraw/overdraw/corners.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "foredraw/overdraw/corners.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foredraw::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, PreparedPart::padding>;
using Vector = hn::Vec<Doubles>;

HWY_INLINE Vector dot(const std::array<Vector, 3>& position, const glm::dvec3& axis) {
  const Doubles d;
  return hn::Add(hn::Add(hn::Mul(position[0], hn::Set(d, axis.x)), hn::Mul(position[1], hn::Set(d, axis.y))),
                 hn::Mul(position[2], hn::Set(d, axis.z)));
}

/// To the nearest whole number from 0 to `most`.
HWY_INLINE auto rounded(Vector value, double most) {
  const Doubles d;
  const Vector whole = hn::Floor(hn::Add(value, hn::Set(d, 0.5)));
  return hn::DemoteTo(hn::Rebind<std::int32_t, Doubles>(), hn::Min(hn::Max(whole, hn::Zero(d)), hn::Set(d, most)));
}

void project(const PreparedPart& part, const Camera& camera, Corners& corners) {
  const Doubles d;
  const hn::Rebind<std::uint64_t, Doubles> words;
  const hn::Rebind<std::uint32_t, Doubles> halves;
  const Vector half = hn::Set(d, camera.half());
  for (std::size_t first = 0; first < part.vertex_count(); first += hn::Lanes(d)) {
    std::array<Vector, 3> position;
    for (std::size_t axis = 0; axis < 3; ++axis) position[axis] = hn::LoadU(d, &part.positions[axis][first]);
    const Vector near = dot(position, camera.towards());
    const Vector scale = camera.is_perspective() ? hn::Div(hn::Set(d, camera.half() * camera.focal()),
                                                           hn::Sub(hn::Set(d, camera.distance()), near))
                                                 : half;
    const auto x = rounded(hn::Add(half, hn::Mul(dot(position, camera.right()), scale)), camera.extent());
    const auto y = rounded(hn::Add(half, hn::Mul(dot(position, camera.up()), scale)), camera.extent());
    const auto depth = rounded(hn::Mul(hn::Sub(hn::Set(d, 1), near), hn::Set(d, depth_steps)), 2 * depth_steps - 1);
    const auto place = hn::Or(hn::PromoteTo(words, hn::BitCast(halves, x)),
                              hn::ShiftLeft<32>(hn::PromoteTo(words, hn::BitCast(halves, y))));
    hn::StoreU(place, words, &corners.points[first]);
    hn::StoreU(hn::BitCast(halves, depth), halves, &corners.depths[first]);
  }
}

}  // namespace foredraw::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

HWY_EXPORT(project);

void project(const PreparedPart& part, const Camera& camera, Corners& corners) {
  corners.points.resize(part.vertex_count());
  corners.depths.resize(part.vertex_count());
  HWY_DYNAMIC_DISPATCH(project)(part, camera, corners);
}

}  // namespace foredraw
#endif
