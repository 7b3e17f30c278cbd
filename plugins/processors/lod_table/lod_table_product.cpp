#include "lod_table_product.h"

#include "lod_table.h"
#include "schemas.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

/// Compression may turn the corners of triangles, which moves a few vertices into the cache or out of it.
bool is_nearly(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t most = std::max(a, b), least = std::min(a, b);
  return 8 * (most - least) <= most + 64;
}

/// As the rest of a sentence; empty: it is the level that the scene has.
std::string difference(const LodTable::OfLevel& row, const Level& level) {
  const LodTable::OfLevel now = lod_level(level);
  if (row.triangles != now.triangles) return fmt::format("has {} triangles, not {}", now.triangles, row.triangles);
  if (row.vertices != now.vertices) return fmt::format("has {} vertices, not {}", now.vertices, row.vertices);
  if (!is_nearly(row.shaded, now.shaded)) return fmt::format("shades {} vertices, not {}", now.shaded, row.shaded);
  // Nodes of MSFT_lod have no place for errors.
  if (now.error != 0 && row.error != now.error) return fmt::format("has an error of {}, not {}", now.error, row.error);
  return {};
}

std::string difference(const RenderingCosts& costs, const LodTable::OfDraw& row, const Scene& scene) {
  if (row.draw >= scene.draws.size()) return "a draw of it is gone";
  const Draw& draw = scene.draws[row.draw];
  if (draw.topology != Topology::triangles) return draw.name + " draws no triangles";
  if (draw.levels.size() != row.levels.size()) {
    return fmt::format("{} has levels: {}, not {}", draw.name, draw.levels.size(), row.levels.size());
  }
  for (std::size_t l = 0; l < row.levels.size(); ++l) {
    const std::string found = difference(row.levels[l], draw.levels[l]);
    if (!found.empty()) return fmt::format("level {} of {} {}", l, draw.name, found);
  }
  return row.hulls == lod_hulls(costs, row) ? std::string() : draw.name + " has other ways on its hulls";
}

/// Counts anew what orders and vertices decide. False where the levels are not those of the row any more.
bool bring_up(LodTable::OfDraw& row, const RenderingCosts& costs, const Scene& scene) {
  if (row.draw >= scene.draws.size() || scene.draws[row.draw].levels.size() != row.levels.size()) return false;
  for (std::size_t l = 0; l < row.levels.size(); ++l) {
    const LodTable::OfLevel was = row.levels[l];
    row.levels[l] = lod_level(scene.draws[row.draw].levels[l]);
    if (row.levels[l].triangles != was.triangles || row.levels[l].error != was.error) return false;
  }
  row.hulls = lod_hulls(costs, row);
  return true;
}

bool has_same_levels(const Draw& a, const Draw& b) {
  return std::ranges::equal(a.levels, b.levels, [](const Level& x, const Level& y) {
    return x.vertices == y.vertices && x.error == y.error && x.stream().indices.is(y.stream().indices);
  });
}

/// How many ways lie on the hull: at the fewest and at the most over all sizes.
std::pair<int, int> hull_sizes(const LodTable::Hulls& hulls) {
  int least = 1000, most = 0;
  for (const auto& masks : hulls) {
    int count = 0;
    for (const std::uint32_t mask : masks) count += std::popcount(mask);
    least = std::min(least, count), most = std::max(most, count);
  }
  return {least, most};
}

class LodTableRow final : public ProductRow {
 public:
  LodTableRow()
      : ProductRow({.name = std::string(LodTable::product),
                    .title = "table of levels and renderings",
                    .extension = "FOREDRAW_lod_table",
                    .remedy = "run lod-table again",
                    .schemas = schemas(),
                    .side_files = {{".h"}, {".json"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    auto table = read_lod_table(from, scene);
    if (auto* wrong = std::get_if<std::string>(&table)) return std::move(*wrong);
    scene.products.set(std::get<LodTable>(std::move(table)));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    write_lod_table(*scene.products.find<LodTable>(), to);
  }

  std::string difference(const Scene& scene) const override {
    const LodTable& table = *scene.products.find<LodTable>();
    for (const LodTable::OfDraw& row : table.draws) {
      if (std::string found = foredraw::difference(table.costs, row, scene); !found.empty()) return found;
    }
    return {};
  }

  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    LodTable table = *after.products.find<LodTable>();
    std::vector<std::string> told;
    std::erase_if(table.draws, [&](LodTable::OfDraw& row) {
      const bool is_known = row.draw < before.draws.size() && row.draw < after.draws.size();
      if (is_known && has_same_levels(before.draws[row.draw], after.draws[row.draw])) return false;
      if (bring_up(row, table.costs, after)) return false;
      told.push_back("the table of levels and renderings leaves " +
                     (row.draw < before.draws.size() ? before.draws[row.draw].name : "a draw") +
                     " out: its levels were replaced");
      return true;
    });
    if (table.draws.empty()) {
      leave_out(after);
    } else {
      after.products.set(std::move(table));
    }
    return told;
  }

  SideFile side_file(const Scene& scene, std::string_view extension, const std::string& beside) const override {
    const LodTable& table = *scene.products.find<LodTable>();
    if (extension == ".json") return {.content = lod_table_value(table, scene)};
    return {.content = lod_table_header(table, scene, beside.substr(0, beside.rfind('.')))};
  }

  ProductText told(const Scene& scene) const override {
    const LodTable& table = *scene.products.find<LodTable>();
    const std::string machine = table.costs.machine.empty() ? "a machine without a name" : table.costs.machine;
    ProductText text{.heading = "table of levels and renderings (costs of " + machine + ")",
                     .value = Members{{"machine", table.costs.machine}}};
    ExtensionValue::List draws;
    for (const LodTable::OfDraw& row : table.draws) {
      const auto [least, most] = hull_sizes(row.hulls);
      const std::string& name = scene.draws[row.draw].name;
      text.lines.push_back(fmt::format(
          "{}: levels {}, ways {}, of which {} to {} are worth their cost; accuracy without normal map {:.3f}, unlit "
          "{:.3f}",
          name, row.levels.size(), LodTable::renderings * row.levels.size(), least, most, row.accuracy[1],
          row.accuracy[2]));
      draws.push_back(Members{{"draw", name},
                              {"levels", row.levels.size()},
                              {"ways", LodTable::renderings * row.levels.size()},
                              {"leastOnHull", least},
                              {"mostOnHull", most},
                              {"accuracy", ExtensionValue::List(row.accuracy.begin(), row.accuracy.end())}});
    }
    text.value.put("draws", std::move(draws));
    return text;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> lod_table_product() { return std::make_shared<const LodTableRow>(); }

}  // namespace foredraw
