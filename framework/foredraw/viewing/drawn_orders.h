#pragma once
// Which of its orders a subject is drawn in, and in which sequence its parts, from each side and in each pose: as its
// tables say.

#include <foredraw/base/content_hash.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/subject_geometry.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Who says in which sequence parts are drawn.
enum class SequenceFrom {
  table,     ///< the subject's tables, else the file
  file,      ///< the file's walk, as engines have it that keep to it and read no table
  material,  ///< the material's number, draws of one material as in the file: near to what engines do that sort
};

/// Views that show a subject's parts in the same orders and sequence.
struct ViewsOfOrders {
  std::vector<std::uint32_t> orders;    ///< [part]; 0 where no table says anything
  std::vector<std::uint32_t> sequence;  ///< [rank] = part
  std::vector<std::size_t> views;       ///< their numbers, rising
};

/// All views once, those of like orders together. A view's direction is looked up as it is: in the space that the
/// subject's positions are in (posed_positions()). Parts that a table does not name keep their places in its sequences.
std::vector<ViewsOfOrders> views_by_orders(const Scene& scene, const Subject& subject, const Pose& pose,
                                           std::span<const View> views, SequenceFrom said_by = SequenceFrom::table);

/// All of the subject's parts as an engine draws them, [rank] = part, that was told a sequence of the table's parts.
/// The parts that the table does not name keep their places.
std::vector<std::uint32_t> parts_in_sequence(const Subject& subject, const OrderTable& table,
                                             std::span<const std::uint16_t> sequence);

/// Those of the views.
Views chosen(const Views& views, std::span<const std::size_t> numbers);

/// The parts as they are drawn, [rank]: in these orders, in this sequence. They live as long as `posed` and the scene.
std::vector<RasterPart> parts_as_drawn(const SubjectGeometry& posed, const Scene& scene, const Subject& subject,
                                       const ViewsOfOrders& as);

/// Of what the subject's tables say in the pose, all sides together.
Stamp orders_stamp(const Scene& scene, const Subject& subject, const Pose& pose);

}  // namespace foredraw
