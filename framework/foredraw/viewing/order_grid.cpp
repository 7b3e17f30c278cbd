#include <foredraw/viewing/order_grid.h>

#include <foredraw/viewing/order_lookup.h>
#include <foredraw/viewing/pose_set.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

/// [cell] the view whose direction is nearest to its middle.
std::vector<std::size_t> nearest_views(const OrderTable& table, const Views& views) {
  std::vector<std::size_t> nearest;
  for (std::uint32_t theta = 0; theta < table.theta_steps; ++theta) {
    for (std::uint32_t phi = 0; phi < table.phi_steps; ++phi) {
      const glm::dvec3 middle = middle_of_cell(table, theta, phi);
      std::size_t best = 0;
      for (std::size_t v = 1; v < views.views.size(); ++v) {
        if (glm::dot(views.views[v].direction, middle) > glm::dot(views.views[best].direction, middle)) best = v;
      }
      nearest.push_back(best);
    }
  }
  return nearest;
}

}  // namespace

OrderTable order_table(const Scene& scene, const Poses& poses, const Views& views,
                       std::span<const std::uint8_t> serving, const OrderGrid& grid) {
  OrderTable table;
  table.theta_steps = static_cast<std::uint32_t>(grid.theta_steps);
  table.phi_steps = static_cast<std::uint32_t>(grid.phi_steps);
  std::map<AnimationId, std::vector<std::size_t>> clips;  // their poses
  for (std::size_t pose = 0; pose < poses.poses.size(); ++pose) {
    if (poses.poses[pose].clip) clips[*poses.poses[pose].clip].push_back(pose);
  }
  const std::vector<std::size_t> nearest = nearest_views(table, views);
  const auto add_keyframe = [&](std::size_t pose) {
    for (const std::size_t view : nearest) table.order.push_back(serving[pose * views.views.size() + view]);
  };
  if (clips.empty()) add_keyframe(0);
  const std::vector<std::string> names = clip_names(scene);
  for (const auto& [clip, keyframes] : clips) {
    table.clips.push_back({names[clip], {}});
    for (const std::size_t pose : keyframes) {
      table.clips.back().times.push_back(static_cast<float>(poses.poses[pose].time));
      add_keyframe(pose);
    }
  }
  return table;
}

}  // namespace foredraw
