#include "lod_table.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>

namespace foredraw {

LodTable::OfLevel lod_level(const Level& level) {
  constexpr std::uint32_t cache = 16;
  const CacheCount count = count_fifo(level.stream().indices.view(), level.vertices->count, cache);
  return {.triangles = static_cast<std::uint32_t>(count.triangles),
          .shaded = static_cast<std::uint32_t>(count.misses),
          .vertices = level.vertices->count,
          .error = level.error};
}

foredraw_lod_machine lod_machine(const RenderingCosts& costs) {
  foredraw_lod_machine machine = {};
  for (std::size_t i = 0; i < costs.renderings.size(); ++i) {
    const RenderingCost& of = costs.renderings[i];
    machine.renderings[i] = {static_cast<float>(of.triangle), static_cast<float>(of.vertex),
                             static_cast<float>(of.pixel)};
  }
  machine.frame = static_cast<float>(costs.frame);
  machine.draw = static_cast<float>(costs.draw);
  machine.is_sum = costs.stages == Stages::sum ? 1 : 0;
  return machine;
}

LodTable::Hulls lod_hulls(const RenderingCosts& costs, const LodTable::OfDraw& draw) {
  std::vector<foredraw_lod_table_level> levels;
  for (const LodTable::OfLevel& level : draw.levels) {
    levels.push_back({level.triangles, level.shaded, level.vertices, level.error});
  }
  foredraw_lod_table_draw row = {};
  row.level = levels.data();
  row.levels = static_cast<std::uint32_t>(levels.size());
  row.radius = draw.radius;
  row.coverage = draw.coverage;
  row.importance = draw.importance;
  std::ranges::copy(draw.accuracy, row.accuracy);
  const foredraw_lod_machine machine = lod_machine(costs);
  std::vector<foredraw_lod_way> ways(LodTable::renderings * levels.size());
  foredraw_lod_table_fill(&machine, &row, ways.data());
  LodTable::Hulls hulls;
  for (std::size_t octave = 0; octave < hulls.size(); ++octave) {
    std::ranges::copy(row.hulls[octave], hulls[octave].begin());
  }
  return hulls;
}

}  // namespace foredraw
