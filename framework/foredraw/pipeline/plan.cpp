#include <foredraw/pipeline/plan.h>

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/pipeline/eligible.h>
#include <foredraw/pipeline/measured_frames.h>
#include <foredraw/pipeline/measured_subjects.h>
#include <foredraw/pipeline/named_files.h>
#include <foredraw/pipeline/trait_makers.h>
#include <foredraw/scene/levels.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

class Planner {
 public:
  Planner(const Registry& registry, const Scene& scene, const Lender* lender, Diagnostics& diagnostics)
      : registry_(registry), scene_(scene), lender_(lender), diagnostics_(diagnostics), makers_(registry, diagnostics) {
    for (const Draw& draw : scene.draws) traits_.push_back(traits_of(draw));
    holders_ = holders_of_draws(scene, registry.products());
  }

  Plan plan(const Pipeline& as_written) {
    Plan plan;
    plan.pipeline = with_paths_from_here(as_written, registry_);
    if (as_written.subjects != SubjectChoice{}) {
      judge_subjects_of(as_written.subjects, plan.pipeline.measure, registry_);
    }
    walk_frames_of(plan.pipeline.frames, plan.pipeline.measure, registry_);
    const Pipeline& pipeline = plan.pipeline;
    check_demands(pipeline.modules, registry_, diagnostics_);
    plan.products = registry_.products();
    auto views = views_of(pipeline.views);
    if (const auto* mistake = std::get_if<std::string>(&views)) {
      error(pipeline.views_where, "bad-views", *mistake);
    } else {
      plan.views = std::get<Views>(std::move(views));
    }
    try {
      plan.poses = make_poses(scene_, pipeline.poses);
      if (const auto why = why_at_rest(scene_, pipeline.poses)) {
        diagnostics_.warning(pipeline.poses_where, "at-rest", *why, "characters are drawn at rest");
      }
    } catch (const std::invalid_argument& mistake) {
      error(pipeline.poses_where, "bad-poses", mistake.what());
    }
    add_stages(pipeline.stages, false, plan.stages);
    add_stages(pipeline.measure, true, plan.measures);
    plan.overdraw = overdraw_service(pipeline, plan);
    plan.loans = std::move(loans_);
    for (const auto* stages : {&plan.stages, &plan.measures}) {
      for (const PlannedStage& stage : *stages) add_module_of(stage, plan.modules);
    }
    return plan;
  }

 private:
  void error(Where where, std::string code, std::string message, std::string hint = {}) {
    diagnostics_.error(std::move(where), std::move(code), std::move(message), std::move(hint));
  }

  void add_module_of(const PlannedStage& stage, std::vector<ModuleFile>& modules) const {
    const ModuleFile* module = registry_.module_of(stage.plugin->card.name);
    if (module == nullptr || std::ranges::find(modules, module->path, &ModuleFile::path) != modules.end()) return;
    modules.push_back(*module);
  }

  void add_stages(const std::vector<Stage>& stages, bool measure, std::vector<PlannedStage>& planned) {
    for (const Stage& stage : stages) {
      if (!stage.enabled) continue;
      later_ = plugins_of(std::span(stages).subspan(static_cast<std::size_t>(&stage - stages.data()) + 1));
      auto checked = check(stage, measure);
      if (!checked) {
        is_gap_before_ = true;
        continue;
      }
      choose_draws(*checked);
      planned.push_back(std::move(*checked));
    }
  }

  std::vector<const Plugin*> plugins_of(std::span<const Stage> stages) const {
    std::vector<const Plugin*> plugins;
    for (const Stage& stage : stages) {
      const Plugin* plugin = stage.enabled ? registry_.find(stage.use) : nullptr;
      if (plugin != nullptr) plugins.push_back(plugin);
    }
    return plugins;
  }

  std::string label_of(const std::string& use) {
    const int uses = ++uses_[use];
    return uses == 1 ? use : fmt::format("{}#{}", use, uses);
  }

