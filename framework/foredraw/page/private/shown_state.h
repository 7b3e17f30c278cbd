#pragma once
#include <foredraw/page/private/shown_scene.h>
#include <foredraw/page/shown_subject.h>

namespace foredraw {

/// What one scene shows of a subject; or why it shows nothing.
struct ShownState {
  const Scene* scene = nullptr;
  const Subject* subject = nullptr;
  ShownSubject shown;
  std::string absent;
  /// [part][vertex that is shown] what it becomes among those of the next coarser level; nothing where the scene does
  /// not say, or where one of them is not shown.
  std::vector<std::vector<std::uint32_t>> ancestors = {};
  double error = 0;                      ///< largest distance from full detail, as nodes stand; 0: none, or not known
  std::vector<ShownState> coarser = {};  ///< at level 1, 2, ...
};

/// `number`: of the subject among those of the input. `once`: shared by the scenes of a subject.
ShownState shown_state(const ShownScene& scene, std::span<const Subject> of_input, std::size_t number,
                       ShownTrianglesOnce& once);

}  // namespace foredraw
