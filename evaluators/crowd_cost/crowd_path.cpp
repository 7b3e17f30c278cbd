#include "crowd_path.h"

#include <cmath>

namespace foredraw {

CrowdPath::CrowdPath(const CrowdPathOptions& options)
    : options_(options),
      random_(options.seed),
      half_side_(options.far * std::sqrt(0.5)),
      walkers_(options.instances),
      distances_(options.instances),
      is_new_(options.instances, 1) {
  turn(eye_, options_.eye_speed);
  for (Walker& walker : walkers_) {
    walker.x = (2 * random_.unit() - 1) * half_side_;
    walker.z = (2 * random_.unit() - 1) * half_side_;
    turn(walker, options_.walk_speed * (0.5 + 0.5 * random_.unit()));
  }
  look();
}

/// Any direction, without the sine of an angle.
void CrowdPath::turn(Walker& walker, double speed) {
  double x = 0, z = 0, squared = 0;
  do {
    x = 2 * random_.unit() - 1;
    z = 2 * random_.unit() - 1;
    squared = x * x + z * z;
  } while (squared > 1 || squared < 0.01);
  walker.dx = x / std::sqrt(squared) * speed;
  walker.dz = z / std::sqrt(squared) * speed;
}

void CrowdPath::step() {
  const double time = 1 / options_.rate;
  if (random_.unit() < time / 10) turn(eye_, options_.eye_speed);
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    Walker& walker = walkers_[i];
    if (random_.unit() < time / 3) turn(walker, options_.walk_speed * (0.5 + 0.5 * random_.unit()));
    is_new_[i] = 0;
    const auto move = [&](double& at, double by) {
      at += by * time;
      if (std::abs(at) <= half_side_) return;
      at -= 2 * half_side_ * std::round(at / (2 * half_side_));  // the fastest cross a small square more than once
      is_new_[i] = 1;
    };
    move(walker.x, walker.dx - eye_.dx);
    move(walker.z, walker.dz - eye_.dz);
  }
  look();
}

void CrowdPath::look() {
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    const Walker& w = walkers_[i];
    distances_[i] = static_cast<float>(std::sqrt(w.x * w.x + w.z * w.z + options_.near * options_.near));
  }
}

}  // namespace foredraw
