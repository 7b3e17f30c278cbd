#pragma once
// Which of its orders a subject is drawn in, from each side and in each pose: as its tables say.

#include <foredraw/base/content_hash.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/subject_geometry.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Views that show a subject's parts in the same orders.
struct ViewsOfOrders {
  std::vector<std::uint32_t> orders;  ///< [part]; 0 where no table says anything
  std::vector<std::size_t> views;     ///< their numbers, rising
};

/// All views once, those of like orders together. A view's direction is looked up as it is: in the space that the
/// subject's positions are in (posed_positions()).
std::vector<ViewsOfOrders> views_by_orders(const Scene& scene, const Subject& subject, const Pose& pose,
                                           std::span<const View> views);

/// Those of the views.
Views chosen(const Views& views, std::span<const std::size_t> numbers);

/// Draws the parts in these orders.
void set_orders(SubjectGeometry& drawn, const Scene& scene, const Subject& subject,
                std::span<const std::uint32_t> orders);

/// Of what the subject's tables say in the pose, all sides together.
Stamp orders_stamp(const Scene& scene, const Subject& subject, const Pose& pose);

}  // namespace foredraw
