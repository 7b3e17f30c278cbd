#include "crowd_levels_product.h"

#include "crowd_levels.h"
#include "schemas.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

bool may_be_displaced(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  return material != nullptr && material->displacement.has_value();
}

/// As the rest of a sentence; empty: the draw takes that much. Whether its map can be read is not asked: without one, a
/// tessellated row takes what the plain one does.
std::string difference(const CrowdLevel& row, const Draw& draw, bool may_be_displaced) {
  const CrowdLevel plain = counted(row, draw, false), moved = counted(row, draw, may_be_displaced);
  const std::string of = fmt::format("{} {}", to_text(row.kind), row.number);
  if (row.triangles != plain.triangles && row.triangles != moved.triangles) {
    return fmt::format("has {} triangles {}, not {}", moved.triangles, of, row.triangles);
  }
  if (row.vertices != plain.vertices)
    return fmt::format("has {} vertices {}, not {}", plain.vertices, of, row.vertices);
  return {};
}

std::string difference(const CrowdLevels& levels, const Scene& scene) {
  std::map<std::uint32_t, std::size_t> scene_levels;  // of each crowd
  for (const CrowdLevels::OfDraw& row : levels.draws) {
    if (row.draw >= scene.draws.size()) return "a draw of it is gone";
    const Draw& draw = scene.draws[row.draw];
    if (draw.topology != Topology::triangles) return draw.name + " draws no triangles";
    std::size_t& most = scene_levels[row.crowd];
    most = std::max(most, draw.levels.size());
    for (const CrowdLevel& level : row.levels) {
      const std::string found = difference(level, draw, may_be_displaced(scene, draw));
      if (!found.empty()) return draw.name + ' ' + found;
    }
  }
  for (const CrowdLevels::OfDraw& row : levels.draws) {
    const auto simplified =
        static_cast<std::size_t>(std::ranges::count(row.levels, CrowdClass::simplified, &CrowdLevel::kind));
    if (simplified + 1 != scene_levels[row.crowd]) {
      return fmt::format("{} is drawn with levels: {}, not {}", scene.draws[row.draw].name, scene_levels[row.crowd],
                         simplified + 1);
    }
  }
  return {};
}

bool is_as_before(const Draw& before, const Draw& after) {
  return before.topology == after.topology && before.material == after.material &&
         std::ranges::equal(before.levels, after.levels, [](const Level& x, const Level& y) {
           return x.error == y.error && x.stream().triangle_count() == y.stream().triangle_count();
         });
}

class CrowdLevelsRow final : public ProductRow {
 public:
  CrowdLevelsRow()
      : ProductRow({.name = std::string(CrowdLevels::product),
                    .title = "levels of a crowd",
                    .extension = "FOREDRAW_crowd_levels",
                    .remedy = "run crowd-levels again",
                    .schemas = schemas(),
                    .side_files = {{".h"}, {".json"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    auto levels = read_crowd_levels(from, scene);
    if (auto* wrong = std::get_if<std::string>(&levels)) return std::move(*wrong);
    scene.products.set(std::get<CrowdLevels>(std::move(levels)));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    write_crowd_levels(*scene.products.find<CrowdLevels>(), to);
  }

  std::string difference(const Scene& scene) const override {
    return foredraw::difference(*scene.products.find<CrowdLevels>(), scene);
  }

  /// Triangles may come into another order, and vertices be counted anew. Of a crowd whose draws were made into others,
  /// nothing stays.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    CrowdLevels levels = *after.products.find<CrowdLevels>();
    std::vector<std::uint32_t> lost;
    std::vector<std::string> told;
    for (CrowdLevels::OfDraw& row : levels.draws) {
      const bool is_known = row.draw < before.draws.size() && row.draw < after.draws.size();
      if (is_known && is_as_before(before.draws[row.draw], after.draws[row.draw]) &&
          may_be_displaced(before, before.draws[row.draw]) == may_be_displaced(after, after.draws[row.draw])) {
        for (CrowdLevel& level : row.levels) level.vertices = counted(level, after.draws[row.draw], false).vertices;
        continue;
      }
      if (std::ranges::find(lost, row.crowd) != lost.end()) continue;
      lost.push_back(row.crowd);
      told.push_back("the levels of a crowd leave " +
                     (row.draw < before.draws.size() ? before.draws[row.draw].name : "a draw") +
                     " out: its triangles were replaced");
    }
    std::erase_if(levels.draws,
                  [&](const CrowdLevels::OfDraw& row) { return std::ranges::find(lost, row.crowd) != lost.end(); });
    if (levels.draws.empty()) {
      leave_out(after);
    } else {
      after.products.set(std::move(levels));
    }
    return told;
  }

  SideFile side_file(const Scene& scene, std::string_view extension, const std::string& beside) const override {
    const CrowdLevels& levels = *scene.products.find<CrowdLevels>();
    if (extension == ".json") return {.content = crowd_levels_value(levels, scene)};
    return {.content = crowd_levels_header(levels, scene, beside.substr(0, beside.rfind('.')))};
  }

  ProductText told(const Scene& scene) const override {
    const CrowdLevels& levels = *scene.products.find<CrowdLevels>();
    ProductText text{.heading = fmt::format("levels of a crowd (budgets of {} characters)", levels.characters),
                     .value = crowd_levels_value(levels, scene)};
    for (const Crowd& crowd : crowds_of(levels)) {
      foredraw_crowd_table table;
      const std::vector<foredraw_crowd_level> rows = runtime_levels(crowd);
      foredraw_crowd_prepare(rows.data(), static_cast<std::uint32_t>(rows.size()), &table);
      const auto of = [&](CrowdClass kind) { return std::ranges::count(crowd.levels, kind, &CrowdLevel::kind); };
      const CrowdLevel &finest = crowd.levels.front(), &coarsest = crowd.levels.back();
      text.lines.push_back(fmt::format(
          "{}: levels {}, of which {} tessellated and {} simplified; {} are worth their triangles; from {} triangles "
          "to "
          "{}, rms distance from {:.3g} to {:.3g}",
          scene.draws[crowd.draws.front()].name, crowd.levels.size(), of(CrowdClass::tessellated),
          of(CrowdClass::simplified), table.steps + 1, finest.triangles, coarsest.triangles, finest.rms, coarsest.rms));
    }
    return text;
  }
};

}  // namespace

std::vector<foredraw_crowd_level> runtime_levels(const Crowd& crowd) {
  std::vector<foredraw_crowd_level> levels;
  for (const CrowdLevel& level : crowd.levels) levels.push_back({level.triangles, level.rms});
  return levels;
}

std::shared_ptr<const ProductRow> crowd_levels_product() { return std::make_shared<const CrowdLevelsRow>(); }

}  // namespace foredraw
