#pragma once
#include <foredraw/scene/scene.h>

#include <optional>
#include <span>

namespace foredraw {

/// Gives these draws (rising), all of which have this material, one that no other draw has, to be changed: the same, or
/// a copy where others have it too; a new one where they have none.
MaterialId own_material(Scene& scene, std::optional<MaterialId> material, std::span<const DrawId> draws);

/// Marks a material as looking otherwise, by what was changed: those that were alike and change alike stay alike.
void change_look(Material& material, const Stamp& by);

}  // namespace foredraw
