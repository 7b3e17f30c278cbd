#include "levels.h"

#include <foredraw/collapses/collapse_limits.h>
#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/measuring/level_processor.h>
#include <foredraw/scene/levels.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace foredraw {

namespace {

struct LevelsOptions {
  std::vector<double> ratios = {0.5, 0.25, 0.1};
  std::vector<double> errors;
  std::vector<double> distances;
  double pixels = 1;
  double saving = 0.2;
  bool keep_sequences = false;
};

LevelGoals goals_of(const LevelsOptions& options) {
  if (!options.errors.empty() && !options.distances.empty()) {
    throw std::invalid_argument("give 'errors' or 'distances', not both");
  }
  for (std::size_t i = 0; i < options.distances.size(); ++i) {
    const double before = i == 0 ? 0 : options.distances[i - 1];
    if (!std::isfinite(options.distances[i]) || !(options.distances[i] > before)) {
      throw std::invalid_argument("'distances' must be above 0 and rise, from the finest level to the coarsest");
    }
  }
  LevelGoals goals{{}, options.errors};
  for (const double away : options.distances) goals.errors.push_back(distance_of_pixels(options.pixels, away));
  if (goals.errors.empty()) goals.ratios = options.ratios;
  check(goals);
  return goals;
}

/// A mesh of the subject, and where its levels are cut.
struct CutMesh {
  DrawsCollapse of;
  JoinedMesh mesh;
  std::vector<std::uint32_t> triangles;  ///< [collapses] that are left
  std::vector<LevelCut> cuts;            ///< [goal]
  bool leaves_vertices = false;
};

class LevelsMaker final : public LevelMaker {
 public:
  LevelsMaker(LevelGoals goals, double saving) : goals_(std::move(goals)), saving_(saving) {}

  SubjectLevels levels(const SubjectView& view, Run& run) const override {
    std::vector<CutMesh> meshes;
    std::size_t still = 0, before = 0;  // triangles of draws without a sequence, and of the level before
    std::vector<DrawId> draws = view.draws;
    std::ranges::sort(draws);
    for (const DrawId id : draws) before += view.scene.draws[id].full().stream().triangle_count();
    still = before;
    for (const DrawsCollapse& mesh : sequences_of(view.scene, draws)) {
      meshes.push_back(cut_mesh(mesh, view.scene, run));
      still -= meshes.back().mesh.indices.size() / 3;
    }
    SubjectLevels made(view.draws.size());
    if (meshes.empty()) return made;
    std::vector<std::string> left_out;
    const std::vector<double>& goals = goals_.errors.empty() ? goals_.ratios : goals_.errors;
    for (std::size_t goal = 0; goal < goals.size() && !run.cancelled(); ++goal) {
      std::size_t left = still;
      for (const CutMesh& mesh : meshes) left += mesh.triangles[mesh.cuts[goal].collapses];
      if (static_cast<double>(left) > (1 - saving_) * static_cast<double>(before)) {
        left_out.push_back(fmt::format("{}", goals[goal]));
        continue;
      }
      before = left;
      add_level(meshes, goal, view, made);
    }
    if (!left_out.empty()) {
      run.note("level-left-out",
               fmt::format("{} {} {} left out: less than {:.3g} % of the triangles of the level before would be saved",
                           left_out.size() == 1 ? "the level of" : "the levels of", fmt::join(left_out, ", "),
                           left_out.size() == 1 ? "is" : "are", 100 * saving_));
    }
    return made;
  }

 private:
  CutMesh cut_mesh(const DrawsCollapse& of, const Scene& scene, Run& run) const {
    auto joined = joined_mesh(scene, of.draws, run.analyses);
    if (!joined) throw std::runtime_error("a stage removed a draw of a sequence of collapses");
    CutMesh cut{of, std::move(*joined), {}, {}, false};
    Replay all = replay(*of.sequence, cut.mesh.positions, cut.mesh.indices, cut.mesh.part);
    if (!all.mistake.empty()) throw std::runtime_error(all.mistake);
    cut.cuts = level_cuts(cut.mesh, *of.sequence, all, goals_, run.executor, run.cancel);
    cut.triangles = std::move(all.triangles);
    cut.leaves_vertices = leaves_vertices(*of.sequence, cut.mesh);
    return cut;
  }

