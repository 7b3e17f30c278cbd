#include "crowd_levels.h"
#include "crowd_levels_product.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

class CrowdLevelsProcessor final : public Processor {
 public:
  explicit CrowdLevelsProcessor(const CrowdLevelsOptions& options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<Subject> subjects = subjects_of(scene, run.subjects);
    const std::vector<std::vector<DrawId>> crowds = crowds_in(scene, subjects, draws);
    std::vector<std::vector<CrowdLevels::OfDraw>> made(crowds.size());
    std::vector<std::string> why_not(crowds.size());
    run.executor.for_each(crowds.size(), [&](std::size_t i) {
      if (!crowds[i].empty() && !run.cancelled()) made[i] = measured(scene, crowds[i], run, why_not[i]);
    });
    CrowdLevels levels{static_cast<std::uint32_t>(options_.characters), options_.spacing, {}};
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < crowds.size(); ++i) {
      const About about{.subject = static_cast<std::uint32_t>(i)};
      if (!why_not[i].empty()) run.note_at(about, "no-crowd", "no levels for a crowd of it: " + why_not[i]);
      for (CrowdLevels::OfDraw& draw : made[i]) {
        changed.push_back(draw.draw);
        draw.crowd = static_cast<std::uint32_t>(i);
        levels.draws.push_back(std::move(draw));
      }
    }
    if (levels.draws.empty()) {
      run.keep(
          "no draw has a second level; put levels before it, or give the draws a map of heights with displacement");
      return {};
    }
    std::ranges::sort(levels.draws, {}, &CrowdLevels::OfDraw::draw);
    std::ranges::sort(changed);
    scene.products.set(std::move(levels));
    return changed;
  }

 private:
  /// [subject] its draws of triangles that this stage is given. A draw that is in several belongs to the first.
  static std::vector<std::vector<DrawId>> crowds_in(const Scene& scene, const std::vector<Subject>& subjects,
                                                    const std::vector<DrawId>& draws) {
    std::vector<bool> is_free(scene.draws.size(), false);
    for (const DrawId id : draws) is_free[id] = !scene.draws[id].full().stream().indices.empty();
    std::vector<std::vector<DrawId>> crowds(subjects.size());
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      for (const SubjectPart& part : subjects[i].parts) {
        if (is_free[part.draw]) crowds[i].push_back(part.draw);
        is_free[part.draw] = false;
      }
      std::ranges::sort(crowds[i]);
    }
    return crowds;
  }

  std::vector<CrowdLevels::OfDraw> measured(const Scene& scene, const std::vector<DrawId>& draws, Run& run,
                                            std::string& why_not) const {
    std::vector<bool> is_displaced;
    std::string unmoved;
    for (const DrawId id : draws) {
      const std::string why = why_not_displaced(scene, id, run.analyses);
      is_displaced.push_back(why.empty());
      if (!why.empty() && scene.draws[id].traits.has(traits::displaced)) {
        unmoved = fmt::format("{} is not tessellated: {}", scene.draws[id].name, why);
      }
    }
    const std::vector<CrowdLevel> rows = crowd_rows(scene, draws, is_displaced, options_);
    if (rows.size() == 1) {
      why_not = unmoved.empty() ? "it has no level of detail, and no map of heights" : unmoved;
      return {};
    }
    if (rows.size() > CrowdLevels::most_levels) {
      why_not = fmt::format("it has {} levels, more than {}", rows.size(), CrowdLevels::most_levels);
      return {};
    }
    std::vector<CrowdLevels::OfDraw> made;
    for (const DrawId id : draws) {
      made.push_back(crowd_levels(scene, id, rows, options_, run.analyses, run.executor));
    }
    const auto is_finite = [](const CrowdLevel& level) {
      return std::isfinite(level.largest) && std::isfinite(level.rms) && level.triangles < most_triangles;
    };
    const bool is_whole = std::ranges::all_of(made, [&](const CrowdLevels::OfDraw& draw) {
      return std::isfinite(draw.area) && std::ranges::all_of(draw.levels, is_finite);
    });
    if (is_whole) return made;
    why_not = "its size or its error is not finite, or it has too many triangles";
    return {};
  }

  static constexpr std::uint32_t most_triangles = ~std::uint32_t{0};
  CrowdLevelsOptions options_;
};

}  // namespace

Plugin crowd_levels_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "crowd-levels",
      .summary =
          "Makes a table of the levels at which instances of a crowd can be drawn: what each costs, and how far it is "
          "off",
      .reference = "Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::triangles},
      .uses = {traits::displaced},
      .pays_if = "an engine draws it many times at once, and it has levels of detail or a map of heights",
      .lossless = true,
      .measured_by = {"crowd-cost"},
  };
  plugin.products = {crowd_levels_product()};
  OptionTable<CrowdLevelsOptions> table;
  table.row(&CrowdLevelsOptions::characters, "characters",
            "The budget: as many triangles as this many characters take at the finest level", {1, 1'000'000});
  table.row(&CrowdLevelsOptions::most, "most", "Parts of an edge at the finest tessellated level", {1, 64});
  table.choice(&CrowdLevelsOptions::spacing, "spacing", "How the points on an edge are spaced, in the words of shaders",
               {{"equal", FOREDRAW_SPACING_EQUAL},
                {"fractional-odd", FOREDRAW_SPACING_FRACTIONAL_ODD},
                {"fractional-even", FOREDRAW_SPACING_FRACTIONAL_EVEN}});
  table.row(&CrowdLevelsOptions::samples, "samples",
            "Points on each surface from which the distances of simplified levels are measured", {16, 1'000'000});
  bind_options(plugin, table,
               [](const CrowdLevelsOptions& options) { return std::make_unique<CrowdLevelsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
