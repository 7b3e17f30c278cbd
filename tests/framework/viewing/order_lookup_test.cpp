#include <foredraw/viewing/order_lookup.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/view_directions.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include "support/edit_product.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace foredraw::order_lookup_test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Every cell holds a number of its own, so that the answer names the cell.
OrderTable numbered(std::uint32_t theta_steps, std::uint32_t phi_steps) {
  OrderTable table;
  table.theta_steps = theta_steps;
  table.phi_steps = phi_steps;
  table.order.resize(std::size_t{theta_steps} * phi_steps);
  std::iota(table.order.begin(), table.order.end(), std::uint8_t{0});
  return table;
}

std::uint32_t order_at(const OrderLookup& lookup, const glm::dvec3& direction, foredraw_order_state* state = nullptr) {
  const float towards_camera[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                                   static_cast<float>(direction.z)};
  return foredraw_order_at(&lookup.table(), 0, 0, towards_camera, state);
}

glm::dvec3 at_angles(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

TEST(OrderLookup, cells_are_equal_steps_of_the_angles) {
  for (const auto& [theta_steps, phi_steps] : {std::pair(1u, 1u), {2u, 1u}, {1u, 7u}, {9u, 18u}, {12u, 21u}}) {
    const OrderTable table = numbered(theta_steps, phi_steps);
    const OrderLookup lookup(table, {});
    std::size_t compared = 0;
    for (const glm::dvec3& direction : random_directions(20000, 3)) {
      const double theta = std::acos(direction.y) / pi * theta_steps;
      const double phi = (std::atan2(direction.z, direction.x) + pi) / (2 * pi) * phi_steps;
      const auto is_near_border = [](double at) { return std::abs(at - std::round(at)) < 1e-5; };
      if (is_near_border(theta) || is_near_border(phi)) continue;
      const auto cell = static_cast<std::size_t>(theta) * phi_steps + static_cast<std::size_t>(phi);
      ASSERT_EQ(lookup.cell_of(direction), cell);
      ASSERT_EQ(order_at(lookup, 250.0 * direction), table.order[cell]);
      ++compared;
    }
    EXPECT_GT(compared, 19900u);
  }
}

TEST(OrderLookup, angles_are_within_a_millionth) {
  for (int i = -20000; i <= 20000; ++i) {
    const double angle = pi * i / 20000;
    const double found =
        foredraw_angle(static_cast<float>(7 * std::cos(angle)), static_cast<float>(7 * std::sin(angle)));
    const double off = std::abs(found - angle);
    ASSERT_LT(std::min(off, 2 * pi - off), 1e-6) << angle;
  }
}

TEST(OrderLookup, axes_and_what_is_no_direction_have_a_cell) {
  const OrderTable table = numbered(4, 4);
  const OrderLookup lookup(table, {});
  EXPECT_EQ(lookup.cell_of({0, 1, 0}) / 4, 0u);
  EXPECT_EQ(lookup.cell_of({0, -1, 0}) / 4, 3u);
  EXPECT_EQ(lookup.cell_of({1, 0, 0}), 4u * 2 + 2);
  EXPECT_EQ(lookup.cell_of({0, 0, 1}), 4u * 2 + 3);
  EXPECT_EQ(lookup.cell_of({0, 0, -1}), 4u * 2 + 1);
  EXPECT_EQ(lookup.cell_of({-1, 0, 0}), 4u * 2);  // phi is below pi
  EXPECT_EQ(lookup.cell_of({-1, 0, -0.0}), 4u * 2);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const glm::dvec3& odd : {glm::dvec3(0), glm::dvec3(nan, 0, 0), glm::dvec3(0, nan, 1), glm::dvec3(nan),
                                glm::dvec3(infinity, 1, 1), glm::dvec3(-infinity)}) {
    foredraw_order_state state = {1, 2, 3};
    EXPECT_LT(order_at(lookup, odd, &state), 16u);
    EXPECT_LT(state.theta, 4u);
    EXPECT_LT(state.phi, 4u);
  }
  for (const double length : {1e-30, 1e30}) {
    EXPECT_EQ(lookup.cell_of(length * at_angles(2, 1)), lookup.cell_of(at_angles(2, 1)));
  }
}