  /// Draws that have no sequence stay what they are.
  static void add_level(const std::vector<CutMesh>& meshes, std::size_t goal, const SubjectView& view,
                        SubjectLevels& made) {
    for (std::size_t d = 0; d < view.draws.size(); ++d) {
      const Level& full = view.scene.draws[view.draws[d]].full();
      made[d].push_back({full.vertices, full.stream().indices});
    }
    for (const CutMesh& mesh : meshes) {
      const LevelCut& at = mesh.cuts[goal];
      const Collapsed after = collapsed(*mesh.of.sequence, at.collapses, mesh.mesh);
      const std::vector<CutDraw> draws = mesh.leaves_vertices ? cut_of_same_vertices(after, mesh.mesh)
                                                              : cut(*mesh.of.sequence, at.collapses, after, mesh.mesh);
      for (std::size_t i = 0; i < draws.size(); ++i) {
        if (draws[i].indices.empty()) continue;  // it had no proper triangle
        const auto d = std::ranges::find(view.draws, mesh.of.draws[i]) - view.draws.begin();
        made[static_cast<std::size_t>(d)].back() = {draws[i].vertices, draws[i].indices, at.largest};
      }
    }
  }

  LevelGoals goals_;
  double saving_;
};

/// The maker, and what becomes of the sequences.
class LevelsProcessor final : public Processor {
 public:
  explicit LevelsProcessor(const LevelsOptions& options)
      : levels_(level_processor(std::make_unique<const LevelsMaker>(goals_of(options), options.saving))),
        keeps_sequences_(options.keep_sequences) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawsCollapse> sequences = sequences_of(scene, draws);
    if (sequences.empty()) {
      run.keep("no mesh has a sequence of collapses, such as `quadric-collapse` finds before this stage");
      return {};
    }
    std::vector<DrawId> changed = levels_->process(scene, draws, run);
    if (keeps_sequences_ && run.keeps()) return changed;
    if (run.keeps()) run.note("nothing-to-gain", *std::exchange(run.findings.nothing_to_gain, std::nullopt));
    if (!keeps_sequences_) remove_sequences(scene, sequences);
    for (const DrawId id : changed) {  // a sequence makes its levels coarser, too
      if (!traits_of(scene.draws[id]).has(traits::progressive)) continue;
      for (Level& level : scene.draws[id].levels) level.made.add(traits::progressive);
    }
    return changed;
  }

 private:
  std::unique_ptr<Processor> levels_;
  bool keeps_sequences_;
};

}  // namespace

Plugin levels_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "levels",
      .summary = "Adds coarser levels of detail to each mesh, with the largest error of each",
      .reference = "Hoppe 1996, section 3",
      .acts_on = {traits::triangles},
      .needs = {traits::progressive},
      .measured_by = {"surface-error", "attribute-error"},
      .metrics = level_metrics(),
  };
  plugin.products = {collapse_product()};
  OptionTable<LevelsOptions> table;
  table
      .row(&LevelsOptions::ratios, "ratios",
           "Share of each mesh's triangles that each level has, from fine to coarse: falling, between 0 and 1")
      .row(&LevelsOptions::errors, "errors",
           "In place of `ratios`: largest distance of each level from full detail, in either direction, in "
           "units: rising; each level has the fewest triangles that stay within it")
      .row(&LevelsOptions::distances, "distances",
           "In place of `errors`: how near a camera comes to each level, in units: rising; each level has the fewest "
           "triangles that stay within `pixels` from there")
      .row(&LevelsOptions::pixels, "pixels",
           "Error of each of `distances`, in pixels of a picture 1080 pixels high with a field of view of 60 degrees",
           {.least = 0.001})
      .row(&LevelsOptions::saving, "saving",
           "A level that saves less than this share of the triangles of the level before is left out",
           {.least = 0, .most = 1})
      .row(&LevelsOptions::keep_sequences, "keep-sequences",
           "Keep the sequences of collapses for a later stage, and in the file; otherwise they are used up");
  bind_options(plugin, table, [](const LevelsOptions& options) { return std::make_unique<LevelsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
