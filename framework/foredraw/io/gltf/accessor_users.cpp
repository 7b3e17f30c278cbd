// Who refers to which accessor.
#include <foredraw/io/gltf/private/draw_orders.h>
#include <foredraw/io/gltf/private/merged_instances.h>
#include <foredraw/io/gltf/private/write.h>

namespace foredraw::gltf {

namespace {

/// Every whole number anywhere in the value: what an extension that we do not know might mean as an accessor.
void collect_numbers(const Json& value, std::set<std::size_t>& numbers) {
  if (value.is_number_unsigned()) numbers.insert(value.get<std::size_t>());
  if (!value.is_structured()) return;
  for (const Json& part : value) collect_numbers(part, numbers);
}

bool says_where_its_accessors_are(const std::string& extension) {
  if (extension == draw_orders || extension == merge_instances) return true;
  return is_known_extension(extension) && extension != mesh_gpu_instancing && extension.compare(0, 9, "FOREDRAW_") != 0;
}

void collect_extension_users(const Json& value, std::set<std::size_t>& numbers) {
  if (!value.is_structured()) return;
  for (const auto& [key, part] : value.items()) {
    if (value.is_object() && key == "extras") continue;
    if (value.is_object() && key == "extensions" && part.is_object()) {
      for (const auto& [name, held] : part.items()) {
        if (!says_where_its_accessors_are(name)) collect_numbers(held, numbers);
      }
    }
    collect_extension_users(part, numbers);
  }
}

}  // namespace

std::set<std::size_t> used_elsewhere(const Json& json) {
  std::set<std::size_t> numbers;
  const auto add = [&](const Json& holder, const char* key) {
    if (const auto found = holder.find(key); found != holder.end()) numbers.insert(found->get<std::size_t>());
  };
  if (const auto skins = json.find("skins"); skins != json.end()) {
    for (const Json& skin : *skins) add(skin, "inverseBindMatrices");
  }
  if (const auto animations = json.find("animations"); animations != json.end()) {
    for (const Json& animation : *animations) {
      for (const Json& sampler : animation["samplers"]) {
        add(sampler, "input");
        add(sampler, "output");
      }
    }
  }
  collect_extension_users(json, numbers);
  return numbers;
}

std::set<std::size_t> used_by_primitives(const Json& json) {
  std::set<std::size_t> numbers = used_by_orders(json);
  const auto meshes = json.find("meshes");
  if (meshes == json.end()) return numbers;
  for (const Json& mesh : *meshes) {
    for (const Json& primitive : mesh["primitives"]) {
      if (primitive.contains("indices")) numbers.insert(primitive["indices"].get<std::size_t>());
      for (const Json& number : primitive["attributes"]) numbers.insert(number.get<std::size_t>());
      if (!primitive.contains("targets")) continue;
      for (const Json& target : primitive["targets"]) {
        for (const Json& number : target) numbers.insert(number.get<std::size_t>());
      }
    }
  }
  return numbers;
}

}  // namespace foredraw::gltf