  const Plugin* find(const Stage& stage) {
    if (const Plugin* plugin = registry_.find(stage.use)) return plugin;
    error(stage.where, "unknown-plugin", fmt::format("there is no plugin '{}'", stage.use),
          registry_.hint_for(stage.use, registry_.names()));
    return nullptr;
  }

  std::optional<Settings> fitted(const std::vector<OptionSpec>& options, const Stage& stage) {
    Settings settings;
    bool good = true;
    for (const auto& [name, value] : stage.settings) {
      const auto at = stage.option_where.find(name);
      const Where where = at == stage.option_where.end() ? stage.where : at->second;
      const auto spec = std::ranges::find(options, name, &OptionSpec::name);
      if (spec == options.end()) {
        std::vector<std::string> names(std::begin(reserved_words), std::end(reserved_words));
        for (const OptionSpec& option : options) names.push_back(option.name);
        const std::string_view near = nearest(name, names);
        error(where, "unknown-option", fmt::format("'{}' has no option '{}'", stage.use, name),
              near.empty() ? fmt::format("foredraw show {} lists its options", stage.use)
                           : fmt::format("did you mean '{}'?", near));
        good = false;
        continue;
      }
      auto result = fit(*spec, value);
      if (auto* why = std::get_if<std::string>(&result)) {
        error(where, "bad-option", *why);
        good = false;
      } else {
        settings[name] = std::get<OptionValue>(std::move(result));
      }
    }
    if (!good || !borrow(stage, options, settings, lender_, loans_, diagnostics_)) return std::nullopt;
    return settings;
  }

  std::optional<PlannedStage> check(const Stage& stage, bool measure) {
    const Plugin* plugin = find(stage);
    if (plugin == nullptr) return std::nullopt;
    if ((plugin->kind == Kind::evaluator) != measure) {
      error(stage.where, "wrong-list",
            measure ? fmt::format("'{}' changes the scene; only evaluators can measure", stage.use)
                    : fmt::format("'{}' is an evaluator; stages must order or change", stage.use),
            measure ? "list it under stages (--pipeline)" : "list it under measure (--with)");
      return std::nullopt;
    }
    auto settings = fitted(plugin->options, stage);
    if (!settings) return std::nullopt;
    try {
      PlannedStage planned{plugin, label_of(stage.use), stage, *settings, nullptr, {}, {}, std::nullopt};
      planned.technique = std::make_shared<const Technique>(plugin->create(*settings));
      if (plugin->unavailable) planned.left_out = plugin->unavailable();
      return planned;
    } catch (const std::exception& problem) {
      error(stage.where, "bad-option", fmt::format("'{}': {}", stage.use, problem.what()));
      return std::nullopt;
    }
  }

  void choose_draws(PlannedStage& planned) {
    const Card& card = planned.plugin->card;
    if (planned.left_out) {
      refuse_where_required(planned, *planned.left_out);
      return;
    }
    if (planned.loops_over() == "scene" && !planned.stage.only.empty() && planned.plugin->kind == Kind::evaluator) {
      error(planned.stage.where, "bad-option",
            fmt::format("'{}' measures the scene as a whole; it takes no 'only'", card.name), "leave 'only' out");
    }
    if (planned.stage.level > 0 && planned.plugin->kind != Kind::evaluator) {
      error(planned.stage.where, "bad-option",
            fmt::format("'{}' works on every level; 'level' is for evaluators", card.name), "leave 'level' out");
    }
    for (DrawId id = 0; id < scene_.draws.size(); ++id) {
      if (auto skip = why_not(planned, scene_, id, traits_[id], holders_)) {
        planned.skips.push_back(std::move(*skip));
      } else {
        planned.draws.push_back(id);
      }
    }
    if (const auto hint = names_instead(planned.stage, scene_); hint && !planned.stage.required) {
      diagnostics_.warning(planned.stage.where, "only",
                           fmt::format("'{}' works on nothing: only = \"{}\" names no draw of {}", card.name,
                                       planned.stage.only, scene_.name.empty() ? "the scene" : scene_.name),
                           *hint);
    }
    if (planned.plugin->kind != Kind::evaluator) {
      if (!is_gap_before_) makers_.look_around(planned, later_);
      makers_.follow(planned);
      for (DrawId id : planned.draws) traits_[id] = after_stage(card, traits_[id]);
    }
    if (planned.draws.empty() && !planned.skips.empty()) {
      refuse_where_required(planned, planned.skips.front().reason);
    }
  }

