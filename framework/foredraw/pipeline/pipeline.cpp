#include <foredraw/pipeline/pipeline.h>

#include <algorithm>

namespace foredraw {

namespace {

bool same_stage(const Stage& a, const Stage& b) {
  return a.use == b.use && a.settings == b.settings && a.only == b.only && a.required == b.required &&
         a.enabled == b.enabled && a.blended == b.blended && a.level == b.level;
}

bool same_stages(const std::vector<Stage>& a, const std::vector<Stage>& b) {
  return std::ranges::equal(a, b, same_stage);
}

}  // namespace

bool same_pipeline(const Pipeline& a, const Pipeline& b) {
  return same_stages(a.stages, b.stages) && same_stages(a.measure, b.measure) && a.modules == b.modules &&
         a.views == b.views && a.frames == b.frames && a.poses == b.poses && a.subjects == b.subjects &&
         a.output == b.output && a.seed == b.seed && a.overdraw.has_value() == b.overdraw.has_value() &&
         (!a.overdraw || same_stage(*a.overdraw, *b.overdraw));
}

}  // namespace foredraw
