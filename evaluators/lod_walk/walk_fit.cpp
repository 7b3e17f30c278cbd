#include "walk_fit.h"

namespace foredraw::evaluators::lod_walk {

void SummedWork::add(const ObjectWork& work) {
  const RenderingCost& cost = costs_.of(work.rendering);
  const bool is_shading = cost.pixel * work.pixels >
                          cost.triangle * work.triangles + cost.vertex * work.vertices + costs_.posed * work.posed;
  ObjectWork& sum = sums_[static_cast<std::size_t>(work.rendering)][is_shading ? 1 : 0];
  sum.rendering = work.rendering;
  sum.triangles += work.triangles;
  sum.vertices += work.vertices;
  sum.pixels += work.pixels;
  sum.draws += work.draws;
  sum.posed += work.posed;
}

std::vector<ObjectWork> SummedWork::drawn() const {
  std::vector<ObjectWork> drawn;
  for (const auto& by_stage : sums_) {
    for (ObjectWork sum : by_stage) {
      sum.draws -= 1;  // an ObjectWork begins with one
      if (sum.draws > 0) drawn.push_back(sum);
    }
  }
  return drawn;
}

WalkFit walk_fit(const std::vector<FrameSample>& samples) {
  std::vector<FrameSample> fitted, foretold;
  for (std::size_t i = 0; i < samples.size(); ++i) (i % 2 == 0 ? fitted : foretold).push_back(samples[i]);
  return {fit_error(fit_costs(fitted, Stages::max), foretold), fit_error(fit_costs(fitted, Stages::sum), foretold)};
}

}  // namespace foredraw::evaluators::lod_walk
