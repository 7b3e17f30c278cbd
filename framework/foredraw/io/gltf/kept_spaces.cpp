#include <foredraw/io/gltf/private/kept_spaces.h>

#include <foredraw/io/gltf/private/displacement.h>
#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/exchanged_materials.h>

namespace foredraw::gltf {

namespace {

bool says_what_we_do_not_know(const Json& material, const Document& document) {
  bool is_unknown = false;
  each_extension(material, [&](const std::string& name, const Json&) {
    is_unknown = is_unknown || !document.knows_extension(name);
  });
  return is_unknown;
}

}  // namespace

void find_kept_spaces(Scene& scene, const Document& document) {
  const auto keep = [&](std::size_t material) {
    if (material < scene.materials.size()) scene.materials[material].keeps_spaces = true;
  };
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Json& material = document.json["materials"][m];
    const bool is_moved_unseen =
        extension_of(material, displacement_extension) != nullptr && !scene.materials[m].displacement;
    if (is_moved_unseen || says_what_we_do_not_know(material, document)) keep(m);
    for (const std::size_t coarser : coarser_materials(material)) {
      keep(m);
      keep(coarser);
    }
  }
  for (const std::size_t m : animated_materials(document.json)) keep(m);
  each_primitive(document.json, [&](const Json& primitive) {
    const std::vector<std::size_t> variants = variants_of(primitive);
    if (const auto own = primitive.find("material"); own != primitive.end() && !variants.empty())
      keep(own->get<std::size_t>());
    for (const std::size_t variant : variants) keep(variant);
  });
}

}  // namespace foredraw::gltf
