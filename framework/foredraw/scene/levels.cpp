#include <foredraw/scene/levels.h>

#include <algorithm>

namespace foredraw {

Traits traits_of(const Draw& draw, std::size_t level) {
  Traits traits = draw.traits;
  traits.add(draw.level(level).made);
  return traits;
}

std::string name_of(const Draw& draw, std::size_t level) {
  return level == 0 ? draw.name : draw.name + " (level " + std::to_string(level) + ")";
}

std::size_t most_levels(const Scene& scene) {
  std::size_t most = 0;
  for (const Draw& draw : scene.draws) most = std::max(most, draw.levels.size());
  return most;
}

Draw at_level(const Draw& draw, std::size_t level) {
  Draw result = draw;
  result.levels = {draw.level(level)};
  return result;
}

Scene at_level(const Scene& scene, std::size_t level) {
  Scene result = scene;
  for (Draw& draw : result.draws) draw = at_level(draw, level);
  if (level > 0) result.products = {};
  return result;
}

void put_level(Draw& draw, std::size_t level, Draw changed) {
  if (draw.levels.size() > 1) {
    draw.levels[level] = std::move(changed.levels.front());
    if (level > 0) return;
    changed.levels = std::move(draw.levels);
  }
  draw = std::move(changed);
}

}  // namespace foredraw
