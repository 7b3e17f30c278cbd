// The table beside the scene: as C, and as JSON.
#include "crowd_levels_product.h"

#include <foredraw/base/c_literal.h>
#include <foredraw/base/c_names.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

constexpr std::string_view head =
    R"(/* Levels at which the instances of a crowd can be drawn, of {scene}. Made by foredraw.
 * Tessellated ones have {spacing} spacing. How to use it: foredraw/runtime/crowd_select.h. */
#ifndef FOREDRAW_CROWD_LEVELS_{capitals}_H
#define FOREDRAW_CROWD_LEVELS_{capitals}_H

#include <foredraw/runtime/crowd_select.h>

#if defined(__GNUC__)
#define FOREDRAW_CROWD_LEVELS_{capitals}_DATA __attribute__((unused)) static const
#else
#define FOREDRAW_CROWD_LEVELS_{capitals}_DATA static const
#endif
#define {capitals}_CROWD_COUNT {count}

/* triangles, root mean square distance */
FOREDRAW_CROWD_LEVELS_{capitals}_DATA foredraw_crowd_level {stem}_crowd_levels[{level_count}] = {{
{levels}}};

/* class, number, vertices, largest distance */
FOREDRAW_CROWD_LEVELS_{capitals}_DATA foredraw_crowd_mesh {stem}_crowd_meshes[{level_count}] = {{
{meshes}}};

/* name, levels, meshes, how many, budget */
FOREDRAW_CROWD_LEVELS_{capitals}_DATA foredraw_crowd_character {stem}_crowd[{count}] = {{
{characters}}};

#endif
)";

std::string float_text(float value) { return c_float(fmt::format("{}", value)); }

}  // namespace

std::string crowd_levels_header(const CrowdLevels& levels, const Scene& scene, const std::string& stem) {
  const std::string name = c_identifier(stem);
  const std::vector<Crowd> crowds = crowds_of(levels);
  std::string rows, meshes, characters;
  std::size_t count = 0;
  for (const Crowd& crowd : crowds) {
    characters += fmt::format("  {{{}, {}_crowd_levels + {}, {}_crowd_meshes + {}, {}, UINT64_C({})}},\n",
                              c_string(scene.draws[crowd.draws.front()].name), name, count, name, count,
                              crowd.levels.size(), crowd.budget);
    for (const CrowdLevel& level : crowd.levels) {
      rows += fmt::format("  {{{}u, {}}},\n", level.triangles, float_text(level.rms));
      meshes += fmt::format("  {{FOREDRAW_CROWD_{}, {}u, {}u, {}}},\n", in_capitals(std::string(to_text(level.kind))),
                            level.number, level.vertices, float_text(level.largest));
    }
    count += crowd.levels.size();
  }
  return fmt::format(fmt::runtime(head), fmt::arg("scene", in_comment(scene.name)),
                     fmt::arg("spacing", to_text(levels.spacing)), fmt::arg("capitals", in_capitals(name)),
                     fmt::arg("count", crowds.size()), fmt::arg("stem", name), fmt::arg("level_count", count),
                     fmt::arg("levels", rows), fmt::arg("meshes", meshes), fmt::arg("characters", characters));
}

ExtensionValue crowd_levels_value(const CrowdLevels& levels, const Scene& scene) {
  const auto crowds = listed(crowds_of(levels), [&](const Crowd& crowd) {
    const std::vector<foredraw_crowd_level> rows = runtime_levels(crowd);
    foredraw_crowd_table table;
    foredraw_crowd_prepare(rows.data(), static_cast<std::uint32_t>(rows.size()), &table);
    List of_levels;
    for (std::size_t l = 0; l < crowd.levels.size(); ++l) {
      const CrowdLevel& level = crowd.levels[l];
      const std::uint32_t steps = table.steps_to[l];
      const bool is_on_hull = steps != FOREDRAW_CROWD_NEW;
      Members value{{"class", std::string(to_text(level.kind))},
                    {"number", level.number},
                    {"triangles", level.triangles},
                    {"vertices", level.vertices},
                    {"largest", level.largest},
                    {"rms", level.rms},
                    {"on-hull", is_on_hull}};
      if (is_on_hull && steps > 0) {
        value.emplace_back("reach", std::sqrt(table.gain[steps - 1] / table.gain[table.steps - 1]));
      }
      of_levels.push_back(std::move(value));
    }
    return Members{{"name", scene.draws[crowd.draws.front()].name},
                   {"draws", listed(crowd.draws, [&](DrawId draw) { return scene.draws[draw].name; })},
                   {"budget", crowd.budget},
                   {"levels", std::move(of_levels)}};
  });
  return Members{{"crowd-levels", 1},
                 {"file", scene.name},
                 {"characters", levels.characters},
                 {"spacing", std::string(to_text(levels.spacing))},
                 {"crowds", crowds}};
}

}  // namespace foredraw
