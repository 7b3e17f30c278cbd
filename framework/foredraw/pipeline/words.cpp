#include <foredraw/pipeline/private/words.h>

#include <foredraw/measuring/frame_options.h>
#include <foredraw/measuring/pose_options.h>
#include <foredraw/measuring/view_options.h>
#include <foredraw/technique/subject_options.h>

#include <algorithm>

namespace foredraw {

OptionTable<Pipeline> pipeline_words() {
  OptionTable<Pipeline> table;
  table.row(&Pipeline::about, "about", "What the pipeline is for, in one sentence");
  table.row(&Pipeline::seed, "seed", "The seed of all random choices");
  return table;
}

OptionTable<ViewSet> view_words() {
  OptionTable<ViewSet> table;
  add_view_rows(table);
  return table;
}

OptionTable<PoseSet> pose_words() {
  OptionTable<PoseSet> table;
  add_pose_rows(table);
  return table;
}

OptionTable<SubjectChoice> subject_words() {
  OptionTable<SubjectChoice> table;
  add_subject_row(table, &SubjectChoice::subject);
  return table;
}

OptionTable<FrameSet> frame_words() {
  OptionTable<FrameSet> table;
  add_frame_rows(table);
  return table;
}

OptionTable<Stage> stage_words() {
  OptionTable<Stage> table;
  table.row(&Stage::use, "use", "The plugin's name");
  table.row(&Stage::only, "only", "Names of the draws to work on, with * and ? as wildcards (default: all)");
  table.row(&Stage::required, "required", "Whether it is an error if the stage would be skipped");
  table.row(&Stage::enabled, "enabled", "Whether the stage runs at all");
  table.row(&Stage::blended, "blended",
            "Whether alpha-blended draws are reordered too, although their order may be visible");
  table.row(&Stage::level, "level",
            "Which level of detail an evaluator measures: 0 is full detail; a draw with fewer levels is measured at "
            "its coarsest",
            {0, 255});
  return table;
}

StageWords words_of(const Stage& stage) {
  StageWords words{stage.settings, stage.option_where};
  words.values["use"] = stage.use;
  if (!stage.only.empty()) words.values["only"] = stage.only;
  if (stage.required) words.values["required"] = true;
  if (!stage.enabled) words.values["enabled"] = false;
  if (stage.blended) words.values["blended"] = true;
  if (stage.level > 0) words.values["level"] = std::int64_t{stage.level};
  return words;
}

std::optional<Stage> stage_of(const StageWords& words, const Where& where, Diagnostics& diagnostics) {
  const OptionTable<Stage> table = stage_words();
  Settings reserved, options;
  std::map<std::string, Where> option_where;
  bool good = true;
  for (const auto& [word, value] : words.values) {
    const auto at = words.where.find(word);
    const Where place = at == words.where.end() ? where : at->second;
    const auto spec = std::ranges::find(table.specs(), word, &OptionSpec::name);
    if (spec == table.specs().end()) {
      options[word] = value;
      option_where[word] = place;
      continue;
    }
    auto fitted = fit(*spec, value);
    if (const auto* why = std::get_if<std::string>(&fitted)) {
      const bool unquoted = spec->type == OptionType::text;
      diagnostics.error(place, "bad-value", *why, unquoted ? "put it in quotes" : "");
      good = false;
    } else {
      reserved[word] = std::get<OptionValue>(std::move(fitted));
    }
  }
  if (!words.values.contains("use")) {
    diagnostics.error(where, "missing-use", "the stage names no plugin", "add use = \"NAME\"");
    good = false;
  }
  if (!good) return std::nullopt;
  Stage stage = table.read(reserved);
  stage.settings = std::move(options);
  stage.where = where;
  stage.option_where = std::move(option_where);
  return stage;
}

}  // namespace foredraw
