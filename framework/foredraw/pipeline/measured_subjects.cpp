#include <foredraw/pipeline/measured_subjects.h>

#include <algorithm>

namespace foredraw {

void judge_subjects_of(const SubjectChoice& subjects, std::vector<Stage>& measures, const Registry& registry) {
  constexpr const char* word = "subject";
  for (Stage& stage : measures) {
    const Plugin* plugin = registry.find(stage.use);
    if (plugin == nullptr || stage.settings.contains(word)) continue;
    const bool has_it = std::ranges::find(plugin->options, word, &OptionSpec::name) != plugin->options.end();
    if (has_it) stage.settings[word] = std::string(text_of(subjects.subject));
  }
}

}  // namespace foredraw
