#include <foredraw/io/gltf/private/kept_sides.h>

#include <charconv>

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

}  // namespace

void find_kept_sides(Scene& scene, const Json& document) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    for (const char* extension : passing) {
      if (extension_of(document["materials"][m], extension) != nullptr) scene.materials[m].keeps_sides = true;
    }
  }
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

}  // namespace foredraw::gltf
