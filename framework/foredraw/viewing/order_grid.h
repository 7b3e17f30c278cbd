#pragma once
// From looks (a pose seen from a direction) to the table that an engine looks up.

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/views.h>

#include <span>

namespace foredraw {

/// How finely an order table tells directions apart.
struct OrderGrid {
  int theta_steps = 16;
  int phi_steps = 32;
};

/// Keyframes are the poses, clip by clip; without clips the table has one keyframe, the only pose. A cell names the
/// order that serves the view nearest to its middle. `serving`: [pose * number of views + view].
OrderTable order_table(const Scene& scene, const Poses& poses, const Views& views,
                       std::span<const std::uint8_t> serving, const OrderGrid& grid);

}  // namespace foredraw
