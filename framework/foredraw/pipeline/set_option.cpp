#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/private/line_scanner.h>
#include <foredraw/pipeline/private/set_word.h>
#include <foredraw/pipeline/private/words.h>

#include <fmt/format.h>

namespace foredraw {

std::string there_are(const std::vector<OptionSpec>& specs) {
  std::vector<std::string> words;
  for (const OptionSpec& spec : specs) words.push_back(spec.name);
  return fmt::format("there are {}", fmt::join(words, ", "));
}

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

/// "tipsify.cache-size=24", "views.count=162" or "seed=7" taken apart.
struct Assignment : WordValue {
  std::string stage;  ///< or "views", "poses", "subjects", "frames" or "output"; empty: a word of the pipeline itself
};

std::optional<Assignment> assignment_of(std::string_view text, Diagnostics& diagnostics) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.substr(0, equals).find('.');
  const std::size_t word = dot == std::string_view::npos ? 0 : dot + 1;
  const bool names_something = equals != std::string_view::npos && word < equals && dot != 0;
  if (!names_something || (word == 0 && text.substr(0, equals) != "seed")) {
    diagnostics.error({"--set", 1, 1, {}}, "syntax", fmt::format("expected stage.option=value, found '{}'", text),
                      "such as tipsify.cache-size=24, views.count=162 or seed=7");
    return std::nullopt;
  }
  const Where where{"--set", 1, static_cast<int>(equals) + 2, {}};
  const auto value = scan_value(text.substr(equals + 1), {where}, diagnostics);
  if (!value) return std::nullopt;
  return Assignment{{std::string(text.substr(word, equals - word)), *value, where, {"--set", 1, 1, {}}},
                    std::string(text.substr(0, word == 0 ? 0 : dot))};
}

bool set_of_stages(Pipeline& pipeline, const Assignment& assignment, Diagnostics& diagnostics) {
  if (assignment.word == "use") {
    diagnostics.error({"--set", 1, 1, {}}, "syntax", "'use' cannot be set, because it would make another stage",
                      "write the stages with --pipeline");
    return false;
  }
  const std::vector<Stage*> stages = stages_of(pipeline);
  bool found = false;
  for (Stage* stage : stages) {
    if (stage->use != assignment.stage) continue;
    StageWords words = words_of(*stage);
    words.values[assignment.word] = assignment.value;
    words.where[assignment.word] = assignment.where;
    auto changed = stage_of(words, stage->where, diagnostics);
    if (!changed) return false;
    *stage = std::move(*changed);
    found = true;
  }
  if (!found) {
    diagnostics.error({"--set", 1, 1, {}}, "no-such-stage",
                      fmt::format("the pipeline has no stage '{}'", assignment.stage),
                      what_there_is(assignment.stage, stages));
  }
  return found;
}

}  // namespace

bool set_option(Pipeline& pipeline, std::string_view text, Diagnostics& diagnostics) {
  const auto assignment = assignment_of(text, diagnostics);
  if (!assignment) return false;
  if (assignment->stage.empty()) return set_word(pipeline_words(), pipeline, *assignment, diagnostics);
  if (assignment->stage == "views") {
    if (assignment->word == "views") pipeline.views_where = assignment->where;
    return set_word(view_words(), pipeline.views, *assignment, diagnostics);
  }
  if (assignment->stage == "poses") return set_word(pose_words(), pipeline.poses, *assignment, diagnostics);
  if (assignment->stage == "subjects") return set_word(subject_words(), pipeline.subjects, *assignment, diagnostics);
  if (assignment->stage == "frames") {
    if (assignment->word == "path") pipeline.frames_where = assignment->where;
    return set_word(frame_words(), pipeline.frames, *assignment, diagnostics);
  }
  if (assignment->stage == "output") return set_word(output_words(), pipeline.output, *assignment, diagnostics);
  return set_of_stages(pipeline, *assignment, diagnostics);
}

}  // namespace foredraw
