#include <foredraw/scene/own_material.h>

#include <algorithm>
#include <array>

namespace foredraw {

MaterialId own_material(Scene& scene, std::optional<MaterialId> material, std::span<const DrawId> draws) {
  const auto has_another_user = [&] {
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      if (scene.draws[id].material == material && !std::ranges::binary_search(draws, id)) return true;
    }
    return false;
  };
  if (material && !has_another_user()) return *material;
  Material own = material ? scene.materials[*material] : Material{};
  own.copy_of = material;
  const auto id = static_cast<MaterialId>(scene.materials.size());
  scene.materials.push_back(std::move(own));
  for (const DrawId draw : draws) scene.draws[draw].material = id;
  return id;
}

void change_look(Material& material, const Stamp& by) {
  for (std::optional<Stamp>* stamp : {&material.look, &material.kind}) {
    if (*stamp) *stamp = combine(std::array{**stamp, by});
  }
}

}  // namespace foredraw