  void refuse_where_required(const PlannedStage& planned, const std::string& reason) {
    if (!planned.stage.required || (is_gap_before_ && !planned.left_out)) return;
    error(planned.stage.where, "required",
          fmt::format("'{}' is required but would be skipped: {}", planned.stage.use, reason),
          "remove required = true, or use a scene that the stage acts on");
  }

  static const PlannedStage* user_of_overdraw(const Plan& plan) {
    for (const auto* stages : {&plan.stages, &plan.measures}) {
      for (const PlannedStage& stage : *stages) {
        if (stage.plugin->card.uses_overdraw) return &stage;
      }
    }
    return nullptr;
  }

  std::shared_ptr<const OverdrawService> overdraw_service(const Pipeline& pipeline, const Plan& plan) {
    if (pipeline.overdraw) return service_of(*pipeline.overdraw);
    const PlannedStage* user = user_of_overdraw(plan);
    if (user == nullptr) return nullptr;
    // An exact one, so that orders do not hang on what else a build or a machine has; others where there is none.
    std::vector<const Plugin*> answering = registry_.all();
    std::stable_partition(answering.begin(), answering.end(), [](const Plugin* plugin) { return plugin->exact; });
    for (const Plugin* plugin : answering) {
      if (plugin->overdraw_service && !(plugin->unavailable && plugin->unavailable())) {
        return plugin->overdraw_service({});
      }
    }
    error(user->stage.where, "no-service",
          fmt::format("'{}' needs measured overdraw, but no evaluator in this build supplies it", user->stage.use),
          "build with an evaluator that measures overdraw, such as overdraw-raster");
    return nullptr;
  }

  std::shared_ptr<const OverdrawService> service_of(const Stage& stage) {
    const Plugin* plugin = find(stage);
    if (plugin == nullptr) return nullptr;
    if (!plugin->overdraw_service) {
      error(stage.where, "no-service", fmt::format("'{}' does not measure overdraw", stage.use),
            "name an evaluator that does, such as overdraw-raster, or remove [services]");
      return nullptr;
    }
    if (const auto why = plugin->unavailable ? plugin->unavailable() : std::nullopt) {
      error(stage.where, "unavailable", fmt::format("'{}' cannot run on this machine: {}", stage.use, *why),
            "name another evaluator, or remove [services]");
      return nullptr;
    }
    const auto settings = fitted(plugin->service_options, stage);
    return settings ? plugin->overdraw_service(*settings) : nullptr;
  }

  const Registry& registry_;
  const Scene& scene_;
  const Lender* lender_;
  Diagnostics& diagnostics_;
  TraitMakers makers_;
  Loans loans_;
  std::vector<Traits> traits_;  // of each draw, as the stages so far leave them
  Holders holders_;
  std::vector<const Plugin*> later_;  // of the stages that follow the one that is planned
  std::map<std::string, int> uses_;
  /// A mistake in a stage before was told. What that stage would have made is not known, so nothing is said to lack it.
  bool is_gap_before_ = false;
};

}  // namespace

std::string_view PlannedStage::loops_over() const {
  return std::visit([](const auto& shape) { return shape->works_on; }, *technique);
}

std::optional<Plan> plan(const Pipeline& pipeline, const Registry& registry, const Scene& scene,
                         Diagnostics& diagnostics, const Lender* lender) {
  Diagnostics found;
  Plan plan = Planner(registry, scene, lender, found).plan(pipeline);
  for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
  if (found.has_errors()) return std::nullopt;
  return plan;
}

}  // namespace foredraw
