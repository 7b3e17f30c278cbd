#pragma once
// What is hidden of a scene's draws, wherever nodes show them.

#include "hidden.h"
#include "placed_cameras.h"

#include <foredraw/base/parallel.h>
#include <foredraw/scene/subject.h>

#include <map>

namespace foredraw::processors::hidden {

/// What parts that move hide of one another.
enum class Moving {
  apart,  ///< nothing, unless they follow the same joint alone: that holds in every pose
  clips,  ///< what they hide in all keys of all clips
};

struct HiddenSearchOptions : HiddenOptions {
  Moving moving = Moving::apart;
  SceneCameras cameras;
  SubjectUnit subjects = SubjectUnit::character;  ///< what hides what: parts of one subject
};

struct FoundHidden {
  std::map<DrawId, std::vector<std::uint8_t>> hidden;  ///< [draw asked for][triangle] 0 or 1
  Pixels last_check;         ///< of all subjects: pixels of the last check that still showed something hidden
  std::size_t pictures = 0;  ///< that these pixels are of
  std::size_t poses = 1;     ///< most that a subject was looked at in
  std::size_t proved = 0;    ///< triangles that are hidden by proof
};

/// A triangle is hidden where no part of any subject that has it shows it. Opaque draws hide, whether asked for or not:
/// is_opaque() says which are. Throws what `between` does, and std::invalid_argument where clips have more than 100000
/// keys.
FoundHidden find_hidden(const Scene& scene, std::span<const DrawId> asked, const HiddenSearchOptions& options,
                        const BetweenSteps& between, const Executor& executor);

}  // namespace foredraw::processors::hidden
