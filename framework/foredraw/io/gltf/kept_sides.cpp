#include <foredraw/io/gltf/private/kept_sides.h>

#include <charconv>
#include <set>

namespace foredraw::gltf {

namespace {

/// Backs are seen through fronts, or weigh in what shines through.
constexpr const char* passing[] = {"KHR_materials_transmission", "KHR_materials_volume",
                                   "KHR_materials_diffuse_transmission", "KHR_materials_dispersion",
                                   "KHR_materials_volume_scatter"};

/// "/materials/3/pbrMetallicRoughness/...": 3.
std::optional<std::size_t> material_in(std::string_view pointer) {
  constexpr std::string_view materials = "/materials/";
  if (!pointer.starts_with(materials)) return std::nullopt;
  pointer.remove_prefix(materials.size());
  std::size_t number = 0;
  const auto read = std::from_chars(pointer.data(), pointer.data() + pointer.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

bool shows_the_same_sides(const Material& a, const Material& b) {
  return a.alpha_mode == b.alpha_mode && a.double_sided == b.double_sided && a.keeps_sides == b.keeps_sides;
}

void find_animated(Scene& scene, const Json& document) {
  const auto animations = document.find("animations");
  if (animations == document.end()) return;
  for (const Json& animation : *animations) {
    for (const Json& channel : animation.value("channels", Json::array())) {
      const auto target = channel.find("target");
      if (target == channel.end()) continue;
      const Json* pointer = extension_of(*target, "KHR_animation_pointer");
      if (pointer == nullptr || !pointer->is_object()) continue;
      const auto path = pointer->find("pointer");
      if (path == pointer->end() || !path->is_string()) continue;
      const auto material = material_in(path->get<std::string>());
      if (material && *material < scene.materials.size()) scene.materials[*material].keeps_sides = true;
    }
  }
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

std::vector<std::size_t> variants_of(const Json& primitive) {
  std::vector<std::size_t> materials;
  const Json* variants = extension_of(primitive, "KHR_materials_variants");
  if (variants == nullptr || !variants->is_object()) return materials;
  const auto mappings = variants->find("mappings");
  if (mappings == variants->end() || !mappings->is_array()) return materials;
  for (const Json& mapping : *mappings) {
    if (!mapping.is_object()) continue;
    const auto material = mapping.find("material");
    if (material != mapping.end() && material->is_number_unsigned()) materials.push_back(*material);
  }
  return materials;
}

void find_kept_sides(Scene& scene, const Json& document) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    for (const char* extension : passing) {
      if (extension_of(document["materials"][m], extension) != nullptr) scene.materials[m].keeps_sides = true;
    }
  }
  find_animated(scene, document);
  find_exchanged(scene, document);
}

}  // namespace foredraw::gltf
