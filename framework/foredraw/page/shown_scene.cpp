#include <foredraw/page/private/shown_scene.h>

#include <foredraw/scene/levels.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::size_t most_branches = 24;  // each takes four bytes a triangle

ShownScene shown_scene(const Scene& scene, SubjectUnit unit) {
  ShownScene shown{&scene, subjects_of(scene, unit), ""};
  for (std::size_t level = 1; level < most_levels(scene); ++level) shown.coarser.push_back(at_level(scene, level));
  return shown;
}

}  // namespace

std::vector<ShownScene> shown_scenes(const Scene& input, std::span<const std::optional<Scene>> branches,
                                     SubjectUnit unit) {
  std::vector<ShownScene> scenes{shown_scene(input, unit)};
  for (const auto& branch : branches) {
    if (scenes.size() > most_branches) {  // the input is the first of them
      scenes.push_back({nullptr, {}, fmt::format("only the first {} pipelines are", most_branches)});
    } else if (!branch) {
      scenes.push_back({nullptr, {}, "could not be planned for this file"});
    } else if (branch->animations.size() != input.animations.size()) {
      scenes.push_back({nullptr, {}, "its clips are not those of the input"});
    } else {
      scenes.push_back(shown_scene(*branch, unit));
    }
  }
  return scenes;
}

const Subject* counterpart(std::span<const Subject> subjects, std::span<const Subject> of_input, std::size_t number) {
  if (subjects.size() == of_input.size()) return &subjects[number];
  const auto same_name = [&](const Subject& subject) { return subject.name == of_input[number].name; };
  const auto found = std::ranges::find_if(subjects, same_name);
  const bool is_only_one = std::ranges::count_if(subjects, same_name) == 1;
  return is_only_one && std::ranges::count_if(of_input, same_name) == 1 ? &*found : nullptr;
}

}  // namespace foredraw
