#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/private/line_scanner.h>
#include <foredraw/pipeline/private/words.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

std::vector<Stage*> stages_of(Pipeline& pipeline) {
  std::vector<Stage*> stages;
  for (Stage& stage : pipeline.stages) stages.push_back(&stage);
  for (Stage& stage : pipeline.measure) stages.push_back(&stage);
  if (pipeline.overdraw) stages.push_back(&*pipeline.overdraw);
  return stages;
}

std::string what_there_is(const std::string& name, const std::vector<Stage*>& stages) {
  std::vector<std::string> names;
  for (const Stage* stage : stages) names.push_back(stage->use);
  if (names.empty()) return "the pipeline has no stages";
  if (const auto near = nearest(name, names); !near.empty()) return fmt::format("did you mean '{}'?", near);
  return fmt::format("the pipeline has {}", fmt::join(names, ", "));
}

}  // namespace

bool set_option(Pipeline& pipeline, std::string_view assignment, Diagnostics& diagnostics) {
  const Where start{"--set", 1, 1, {}};
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.substr(0, equals).find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot == 0 || dot + 1 == equals) {
    diagnostics.error(start, "syntax", fmt::format("expected stage.option=value, found '{}'", assignment),
                      "such as tipsify.cache-size=24");
    return false;
  }
  const std::string name(assignment.substr(0, dot));
  const std::string word(assignment.substr(dot + 1, equals - dot - 1));
  const Where where{start.file, start.line, static_cast<int>(equals) + 2, {}};
  const auto value = scan_value(assignment.substr(equals + 1), {where}, diagnostics);
  if (!value) return false;

  const std::vector<Stage*> stages = stages_of(pipeline);
  bool found = false;
  for (Stage* stage : stages) {
    if (stage->use != name) continue;
    StageWords words = words_of(*stage);
    words.values[word] = *value;
    words.where[word] = where;
    auto changed = stage_of(words, stage->where, diagnostics);
    if (!changed) return false;
    *stage = std::move(*changed);
    found = true;
  }
  if (!found) {
    diagnostics.error(start, "no-such-stage", fmt::format("the pipeline has no stage '{}'", name),
                      what_there_is(name, stages));
  }
  return found;
}

}  // namespace foredraw
