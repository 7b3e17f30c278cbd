#include <foredraw/job/pipelines.h>

#include <foredraw/pipeline/contest.h>
#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/plan.h>

namespace foredraw {

namespace {

bool set_wherever_it_is(std::vector<NamedPipeline>& pipelines, const std::string& assignment,
                        Diagnostics& diagnostics) {
  Diagnostics nowhere;
  bool found = false;
  for (NamedPipeline& named : pipelines) {
    Diagnostics here;
    if (set_option(named.pipeline, assignment, here)) {
      found = true;
      continue;
    }
    const bool no_such_stage = here.all().front().code == "no-such-stage";
    for (const Diagnostic& diagnostic : here.all()) (no_such_stage ? nowhere : diagnostics).add(diagnostic);
    if (!no_such_stage) return false;
  }
  if (!found) diagnostics.add(nowhere.all().front());
  return found;
}

bool set_in_all(std::vector<NamedPipeline>& pipelines, const Settings& output, Diagnostics& diagnostics) {
  for (const auto& [word, value] : output) {
    for (NamedPipeline& named : pipelines) {
      if (!set_output(named.pipeline.output, word, value, {.file = "--" + word}, diagnostics)) return false;
    }
  }
  return true;
}

}  // namespace

bool change(std::vector<NamedPipeline>& pipelines, const PipelineChanges& changes, const Registry& registry,
            Diagnostics& diagnostics) {
  auto measure = changes.with.empty() ? std::optional<std::vector<Stage>>(std::in_place)
                                      : parse_stages(changes.with, "--with", diagnostics);
  if (!measure) return false;
  measure_alike(pipelines, std::move(*measure), registry);
  bool good = true;
  for (const std::string& assignment : changes.set) {
    good = set_wherever_it_is(pipelines, assignment, diagnostics) && good;
  }
  good = set_in_all(pipelines, changes.output, diagnostics) && good;
  judge_alike(pipelines, registry);
  return good;
}

std::optional<Pipeline> changed(std::optional<std::vector<NamedPipeline>> pipelines, const std::string& name,
                                const PipelineChanges& changes, const Registry& registry, Diagnostics& diagnostics) {
  if (!pipelines || !change(*pipelines, changes, registry, diagnostics)) return std::nullopt;
  return only_one(std::move(pipelines), name, diagnostics);
}

bool is_sound(const Pipeline& pipeline, const Registry& registry, const Lender& lender, Diagnostics& diagnostics) {
  Diagnostics found;
  if (plan(pipeline, registry, Scene(), found, &lender)) return true;
  for (const Diagnostic& diagnostic : found.all()) {
    if (diagnostic.severity == Severity::error) diagnostics.add(diagnostic);
  }
  return false;
}

}  // namespace foredraw
