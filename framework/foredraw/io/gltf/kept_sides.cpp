#include <foredraw/io/gltf/private/kept_sides.h>

#include <foredraw/io/gltf/private/exchanged_materials.h>

#include <set>

namespace foredraw::gltf {

namespace {

/// Backs are seen through fronts, or weigh in what shines through.
constexpr const char* passing[] = {"KHR_materials_transmission", "KHR_materials_volume",
                                   "KHR_materials_diffuse_transmission", "KHR_materials_dispersion",
                                   "KHR_materials_volume_scatter"};

bool shows_the_same_sides(const Material& a, const Material& b) {
  return a.alpha_mode == b.alpha_mode && a.double_sided == b.double_sided && a.keeps_sides == b.keeps_sides;
}

void find_exchanged(Scene& scene, const Json& document) {
  const auto meshes = document.find("meshes");
  if (meshes == document.end()) return;
  std::set<std::size_t> exchanged;
  for (const Json& mesh : *meshes) {
    for (const Json& primitive : mesh["primitives"]) {
      const auto own = primitive.find("material");
      if (own == primitive.end() || own->get<std::size_t>() >= scene.materials.size()) continue;
      for (const std::size_t other : variants_of(primitive)) {
        if (other >= scene.materials.size()) continue;
        if (!shows_the_same_sides(scene.materials[own->get<std::size_t>()], scene.materials[other]))
          exchanged.insert(own->get<std::size_t>());
      }
    }
  }
  for (const std::size_t material : exchanged) scene.materials[material].keeps_sides = true;
}

}  // namespace

void find_kept_sides(Scene& scene, const Json& document) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    for (const char* extension : passing) {
      if (extension_of(document["materials"][m], extension) != nullptr) scene.materials[m].keeps_sides = true;
    }
  }
  for (const std::size_t m : animated_materials(document)) {
    if (m < scene.materials.size()) scene.materials[m].keeps_sides = true;
  }
  find_exchanged(scene, document);
}

}  // namespace foredraw::gltf
