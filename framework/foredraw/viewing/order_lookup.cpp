#include <foredraw/viewing/order_lookup.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>

namespace foredraw {

OrderLookup::OrderLookup(const OrderTable& table, std::span<const std::string> clip_names)
    : order_(table.order), clip_of_(clip_names.size(), FOREDRAW_NO_CLIP) {
  for (std::uint32_t clip = 0; clip < table.clips.size(); ++clip) {
    const auto named = std::ranges::find(clip_names, table.clips[clip].name);
    if (named != clip_names.end()) clip_of_[static_cast<std::size_t>(named - clip_names.begin())] = clip;
    keyframes_.push_back(static_cast<std::uint32_t>(table.clips[clip].times.size()));
    times_.insert(times_.end(), table.clips[clip].times.begin(), table.clips[clip].times.end());
  }
  table_ = {static_cast<std::uint32_t>(keyframes_.size()),
            keyframes_.data(),
            times_.data(),
            table.theta_steps,
            table.phi_steps,
            order_.data(),
            static_cast<std::uint32_t>(table.parts.size()),
            table.sequences.data()};
}

std::span<const std::uint8_t> OrderLookup::cells_in(const Pose& pose) const {
  const std::uint32_t clip = pose.clip && *pose.clip < clip_of_.size() ? clip_of_[*pose.clip] : FOREDRAW_NO_CLIP;
  const std::uint32_t keyframe = foredraw_keyframe_at(&table_, clip, static_cast<float>(pose.time));
  if (keyframe == FOREDRAW_NO_KEYFRAME) return {};
  const std::size_t cells = std::size_t{table_.theta_steps} * table_.phi_steps;
  return order_.subspan(keyframe * cells, cells);
}

std::size_t OrderLookup::cell_of(const glm::dvec3& direction) const {
  const float towards_camera[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                                   static_cast<float>(direction.z)};
  const foredraw_cell_place place = foredraw_place_of(&table_, towards_camera);
  return std::size_t{foredraw_cell_of(place.theta, table_.theta_steps, 0)} * table_.phi_steps +
         foredraw_cell_of(place.phi, table_.phi_steps, 1);
}

glm::dvec3 middle_of_cell(const OrderTable& table, std::uint32_t theta, std::uint32_t phi) {
  const double down = 180 * (theta + 0.5) / table.theta_steps;
  const double round = 360 * (phi + 0.5) / table.phi_steps - 180;
  const double ring = cosine_of_degrees(down - 90);
  return normalised({ring * cosine_of_degrees(round), cosine_of_degrees(down), ring * cosine_of_degrees(round - 90)});
}

std::vector<double> shares_of_orders(const OrderTable& table) {
  std::vector<double> shares(table.order.empty() ? 1 : std::size_t{*std::ranges::max_element(table.order)} + 1, 0.0);
  const double keyframes = static_cast<double>(table.keyframes());
  for (std::size_t cell = 0; cell < table.order.size(); ++cell) {
    const double theta = static_cast<double>(cell / table.phi_steps % table.theta_steps);
    const double belt =
        cosine_of_degrees(180 * theta / table.theta_steps) - cosine_of_degrees(180 * (theta + 1) / table.theta_steps);
    shares[table.order[cell]] += belt / 2 / table.phi_steps / keyframes;
  }
  return shares;
}

std::vector<ServedOrder> served_orders(const Scene& scene, DrawId draw) {
  const std::vector<IndexStream>& orders = scene.draws[draw].full().orders;
  const auto table = std::ranges::find_if(order_tables(scene), [&](const OrderTable& one) {
    return std::ranges::find(one.draws, draw) != one.draws.end();
  });
  if (table == order_tables(scene).end()) return {{&orders[0]}};
  std::vector<ServedOrder> served;
  const std::vector<double> shares = shares_of_orders(*table);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] > 0) served.push_back({&orders.at(i), shares[i]});
  }
  return served;
}

}  // namespace foredraw
