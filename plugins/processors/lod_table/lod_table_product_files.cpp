// The table beside the scene: as C, and as JSON.
#include "lod_table.h"
#include "lod_table_product.h"

#include <foredraw/base/c_literal.h>
#include <foredraw/base/c_names.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

std::string float_text(float value) { return c_float(fmt::format("{}", value)); }

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

template <class Range>
std::string braced(const Range& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + value;
  return '{' + text + '}';
}

std::string machine_text(const foredraw_lod_machine& machine) {
  std::vector<std::string> renderings;
  for (const foredraw_lod_rendering& of : machine.renderings) {
    renderings.push_back(
        fmt::format("{{{}, {}, {}}}", float_text(of.triangle), float_text(of.vertex), float_text(of.pixel)));
  }
  return fmt::format("{{{}, {}, {}, {}}}", braced(renderings), float_text(machine.frame), float_text(machine.draw),
                     machine.is_sum);
}

std::string draw_text(const LodTable::OfDraw& draw, const std::string& name, const std::string& levels,
                      std::size_t first) {
  std::vector<std::string> accuracy, hulls;
  for (const float of : draw.accuracy) accuracy.push_back(float_text(of));
  for (const auto& masks : draw.hulls) {
    std::vector<std::string> words;
    for (const std::uint32_t mask : masks) words.push_back(fmt::format("{}u", mask));
    hulls.push_back(braced(words));
  }
  return fmt::format("  {{{}, {} + {}, {}, {}, {}, {}, {},\n   {}}},\n", c_string(name), levels, first,
                     draw.levels.size(), float_text(draw.radius), float_text(draw.coverage),
                     float_text(draw.importance), braced(accuracy), braced(hulls));
}

constexpr std::string_view head =
    R"(/* What the ways to draw each draw of {scene} cost and are worth. Made by foredraw.
 * Machine: {machine}. How to use it: foredraw/runtime/lod_table.h. */
#ifndef FOREDRAW_LOD_TABLE_{capitals}_H
#define FOREDRAW_LOD_TABLE_{capitals}_H

#include <foredraw/runtime/lod_table.h>

#if defined(__GNUC__)
#define FOREDRAW_LOD_TABLE_{capitals}_DATA __attribute__((unused)) static const
#else
#define FOREDRAW_LOD_TABLE_{capitals}_DATA static const
#endif
#define {capitals}_LOD_DRAW_COUNT {count}

FOREDRAW_LOD_TABLE_{capitals}_DATA foredraw_lod_machine {stem}_lod_machine =
  {values};

/* triangles, vertices that a cache of 16 lets through, stored vertices, error */
FOREDRAW_LOD_TABLE_{capitals}_DATA foredraw_lod_table_level {stem}_lod_levels[{level_count}] = {{
{levels}}};

/* name, levels, radius, coverage, importance, accuracies; hulls */
FOREDRAW_LOD_TABLE_{capitals}_DATA foredraw_lod_table_draw {stem}_lod_draws[{count}] = {{
{draws}}};

#endif
)";

}  // namespace

std::string lod_table_header(const LodTable& table, const Scene& scene, const std::string& stem) {
  const std::string name = c_identifier(stem);
  std::string levels, draws;
  std::size_t level_count = 0;
  for (const LodTable::OfDraw& draw : table.draws) {
    draws += draw_text(draw, scene.draws[draw.draw].name, name + "_lod_levels", level_count);
    for (const LodTable::OfLevel& level : draw.levels) {
      levels += fmt::format("  {{{}u, {}u, {}u, {}}},\n", level.triangles, level.shaded, level.vertices,
                            float_text(level.error));
    }
    level_count += draw.levels.size();
  }
  const std::string machine = table.costs.machine.empty() ? "not named" : in_comment(table.costs.machine);
  return fmt::format(fmt::runtime(head), fmt::arg("scene", in_comment(scene.name)), fmt::arg("machine", machine),
                     fmt::arg("capitals", in_capitals(name)), fmt::arg("count", table.draws.size()),
                     fmt::arg("stem", name), fmt::arg("values", machine_text(lod_machine(table.costs))),
                     fmt::arg("level_count", level_count), fmt::arg("levels", levels), fmt::arg("draws", draws));
}

ExtensionValue lod_table_value(const LodTable& table, const Scene& scene) {
  const RenderingCosts& costs = table.costs;
  Members renderings;
  for (const Rendering rendering : all_renderings) {
    const RenderingCost& of = costs.of(rendering);
    renderings.emplace_back(std::string(to_text(rendering)),
                            Members{{"triangle", of.triangle}, {"vertex", of.vertex}, {"pixel", of.pixel}});
  }
  const auto draws = listed(table.draws, [&](const LodTable::OfDraw& draw) {
    List ways;
    for (std::size_t l = 0; l < draw.levels.size(); ++l) {
      const LodTable::OfLevel& level = draw.levels[l];
      const foredraw_lod_table_level row = {level.triangles, level.shaded, level.vertices, level.error};
      for (std::size_t r = 0; r < LodTable::renderings; ++r) {
        List hulls;
        for (const auto& masks : draw.hulls) hulls.push_back((masks[r] >> l & 1u) != 0);
        ways.push_back(Members{{"level", l},
                               {"rendering", std::string(to_text(all_renderings[r]))},
                               {"triangles", level.triangles},
                               {"shaded", level.shaded},
                               {"vertices", level.vertices},
                               {"samples", foredraw_lod_table_samples(&row, static_cast<std::uint32_t>(r))},
                               {"error", level.error},
                               {"accuracy", draw.accuracy[r]},
                               {"on-hull", std::move(hulls)}});
      }
    }
    return Members{{"name", scene.draws[draw.draw].name},
                   {"radius", draw.radius},
                   {"coverage", draw.coverage},
                   {"importance", draw.importance},
                   {"ways", std::move(ways)}};
  });
  return Members{{"lod-table", 1},
                 {"file", scene.name},
                 {"machine", costs.machine},
                 {"stages", std::string(to_text(costs.stages))},
                 {"frame", costs.frame},
                 {"draw", costs.draw},
                 {"renderings", std::move(renderings)},
                 {"least-pixels-across", FOREDRAW_LOD_LEAST_ACROSS},
                 {"draws", draws}};
}

}  // namespace foredraw
