#include "crowd_levels.h"

#include "displaced_deviation.h"

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/base/random.h>
#include <foredraw/displaced/scene_displacement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

float no_less_than(double distance) {
  const auto nearest = static_cast<float>(distance);
  return static_cast<double>(nearest) < distance ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                                 : nearest;
}

/// [0] of the plain draw, and of each tessellated row; all are 0 where nothing moves it.
std::vector<Deviation> deviations(const Scene& scene, DrawId id, std::span<const CrowdLevel> rows,
                                  const CrowdLevelsOptions& options, Analyses& analyses, const Executor& executor) {
  std::vector<std::uint32_t> parts;
  for (const CrowdLevel& row : rows) {
    if (row.kind == CrowdClass::tessellated) parts.push_back(row.number);
  }
  const auto map = laid_out_map(scene, id, analyses);
  const auto* laid_out = std::get_if<LaidOutMap>(&map);
  if (laid_out == nullptr) return std::vector<Deviation>(1 + parts.size());
  const Level& full = scene.draws[id].full();
  const auto positions = positions_of(analyses, *full.vertices);
  const std::vector<glm::vec3> directions = displacement_directions(scene, id, analyses);
  const MovedSurface surface{full.stream().indices.view(),
                             positions->values,
                             directions,
                             laid_out->places,
                             laid_out->sampled(),
                             laid_out->displacement.factor,
                             laid_out->displacement.offset};
  const auto finest = static_cast<std::uint32_t>(std::min(2 * options.most, 64));
  return displaced_deviations(surface, parts, finest, executor);
}

/// Of a level from full detail.
double rms_of(const Level& full, const Level& level, std::uint64_t seed, const CrowdLevelsOptions& options,
              Analyses& analyses, const Executor& executor) {
  const auto of_full = positions_of(analyses, *full.vertices), of_level = positions_of(analyses, *level.vertices);
  const Surface a{of_full->values, full.stream().indices.view()}, b{of_level->values, level.stream().indices.view()};
  const auto found = surface_distance(a, b, {static_cast<std::size_t>(options.samples), seed}, executor);
  return found && std::isfinite(found->rms) ? found->rms : static_cast<double>(level.error);
}

}  // namespace

std::vector<CrowdLevel> crowd_rows(const Scene& scene, std::span<const DrawId> draws,
                                   const std::vector<bool>& is_displaced, const CrowdLevelsOptions& options) {
  std::vector<CrowdLevel> rows;
  if (std::ranges::find(is_displaced, true) != is_displaced.end()) {
    const std::uint32_t step = options.spacing == FOREDRAW_SPACING_EQUAL ? 1 : 2;
    const std::uint32_t least = foredraw_tessellation_parts(0, options.spacing);
    for (std::uint32_t parts = foredraw_tessellation_floor(static_cast<float>(options.most), options.spacing);
         parts >= least; parts -= step) {
      rows.push_back({.kind = CrowdClass::tessellated, .number = parts});
      if (parts < least + step) break;
    }
  }
  rows.push_back({.kind = CrowdClass::plain});
  std::size_t levels = 1;
  for (const DrawId draw : draws) levels = std::max(levels, scene.draws[draw].levels.size());
  for (std::uint32_t level = 1; level < levels; ++level) {
    rows.push_back({.kind = CrowdClass::simplified, .number = level});
  }
  return rows;
}

CrowdLevel counted(const CrowdLevel& row, const Draw& draw, bool is_displaced) {
  const Level& level = draw.level(row.kind == CrowdClass::simplified ? row.number : 0);
  const std::uint64_t of_each =
      row.kind == CrowdClass::tessellated && is_displaced ? foredraw_tessellation_triangles(row.number) : 1;
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  CrowdLevel made = row;
  made.triangles = static_cast<std::uint32_t>(std::min(of_each * level.stream().triangle_count(), most));
  made.vertices = level.vertices->count;
  return made;
}

std::string why_not_displaced(const Scene& scene, DrawId draw, Analyses& analyses) {
  const auto map = laid_out_map(scene, draw, analyses);
  const std::string* why = std::get_if<std::string>(&map);
  return why == nullptr ? std::string() : *why;
}

CrowdLevels::OfDraw crowd_levels(const Scene& scene, DrawId id, std::span<const CrowdLevel> rows,
                                 const CrowdLevelsOptions& options, Analyses& analyses, const Executor& executor) {
  const Draw& draw = scene.draws[id];
  const bool is_displaced = why_not_displaced(scene, id, analyses).empty();
  const std::vector<Deviation> off = deviations(scene, id, rows, options, analyses, executor);
  const auto positions = positions_of(analyses, *draw.full().vertices);
  CrowdLevels::OfDraw made;
  made.draw = id;
  made.area = static_cast<float>(area_of(positions->values, draw.full().stream().indices.view()));
  std::size_t tessellated = 0;
  for (const CrowdLevel& row : rows) {
    CrowdLevel& level = made.levels.emplace_back(counted(row, draw, is_displaced));
    Deviation of = row.kind == CrowdClass::tessellated ? off[++tessellated] : off[0];
    if (row.kind == CrowdClass::simplified && draw.levels.size() > 1) {
      const Level& drawn = draw.level(row.number);
      of.largest += static_cast<double>(drawn.error);
      of.rms += rms_of(draw.full(), drawn, derive_seed(0, row.number, id), options, analyses, executor);
    }
    level.rms = static_cast<float>(of.rms);
    level.largest = std::max(no_less_than(of.largest), level.rms);
  }
  return made;
}

}  // namespace foredraw
