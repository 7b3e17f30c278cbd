#include <foredraw/frames/sliding_views.h>

#include <foredraw/base/random.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

SlidingViews sliding_views(const FrameScene& scene, const FrameMoment& moment, FrameSize size, double across, int views,
                           int frames, double step, std::uint64_t seed) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const auto& [sphere, half_box] : moment.bounds) {
    const glm::dvec3 reach = glm::abs(half_box[0]) + glm::abs(half_box[1]) + glm::abs(half_box[2]);
    low = glm::min(low, sphere.centre - reach);
    high = glm::max(high, sphere.centre + reach);
  }
  SlidingViews all;
  if (scene.objects().empty() || !(low.x <= high.x)) return all;
  const glm::dvec3 centre = (low + high) / 2.0;
  const double radius = std::max(glm::length(high - low) / 2, 1e-12);
  Random random(seed);
  const auto direction = [&](double least_y, double most_y) {
    while (true) {
      const glm::dvec3 d(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
      const double length = glm::length(d);
      if (length <= 1 && length > 0.01 && d.y >= least_y * length && d.y <= most_y * length) return d / length;
    }
  };
  for (int view = 0; view < views; ++view) {
    // From eye level to well above it, as scenes are looked at.
    const glm::dvec3 from = direction(-0.1, 0.7), way = direction(-1, 1);
    FrameCamera camera;
    const double distance = radius * size.height / (2 * camera.half_height * across / 2);
    camera = looking_at(centre + from * std::max(distance, 1.05 * radius), centre);
    camera.near = distance * 1e-3;
    const double unit = step / camera.pixels_a_unit(distance, size);
    const double along = glm::dot(way, camera.right), up = glm::dot(way, camera.up);
    const double length = std::max(std::hypot(along, up), 1e-3);
    const glm::dvec3 slide = (camera.right * along + camera.up * up) * (unit / length);
    std::vector<FrameCamera>& burst = all.emplace_back();
    for (int frame = 0; frame < frames; ++frame) {
      burst.push_back(camera);
      burst.back().eye += slide * static_cast<double>(frame);
    }
  }
  return all;
}

}  // namespace foredraw
