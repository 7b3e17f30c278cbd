#include <foredraw/io/gltf/private/exchanged_materials.h>

#include <foredraw/io/gltf/private/material_textures.h>

#include <charconv>

namespace foredraw::gltf {

namespace {

/// "/materials/3/pbrMetallicRoughness/...": 3.
std::optional<std::size_t> material_in(std::string_view pointer) {
  constexpr std::string_view materials = "/materials/";
  if (!pointer.starts_with(materials)) return std::nullopt;
  pointer.remove_prefix(materials.size());
  std::size_t number = 0;
  const auto read = std::from_chars(pointer.data(), pointer.data() + pointer.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
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

std::vector<std::size_t> coarser_materials(const Json& material) {
  const Json* lod = extension_of(material, "MSFT_lod");
  std::vector<std::size_t> numbers;
  if (lod == nullptr) return numbers;
  for (const Json& number : object_in(*lod, "ids")) {
    if (number.is_number_unsigned()) numbers.push_back(number.get<std::size_t>());
  }
  return numbers;
}

std::set<std::size_t> animated_materials(const Json& document) {
  std::set<std::size_t> materials;
  const auto animations = document.find("animations");
  if (animations == document.end()) return materials;
  for (const Json& animation : *animations) {
    for (const Json& channel : animation.value("channels", Json::array())) {
      const auto target = channel.find("target");
      if (target == channel.end()) continue;
      const Json* pointer = extension_of(*target, "KHR_animation_pointer");
      if (pointer == nullptr || !pointer->is_object()) continue;
      const auto path = pointer->find("pointer");
      if (path == pointer->end() || !path->is_string()) continue;
      if (const auto material = material_in(path->get<std::string>())) materials.insert(*material);
    }
  }
  return materials;
}

}  // namespace foredraw::gltf
