#include <foredraw/pipeline/run_record.h>

#include <foredraw/analysis/scene_facts.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/scene/levels.h>

#include <algorithm>
#include <utility>

namespace foredraw {

namespace {

StateRecord state_of(const Draw& draw, const Level& level) {
  StateRecord state;
  state.vertices = level.vertices->count;
  if (draw.topology == Topology::triangles) state.triangles = level.stream().triangle_count();
  return state;
}

/// Every option of an evaluator as it was, defaults included: a figure without them can not be measured again.
std::map<std::string, OptionValue> whole_settings(const PlannedStage& stage) {
  std::map<std::string, OptionValue> whole;
  for (const OptionSpec& option : stage.plugin->options) whole[option.name] = option.default_value;
  for (const auto& [name, value] : stage.settings) whole[name] = value;
  if (stage.stage.level > 0) whole["level"] = std::int64_t{stage.stage.level};
  return whole;
}

std::vector<FileRecord> files_of(const Loans& loans) {
  std::vector<FileRecord> files;
  const auto add = [&](const auto& lent) {
    for (const auto& [path, loan] : lent) files.push_back({path, loan.bytes, to_text(loan.stamp)});
  };
  add(loans.scenes);
  add(loans.images);
  return files;
}

}  // namespace

void describe_input(const Scene& scene, const Surroundings& surroundings, Report& report) {
  report.draws.resize(scene.draws.size());
  const std::vector<MeshFacts> facts = facts_of_draws(scene, surroundings.analyses, surroundings.executor);
  for (std::size_t i = 0; i < scene.draws.size(); ++i) {
    const Draw& draw = scene.draws[i];
    DrawRecord& record = report.draws[i];
    record.name = draw.name;
    record.facts = facts[i];
    for (std::size_t level = 0; level < draw.levels.size(); ++level) {
      record.level(level).before = state_of(draw, draw.levels[level]);
    }
    report.before.triangles += record.before.triangles;
  }
  report.before.vertices = count_vertices(scene);
}

void describe_output(const Scene& scene, Report& report) {
  report.draws.resize(scene.draws.size());
  for (std::size_t i = 0; i < report.draws.size(); ++i) {
    const Draw& draw = scene.draws[i];
    report.draws[i].name = draw.name;
    for (std::size_t level = 0; level < draw.levels.size(); ++level) {
      LevelRecord& record = report.draws[i].level(level);
      const StateRecord state = state_of(draw, draw.levels[level]);
      record.traits = traits_of(draw, level);
      record.error = draw.levels[level].error;
      record.after.triangles = state.triangles;
      record.after.vertices = state.vertices;
      if (level == 0) report.after.triangles += state.triangles;
    }
  }
  report.after.vertices = count_vertices(scene);
}

void describe_plan(const Plan& plan, Report& report) {
  report.pipeline = print_file(plan.pipeline);
  report.named = files_of(plan.loans);
  report.modules = plan.modules;
  report.seed = plan.pipeline.seed;
}

void book(const std::vector<Measured>& figures, const PlannedStage& stage, SceneState of, std::size_t draws,
          Report& report) {
  StateRecord& total = of == SceneState::input ? report.before : report.after;
  const auto state_in = [of](LevelRecord& record) -> StateRecord& {
    return of == SceneState::input ? record.before : record.after;
  };
  report.draws.resize(std::max(report.draws.size(), draws));  // a stage may have added some
  for (const Measured& measured : figures) {
    const Figure figure = figure_of(measured, stage.plugin->card);
    const About& about = measured.about;
    if (about.draw && *about.draw < report.draws.size()) {
      state_in(report.draws[*about.draw].level(about.level)).metrics.add(stage.label, measured.metric, figure);
    }
    if (about == About{}) {
      total.metrics.set(stage.label, measured.metric, figure);
    } else if (about.level == 0) {
      total.metrics.add(stage.label, measured.metric, figure);
    }
  }
}

void book_measures(std::vector<Step> steps, const Plan& plan, SceneState of, std::size_t draws, Report& report) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const PlannedStage& stage = plan.measures[i];
    book(steps[i].measured, stage, of, draws, report);
    report.measures.push_back(std::move(steps[i].record));
    report.evaluator_options[stage.label] = whole_settings(stage);
  }
}

}  // namespace foredraw
