#pragma once
// What an engine looks up each frame, looked up here: runtime/order_table.h says where cells lie.

#include <foredraw/runtime/order_table.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/poses.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// A table ready to be asked. It must outlive this.
class OrderLookup {
 public:
  /// `clip_names`: clip_names() of the scene, by which the table names its clips.
  OrderLookup(const OrderTable& table, std::span<const std::string> clip_names);
  OrderLookup(OrderLookup&&) = default;  // a copy would look into what it was copied from

  /// The cells [theta][phi] of the keyframe nearest to the pose; none where the table does not know the pose's clip, so
  /// that all draw order 0.
  std::span<const std::uint8_t> cells_in(const Pose& pose) const;

  /// The cell that a direction is in, among those of a keyframe.
  std::size_t cell_of(const glm::dvec3& direction) const;

  const foredraw_order_table& table() const { return table_; }

 private:
  std::span<const std::uint8_t> order_;
  std::vector<std::uint32_t> clip_of_;  ///< [clip of the scene] its number in the table, or FOREDRAW_NO_CLIP
  std::vector<std::uint32_t> keyframes_;
  std::vector<float> times_;
  foredraw_order_table table_;
};

/// The direction through the middle of a cell, of unit length. The same bits on every machine.
glm::dvec3 middle_of_cell(const OrderTable& table, std::uint32_t theta, std::uint32_t phi);

/// How much of all looks each order serves: cells weigh as much as they cover of the sphere, keyframes all alike. As
/// many as the table names; they add up to 1.
std::vector<double> shares_of_orders(const OrderTable& table);

/// An order of a draw, and how much of all looks it serves.
struct ServedOrder {
  const IndexStream* stream;
  double share = 1;

  std::span<const std::uint32_t> indices() const { return stream->indices.view(); }
};

/// Of level 0, as the draw's table says; without one, all is drawn in the order that stands alone. Orders that serve no
/// look are left out. They live as long as the scene.
std::vector<ServedOrder> served_orders(const Scene& scene, DrawId draw);

}  // namespace foredraw
