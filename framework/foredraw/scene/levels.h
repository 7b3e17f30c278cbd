#pragma once
// (draw, level) is the address of what is drawn. Whoever works on a level is handed it as the draw's one level.

#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw {

/// What holds for a level of the draw: found in the asset, or made by stages. The coarsest one, where there are fewer.
Traits traits_of(const Draw& draw, std::size_t level = 0);

/// For messages: the draw's name, and the level behind it where that is not full detail: "Rock (level 2)".
std::string name_of(const Draw& draw, std::size_t level);

/// The most levels that a draw of the scene has; 0 where it has no draws.
std::size_t most_levels(const Scene& scene);

/// The draw with that level, or its coarsest one, alone.
Draw at_level(const Draw& draw, std::size_t level);

/// The scene with every draw at that level. Products are of full detail, so others have none.
Scene at_level(const Scene& scene, std::size_t level);

/// Puts back what became of a draw that was handed out as at_level() gives it. What is not a level is taken from full
/// detail alone; of a draw that has no other level all is taken.
void put_level(Draw& draw, std::size_t level, Draw changed);

}  // namespace foredraw
