#include <foredraw/scene/product_row.h>

namespace foredraw {

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

void mark_held_draws(Scene& scene, const ProductRows& rows) {
  for (const auto& row : rows) {
    if (!scene.products.has(row->card().name)) continue;
    for (const DrawId draw : row->held(scene)) scene.draws[draw].traits.add(traits::extended);
  }
}

}  // namespace foredraw
