#include <foredraw/pipeline/measured_frames.h>

#include <foredraw/pipeline/private/words.h>

#include <algorithm>

namespace foredraw {

Settings settings_of(const FrameSet& frames) {
  const FrameSet usual;
  Settings settings;
  if (frames.path != usual.path) settings["path"] = frames.path;
  if (frames.frames != usual.frames) settings["frames"] = std::int64_t{frames.frames};
  if (frames.width != usual.width) settings["width"] = std::int64_t{frames.width};
  if (frames.height != usual.height) settings["height"] = std::int64_t{frames.height};
  if (frames.angle != usual.angle) settings["angle"] = frames.angle;
  if (frames.seed != usual.seed) settings["seed"] = frames.seed;
  return settings;
}

void walk_frames_of(const FrameSet& frames, std::vector<Stage>& measures, const Registry& registry) {
  const OptionTable<FrameSet> words = frame_words();
  for (Stage& stage : measures) {
    const Plugin* plugin = registry.find(stage.use);
    const auto has_option = [&](const OptionSpec& word) {
      return std::ranges::find(plugin->options, word.name, &OptionSpec::name) != plugin->options.end();
    };
    if (plugin == nullptr || !std::ranges::all_of(words.specs(), has_option)) continue;
    for (auto& [word, value] : settings_of(frames)) stage.settings.try_emplace(word, value);
  }
}

}  // namespace foredraw
