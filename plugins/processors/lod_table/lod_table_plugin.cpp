#include "lod_pictures.h"
#include "lod_table.h"
#include "lod_table_product.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace foredraw {

namespace {

struct LodTableOptions {
  std::string costs;
  double importance = 1;
};

class LodTableProcessor final : public Processor {
 public:
  explicit LodTableProcessor(const LodTableOptions& options) : importance_(static_cast<float>(options.importance)) {
    if (options.costs.empty()) return;
    auto costs = read_costs(options.costs);
    if (const auto* why = std::get_if<std::string>(&costs)) throw std::invalid_argument(*why);
    costs_ = std::get<RenderingCosts>(std::move(costs));
    costs_.posed = 0;  // a table is of draws; whether joints move one, a node of each place says
    is_example_ = false;
  }

  /// Rows of other draws, which an earlier stage made, stay: so each stage may give its draws an importance.
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<std::optional<LodTable::OfDraw>> made(draws.size());
    std::atomic<std::size_t> done = 0;
    run.executor.for_each(draws.size(), [&](std::size_t i) {
      if (run.cancelled()) return;
      made[i] = row_of(scene, draws[i], run);
      if (run.progress) run.progress(static_cast<double>(++done) / static_cast<double>(draws.size()));
    });
    LodTable table{costs_, {}};
    if (const auto* before = scene.products.find<LodTable>()) table.draws = before->draws;
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      std::erase_if(table.draws, [&](const LodTable::OfDraw& row) { return row.draw == draws[i]; });
      if (made[i]) {
        changed.push_back(draws[i]);
        table.draws.push_back(std::move(*made[i]));
      } else {
        run.note_at({.draw = draws[i]}, "no-row",
                    fmt::format("it has no triangle with a size, or more than {} levels", LodTable::most_levels));
      }
    }
    if (table.draws.empty()) {
      run.keep("no draw has a triangle with a size");
      return {};
    }
    std::ranges::sort(table.draws, {}, &LodTable::OfDraw::draw);
    for (LodTable::OfDraw& row : table.draws) row.hulls = lod_hulls(costs_, row);
    if (is_example_) {
      run.note("example-costs",
               "costs are those of an example, not of a machine, and they decide which ways are worth their cost; "
               "measure yours with `foredraw calibrate -o FILE` and name the file: costs = FILE");
    }
    scene.products.set(std::move(table));
    return changed;
  }

 private:
  std::optional<LodTable::OfDraw> row_of(const Scene& scene, DrawId id, Run& run) const {
    const Draw& draw = scene.draws[id];
    if (draw.levels.size() > LodTable::most_levels) return std::nullopt;
    const LodPictures pictures = lod_pictures(scene, id, run.analyses, run.executor);
    LodTable::OfDraw row;
    row.draw = id;
    row.radius = static_cast<float>(pictures.radius);
    if (!(row.radius > 0) || !std::isfinite(row.radius)) return std::nullopt;
    row.coverage = static_cast<float>(pictures.coverage);
    row.importance = importance_;
    for (std::size_t i = 0; i < row.accuracy.size(); ++i) row.accuracy[i] = static_cast<float>(pictures.accuracy[i]);
    for (const Level& level : draw.levels) row.levels.push_back(lod_level(level));
    return row;
  }

  RenderingCosts costs_ = example_costs();
  bool is_example_ = true;
  float importance_;
};

}  // namespace

Plugin lod_table_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "lod-table",
      .summary =
          "Makes a table of what each draw costs and is worth at each level by each rendering, for choices within a "
          "budget",
      .reference = "Funkhouser and Sequin 1993, sections 3 to 5",
      .acts_on = {traits::triangles},
      .lossless = true,
  };
  plugin.products = {lod_table_product()};
  OptionTable<LodTableOptions> table;
  table
      .number_or_text(&LodTableOptions::costs, "costs",
                      "File of what a machine takes to draw, as `foredraw calibrate` writes it, with a dot or a slash "
                      "in its name (default: an example's costs, of no real machine)",
                      OptionType::views)
      .row(&LodTableOptions::importance, "importance",
           "What the draws are worth relative to others; to give some less, add a stage for them with `only`", {0, 1});
  bind_options(plugin, table,
               [](const LodTableOptions& options) { return std::make_unique<LodTableProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
