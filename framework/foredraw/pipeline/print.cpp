#include <foredraw/pipeline/measured_frames.h>
#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/private/line_scanner.h>
#include <foredraw/pipeline/private/words.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

std::string name_on_line(const std::string& name) {
  return is_plain_name(name) ? name : to_text(OptionValue(name), true);
}

std::string value_on_line(const OptionValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return to_text(value, text != nullptr && !is_plain_text(*text));
}

std::string key_in_file(const std::string& key) {
  const bool bare = is_plain_name(key) && key.find_first_of("+./@*?") == std::string::npos;
  return bare ? key : to_text(OptionValue(key), true);
}

std::string row_in_file(const std::string& key, const OptionValue& value) {
  return fmt::format("{} = {}", key_in_file(key), to_text(value, true));
}

/// The words but `use`. An option that was never set has no spelling, and needs none.
Settings spelled_words(const Stage& stage) {
  Settings words = words_of(stage).values;
  words.erase("use");
  std::erase_if(words, [](const auto& word) { return std::holds_alternative<std::monostate>(word.second); });
  return words;
}

std::string stage_in_file(const Stage& stage) {
  const Settings words = spelled_words(stage);
  if (words.empty() && is_plain_name(stage.use)) return '"' + stage.use + '"';
  std::string text = "{ " + row_in_file("use", stage.use);
  for (const auto& [word, value] : words) text += ", " + row_in_file(word, value);
  return text + " }";
}

std::string list_in_file(const std::string& name, const std::vector<Stage>& stages) {
  if (stages.empty()) return name + " = []\n";
  std::string text = name + " = [\n";
  for (const Stage& stage : stages) text += "  " + stage_in_file(stage) + ",\n";
  return text + "]\n";
}

std::string modules_in_file(const std::vector<ModuleDemand>& modules) {
  std::string text;
  for (const ModuleDemand& demand : modules) {
    text += (text.empty() ? "" : ", ") + to_text(OptionValue(to_text(demand)), true);
  }
  return "modules = [" + text + "]\n";
}

std::string views_in_file(const ViewSet& views) {
  const ViewSet usual;
  std::string text = "\n[views]\n";
  if (views.views != usual.views) text += row_in_file("views", views.views) + '\n';
  if (views.count) text += row_in_file("count", std::int64_t{*views.count}) + '\n';
  if (views.seed != usual.seed) text += row_in_file("seed", views.seed) + '\n';
  if (views.axis != usual.axis) text += row_in_file("axis", views.axis) + '\n';
  if (views.angle != usual.angle) text += row_in_file("angle", views.angle) + '\n';
  if (views.rotation) text += row_in_file("rotation", *views.rotation) + '\n';
  if (views.distance) text += row_in_file("distance", *views.distance) + '\n';
  if (views.size != usual.size) text += row_in_file("size", std::int64_t{views.size}) + '\n';
  return text;
}

std::string poses_in_file(const PoseSet& poses) {
  const PoseSet usual;
  std::string text = "\n[poses]\n";
  if (poses.poses != usual.poses) text += row_in_file("poses", poses.poses) + '\n';
  if (poses.clips != usual.clips) text += row_in_file("clips", poses.clips) + '\n';
  if (poses.rate) text += row_in_file("rate", *poses.rate) + '\n';
  if (poses.moments != usual.moments) text += row_in_file("moments", poses.moments) + '\n';
  return text;
}

std::string subjects_in_file(const SubjectChoice& subjects) {
  return "\n[subjects]\n" + row_in_file("subject", std::string(text_of(subjects.subject))) + '\n';
}

std::string frames_in_file(const FrameSet& frames) {
  std::string text = "\n[frames]\n";
  for (const auto& [word, value] : settings_of(frames)) text += row_in_file(word, value) + '\n';
  return text;
}

std::string output_in_file(const OutputSettings& output) {
  std::string text = "\n[output]\n";
  for (const auto& [word, value] : words_of(output)) text += row_in_file(word, value) + '\n';
  return text;
}

}  // namespace

std::string print_file(const Pipeline& pipeline) {
  std::string text = "pipeline = 1\n";
  if (!pipeline.about.empty()) text += row_in_file("about", pipeline.about) + '\n';
  if (pipeline.seed != 0) text += row_in_file("seed", pipeline.seed) + '\n';
  if (!pipeline.modules.empty()) text += modules_in_file(pipeline.modules);
  text += list_in_file("stages", pipeline.stages);
  if (!pipeline.measure.empty()) text += list_in_file("measure", pipeline.measure);
  if (pipeline.views != ViewSet{}) text += views_in_file(pipeline.views);
  if (pipeline.poses != PoseSet{}) text += poses_in_file(pipeline.poses);
  if (pipeline.subjects != SubjectChoice{}) text += subjects_in_file(pipeline.subjects);
  if (pipeline.frames != FrameSet{}) text += frames_in_file(pipeline.frames);
  if (pipeline.output != OutputSettings{}) text += output_in_file(pipeline.output);
  if (pipeline.overdraw) text += "\n[services]\noverdraw = " + stage_in_file(*pipeline.overdraw) + '\n';
  return text;
}

std::string print_stage(const Stage& stage) {
  std::string options;
  for (const auto& [word, value] : spelled_words(stage)) {
    if (!options.empty()) options += ", ";
    options += name_on_line(word) + '=' + value_on_line(value);
  }
  return name_on_line(stage.use) + (options.empty() ? "" : '(' + options + ')');
}

std::optional<std::string> print_line(const Pipeline& pipeline) {
  Pipeline of_stages;
  of_stages.stages = pipeline.stages;
  if (!pipeline.about.empty() || !same_pipeline(pipeline, of_stages)) return std::nullopt;
  std::string text;
  for (const Stage& stage : pipeline.stages) {
    if (!text.empty()) text += ", ";
    text += print_stage(stage);
  }
  return text;
}

}  // namespace foredraw
