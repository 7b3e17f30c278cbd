#include <foredraw/scene/product_row.h>

#include <algorithm>

namespace foredraw {

const ExtensionValue& needed_member(const ExtensionValue& of, const char* name) {
  const ExtensionValue* value = of.member(name);
  if (value == nullptr) throw WrongExtension(std::string("has no '") + name + "'");
  return *value;
}

std::vector<std::string> ProductRow::follow(const Scene&, Scene& after) const {
  const std::string why = difference(after);
  if (why.empty()) return {};
  leave_out(after);
  return {"the " + card().title + " are left out, because they no longer match the scene: " + why};
}

SideFile ProductRow::side_file(const Scene&, std::string_view extension, const std::string&) const {
  throw Refusal("unknown-kind", card().title + " cannot be written as " + std::string(extension),
                "write the scene as .glb");
}

std::vector<std::uint32_t> bounds_of(const Scene& scene, DrawLevel at, const ProductRows& rows, std::string_view but) {
  std::vector<std::uint32_t> bounds;
  for (const auto& row : rows) {
    if (row->card().name == but || !scene.products.has(row->card().name)) continue;
    const auto of_row = row->bounds(scene, at);
    bounds.insert(bounds.end(), of_row.begin(), of_row.end());
  }
  const std::size_t triangles = scene.draws[at.draw].levels[at.level].stream().triangle_count();
  std::erase_if(bounds, [&](std::uint32_t bound) { return bound == 0 || bound >= triangles; });
  std::ranges::sort(bounds);
  bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
  return bounds;
}

void mark_held_draws(Scene& scene, const ProductRows& rows) {
  for (const auto& row : rows) {
    if (!scene.products.has(row->card().name)) continue;
    for (const DrawId draw : row->held(scene)) scene.draws[draw].traits.add(traits::extended);
  }
}

}  // namespace foredraw
