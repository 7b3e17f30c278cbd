#pragma once
// A pipeline planned whole before it runs: what runs on what, what is skipped and why, and everything that is wrong at
// once. A plan that exists can be run.

#include <foredraw/pipeline/pipeline.h>
#include <foredraw/report/report.h>
#include <foredraw/scene/lender.h>
#include <foredraw/technique/registry.h>

#include <memory>
#include <optional>

namespace foredraw {

/// A draw that a stage leaves alone.
struct Skip {
  DrawId draw = 0;
  std::string code;
  std::string reason;
};

struct PlannedStage {
  const Plugin* plugin = nullptr;
  std::string label;  ///< the plugin's name, and "#2" for its second use; figures go by it
  Stage stage;
  Settings settings;  ///< fitted to the plugin's table
  std::shared_ptr<const Technique> technique;
  std::vector<DrawId> draws;  ///< that it may work on, as far as can be known before it runs
  std::vector<Skip> skips;
  std::optional<std::string> left_out;  ///< the whole stage does nothing, and why

  /// What it loops over: "draws", "subjects", "vertex streams", "scene".
  std::string_view loops_over() const;
};

/// May run any number of times, and at once. It refers to the registry's plugins: the registry outlives it.
struct Plan {
  Pipeline pipeline;
  std::vector<PlannedStage> stages;
  std::vector<PlannedStage> measures;
  Views views;
  Poses poses;
  ProductRows products;                             ///< what the registry's plugins make
  Loans loans;                                      ///< what options of stages name
  std::vector<ModuleFile> modules;                  ///< what its plugins were loaded from
  std::shared_ptr<const OverdrawService> overdraw;  ///< null: no service is named or needed
};

/// Plans the pipeline for the scene. nullopt where something is wrong; all mistakes are in `diagnostics`, each with its
/// place in the pipeline's text. Warnings are there as well. `lender`: who reads the scenes and images that options
/// name; without one, such an option is a mistake.
std::optional<Plan> plan(const Pipeline& pipeline, const Registry& registry, const Scene& scene,
                         Diagnostics& diagnostics, const Lender* lender = nullptr);

/// For people: a line for each stage, and one for each reason why draws are skipped.
std::string to_text(const Plan& plan, const Scene& scene);
std::string to_json(const Plan& plan, const Scene& scene);

}  // namespace foredraw
