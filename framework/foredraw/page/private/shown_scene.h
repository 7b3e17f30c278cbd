#pragma once
#include <foredraw/scene/subject.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// A scene that a page shows, the input or what a pipeline made of it; or why it does not.
struct ShownScene {
  const Scene* scene = nullptr;
  std::vector<Subject> subjects;
  std::string absent;
  std::vector<Scene> coarser = {};  ///< the scene at level 1, 2, ...
};

/// The input, then each pipeline's.
std::vector<ShownScene> shown_scenes(const Scene& input, std::span<const std::optional<Scene>> branches,
                                     SubjectUnit unit);

/// What became of a subject of the input: that of the same number where there are as many, else the only one of its
/// name; nothing where there is none.
const Subject* counterpart(std::span<const Subject> subjects, std::span<const Subject> of_input, std::size_t number);

}  // namespace foredraw
