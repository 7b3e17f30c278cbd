#include <foredraw/pipeline/contest.h>

#include <foredraw/pipeline/measured_subjects.h>
#include <foredraw/pipeline/usual_measures.h>

#include <algorithm>

namespace foredraw {

namespace {

void add_once(std::vector<Diagnostic>& all, const std::vector<Diagnostic>& some) {
  for (const Diagnostic& diagnostic : some) {
    const auto is_said = [&](const Diagnostic& said) {
      return said.message == diagnostic.message && said.hint == diagnostic.hint;
    };
    if (std::ranges::none_of(all, is_said)) all.push_back(diagnostic);
  }
}

}  // namespace

Contest contest(const FileRecord& input, const Scene& scene, std::span<const NamedPipeline> pipelines,
                const Registry& registry, const Lender* lender, int rounds, const Surroundings& surroundings) {
  Contest made;
  made.comparison.input = input;
  std::vector<Plan> plans;
  std::vector<std::size_t> whose;  // [plan]
  for (const NamedPipeline& named : pipelines) {
    Branch& branch = made.comparison.branches.emplace_back(Branch{named.name, {}});
    Diagnostics diagnostics;
    if (auto planned = plan(named.pipeline, registry, scene, diagnostics, lender)) {
      plans.push_back(std::move(*planned));
      whose.push_back(made.comparison.branches.size() - 1);
      add_once(made.warnings, diagnostics.all());
    } else {
      branch.is_lost = true;
      branch.report.pipeline = print_file(named.pipeline);
      branch.report.diagnostics = diagnostics.all();
    }
  }
  made.scenes.resize(pipelines.size());
  std::vector<Result> results = compare(plans, scene, rounds, surroundings);
  for (std::size_t i = 0; i < results.size(); ++i) {
    made.failed = made.failed || results[i].failed;
    made.scenes[whose[i]] = std::move(results[i].scene);
    Report& report = made.comparison.branches[whose[i]].report;
    report = std::move(results[i].report);
    report.command = "compare";
    report.input = input;
  }
  return made;
}

void measure_alike(std::vector<NamedPipeline>& pipelines, std::vector<Stage> measure, const Registry& registry) {
  if (pipelines.empty()) return;
  if (measure.empty()) measure = pipelines.front().pipeline.measure;
  if (measure.empty()) {
    std::vector<Stage> stages;
    for (const NamedPipeline& named : pipelines) {
      stages.insert(stages.end(), named.pipeline.stages.begin(), named.pipeline.stages.end());
    }
    measure = usual_measures(stages, registry);
  }
  for (NamedPipeline& named : pipelines) named.pipeline.measure = measure;
}

void judge_alike(std::vector<NamedPipeline>& pipelines, const Registry& registry) {
  if (pipelines.empty()) return;
  const SubjectChoice& first = pipelines.front().pipeline.subjects;
  for (NamedPipeline& named : pipelines) {
    if (named.pipeline.subjects != first) judge_subjects_of(first, named.pipeline.measure, registry);
  }
}

}  // namespace foredraw
