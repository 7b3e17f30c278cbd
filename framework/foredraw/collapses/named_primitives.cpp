#include <foredraw/collapses/named_primitives.h>
#include <foredraw/scene/product_row.h>

#include <algorithm>

namespace foredraw {

std::optional<std::vector<DrawId>> named_primitives(const ExtensionValue* list, const Scene& scene) {
  if (list == nullptr || list->list() == nullptr) return std::nullopt;
  std::vector<DrawId> draws;
  for (const ExtensionValue& one : *list->list()) {
    if (one.list() == nullptr || one.list()->size() != 2) return std::nullopt;
    const auto mesh = one.list()->front().whole(), primitive = one.list()->back().whole();
    if (!mesh || !primitive) return std::nullopt;
    if (*mesh >= scene.meshes.size() || *primitive >= scene.meshes[*mesh].draws.size()) return std::nullopt;
    draws.push_back(scene.meshes[*mesh].draws[*primitive]);
  }
  return draws;
}

ExtensionValue names_of_primitives(std::span<const DrawId> draws, const Scene& scene) {
  return listed(draws, [&](DrawId id) -> ExtensionValue {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      const auto& held = scene.meshes[m].draws;
      const auto found = std::ranges::find(held, id);
      if (found != held.end()) return ExtensionValue::List{m, found - held.begin()};
    }
    throw Refusal("no-mesh", scene.draws[id].name + " is not in a mesh", "remove draws that no mesh holds");
  });
}

}  // namespace foredraw