/// Two clips; a keyframe's cells hold its number.
OrderTable animated() {
  OrderTable table;
  table.clips = {{"Walk", {0, 1, 1.5f}}, {"Wave", {2, 4}}};
  table.theta_steps = 2;
  table.order = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4};
  return table;
}

TEST(OrderLookup, keyframe_is_the_nearest_in_time) {
  const OrderTable table = animated();
  const std::vector<std::string> names = {"Wave", "Idle", "Walk"};
  const OrderLookup lookup(table, names);
  const auto keyframe = [&](AnimationId clip, double time) { return int{lookup.cells_in({clip, time}).front()}; };
  EXPECT_EQ(keyframe(2, -9), 0);
  EXPECT_EQ(keyframe(2, 0.4), 0);
  EXPECT_EQ(keyframe(2, 0.5), 0) << "the earlier of two equally near";
  EXPECT_EQ(keyframe(2, 0.6), 1);
  EXPECT_EQ(keyframe(2, 1.25), 1);
  EXPECT_EQ(keyframe(2, 1.4), 2);
  EXPECT_EQ(keyframe(2, 99), 2);
  EXPECT_EQ(keyframe(0, 0), 3);
  EXPECT_EQ(keyframe(0, 3.1), 4);
  EXPECT_LE(keyframe(0, std::numeric_limits<double>::quiet_NaN()), 4);
  EXPECT_TRUE(lookup.cells_in({1, 0}).empty()) << "the table has no Idle";
  EXPECT_TRUE(lookup.cells_in({}).empty()) << "at rest no clip plays";
  const float up[3] = {0, 1, 0};
  EXPECT_EQ(foredraw_order_at(&lookup.table(), 1, 4, up, nullptr), 4u);
  EXPECT_EQ(foredraw_order_at(&lookup.table(), 2, 4, up, nullptr), 0u);
  EXPECT_EQ(foredraw_order_at(&lookup.table(), FOREDRAW_NO_CLIP, 4, up, nullptr), 0u);
}

TEST(OrderLookup, without_clips_the_pose_does_not_matter) {
  OrderTable table;
  table.order = {7};
  const OrderLookup lookup(table, {});
  EXPECT_EQ(lookup.cells_in({}).front(), 7);
  EXPECT_EQ(lookup.cells_in({3, 2}).front(), 7);
  const float up[3] = {0, 1, 0};
  EXPECT_EQ(foredraw_order_at(&lookup.table(), FOREDRAW_NO_CLIP, 0, up, nullptr), 7u);
}

TEST(OrderLookup, on_a_border_nothing_flickers) {
  const OrderTable table = numbered(6, 12);
  const OrderLookup lookup(table, {});
  const double theta_step = pi / 6;
  // Over the border between thetas 2 and 3, over the one between two phis, over both, and round the pole.
  for (const glm::dvec3& border : {at_angles(3 * theta_step, 0.7), at_angles(2.5 * theta_step, 0),
                                   at_angles(3 * theta_step, 0), glm::dvec3(0, 1, 0)}) {
    foredraw_order_state state = {};
    std::vector<std::uint32_t> changes;
    for (int frame = 0; frame < 200; ++frame) {
      const double shake = 0.01;
      const glm::dvec3 direction =
          border + shake * glm::dvec3(std::sin(frame * 1.3), std::sin(frame * 2.1), std::cos(frame * 1.7));
      const std::uint32_t order = order_at(lookup, direction, &state);
      if (changes.empty() || changes.back() != order) changes.push_back(order);
    }
    EXPECT_EQ(changes.size(), 1u);
  }
}

