#include "building_plan.h"

#include <foredraw/base/random.h>

#include <algorithm>

namespace foredraw::bench {

BuildingPlan::BuildingPlan(std::uint64_t side, std::uint64_t seed) : side_(side) {
  Random random(derive_seed(seed, 0x706c616e, side));
  for (std::uint64_t k = 0; k < side * side; ++k) {
    left_.push_back(random.unit() < 0.7);
    front_.push_back(random.unit() < 0.7);
  }
  // On, then to either side, and so forth, as far as there are rooms.
  Room at{side / 2, 0};
  walk_.push_back(at);
  for (int step = 1; step <= 6; ++step) {
    Room next = at;
    if (step % 2 == 1) {
      if (++next.j == side) break;
    } else {
      const bool is_left = random.unit() < 0.5;
      next.i = at.i == 0 ? 1 : at.i + 1 == side || is_left ? at.i - 1 : at.i + 1;
    }
    open(at, next);
    walk_.push_back(at = next);
  }
}

void BuildingPlan::open(const Room& from, const Room& to) {
  if (from.i != to.i) left_[from.j * side_ + std::max(from.i, to.i)] = true;
  if (from.j != to.j) front_[std::max(from.j, to.j) * side_ + from.i] = true;
}

}  // namespace foredraw::bench
