#include "camera_views.h"

#include <foredraw/base/random.h>
#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::processors::hidden {

namespace {

constexpr double near_by = 1.3;  // radii from the centre

bool may_be_at(const Cameras& cameras, const glm::dvec3& direction) {
  return cameras.ups.empty() ||
         std::ranges::any_of(cameras.ups, [&](const glm::dvec3& up) { return glm::dot(up, direction) >= 0; });
}

void add(std::vector<View>& views, const Directions& directions, double distance, const Cameras& cameras) {
  constexpr std::size_t leap = 16;  // along the spiral, so that the first ones lie far from each other
  for (std::size_t first = 0; first < leap; ++first) {
    for (std::size_t i = first; i < directions.size(); i += leap) {
      if (may_be_at(cameras, directions[i])) views.push_back({directions[i], distance});
    }
  }
}

}  // namespace

std::vector<View> deciding_views(const Cameras& cameras, const HiddenOptions& options) {
  std::vector<View> views;
  add(views, axis_directions(), 0, cameras);
  add(views, fibonacci_directions(static_cast<std::size_t>(options.views)), 0, cameras);
  const auto near_views = static_cast<std::size_t>((options.views + 3) / 4);
  add(views, turned_at_random(fibonacci_directions(near_views), derive_seed(options.seed, 1, 0)), near_by, cameras);
  return views;
}

std::vector<View> checking_views(const Cameras& cameras, const HiddenOptions& options, int round) {
  const auto count = static_cast<std::size_t>(options.checks);
  std::vector<View> views;
  // Where cameras may not be everywhere, more directions are made, so that as many are left.
  const std::size_t made = cameras.ups.empty() ? count : 2 * count;
  for (const glm::dvec3& direction :
       turned_at_random(fibonacci_directions(made), derive_seed(options.seed, 2, static_cast<std::uint64_t>(round)))) {
    if (!may_be_at(cameras, direction) || views.size() == count) continue;
    views.push_back({direction, views.size() % 3 == 2 ? near_by : 0});
  }
  return views;
}

}  // namespace foredraw::processors::hidden