TEST(OrderLookup, a_walk_passes_every_cell_a_little_late) {
  const OrderTable table = numbered(6, 12);
  const OrderLookup lookup(table, {});
  const double step = pi / 6;  // of both
  foredraw_order_state state = {};
  int late = 0;
  for (int degree = 0; degree < 3600; ++degree) {
    const glm::dvec3 direction = at_angles(2.5 * step, degree / 1800.0 * pi);
    const bool is_there = order_at(lookup, direction, &state) == table.order[lookup.cell_of(direction)];
    const double beyond = std::fmod(degree / 1800.0 * pi, step) / step;
    EXPECT_TRUE(is_there || beyond < 0.13) << degree;
    late += is_there ? 0 : 1;
  }
  EXPECT_GT(late, 12 * 20);
  foredraw_order_state at_pole = {};
  const std::uint32_t before = order_at(lookup, at_angles(0.1, 1), &at_pole);
  EXPECT_EQ(order_at(lookup, at_angles(0.01, 3), &at_pole), before) << "so near the pole phi means little";
  EXPECT_NE(order_at(lookup, at_angles(0.4, 3), &at_pole), before);
}

TEST(OrderLookup, a_state_of_another_table_is_no_harm) {
  const OrderTable table = numbered(2, 2);
  const OrderLookup lookup(table, {});
  foredraw_order_state state = {1, 70, 4};
  EXPECT_EQ(order_at(lookup, at_angles(2, 1), &state), 3u);
}

TEST(OrderLookup, middles_lie_in_their_cells) {
  const OrderTable table = numbered(9, 18);
  const OrderLookup lookup(table, {});
  for (std::uint32_t theta = 0; theta < 9; ++theta) {
    for (std::uint32_t phi = 0; phi < 18; ++phi) {
      const glm::dvec3 middle = middle_of_cell(table, theta, phi);
      EXPECT_EQ(lookup.cell_of(middle), theta * 18 + phi);
      EXPECT_NEAR(glm::distance(middle, at_angles((theta + 0.5) * pi / 9, (phi + 0.5) * pi / 9 - pi)), 0, 1e-10);
    }
  }
}

TEST(OrderLookup, shares_are_of_the_sphere_and_of_the_keyframes) {
  OrderTable caps;
  caps.theta_steps = 6;
  caps.phi_steps = 2;
  caps.order = {1, 1, 0, 0, 0, 2, 0, 0, 0, 0, 1, 1};
  const std::vector<double> shares = shares_of_orders(caps);
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_NEAR(shares[1], 1 - std::cos(pi / 6), 1e-10);
  EXPECT_NEAR(shares[2], std::cos(pi / 3) / 4, 1e-10);
  EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1, 1e-10);
  for (const double share : shares_of_orders(animated())) EXPECT_NEAR(share, 0.2, 1e-10);
}

TEST(OrderLookup, served_orders_are_those_that_the_table_names) {
  Scene scene;
  scene.draws.resize(2);
  for (Draw& draw : scene.draws) draw.levels.resize(1);
  for (Draw& draw : scene.draws) draw.levels[0].orders.resize(3);
  testing::edit<DrawOrders>(scene)->tables.resize(1);
  testing::edit<DrawOrders>(scene)->tables[0].draws = {1};
  testing::edit<DrawOrders>(scene)->tables[0].theta_steps = 2;
  testing::edit<DrawOrders>(scene)->tables[0].order = {2, 0};
  const auto alone = served_orders(scene, 0);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].stream, &scene.draws[0].levels[0].orders[0]);
  EXPECT_EQ(alone[0].share, 1);
  const auto two = served_orders(scene, 1);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].stream, &scene.draws[1].levels[0].orders[0]);
  EXPECT_EQ(two[1].stream, &scene.draws[1].levels[0].orders[2]);
  EXPECT_NEAR(two[0].share, 0.5, 1e-10);
}

}  // namespace
}  // namespace foredraw::order_lookup_test
