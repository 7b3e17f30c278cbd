// Who refers to which accessor.
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/products.h>

#include <algorithm>

namespace foredraw::gltf {

void collect_numbers(const Json& value, std::set<std::size_t>& numbers) {
  if (value.is_number_unsigned()) numbers.insert(value.get<std::size_t>());
  if (!value.is_structured()) return;
  for (const Json& part : value) collect_numbers(part, numbers);
}

namespace {

void collect_extension_users(const Document& document, std::set<std::size_t>& numbers) {
  each_extension(document.json, [&](const std::string& name, const Json& held) {
    if (!document.knows_extension(name) || name == mesh_gpu_instancing) collect_numbers(held, numbers);
  });
}

}  // namespace

std::set<std::size_t> named_by_unknown_extensions(const Document& document) {
  std::set<std::size_t> numbers;
  collect_extension_users(document, numbers);
  return numbers;
}

std::set<std::size_t> used_elsewhere(const Document& document) {
  const Json& json = document.json;
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
  collect_extension_users(document, numbers);
  return numbers;
}

std::set<std::size_t> used_by_primitives(const Json& json) {
  std::set<std::size_t> numbers;
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

void each_accessor_named(Json& json, const std::function<void(Json& number)>& visit) {
  each_primitive(json, [&](Json& primitive) {
    if (primitive.contains("indices")) visit(primitive["indices"]);
    for (Json& number : primitive["attributes"]) visit(number);
    if (!primitive.contains("targets")) return;
    for (Json& target : primitive["targets"]) {
      for (Json& number : target) visit(number);
    }
  });
  const auto each_of = [&](const char* list, const auto& of_one) {
    if (const auto found = json.find(list); found != json.end()) std::ranges::for_each(*found, of_one);
  };
  each_of("skins", [&](Json& skin) {
    if (skin.contains("inverseBindMatrices")) visit(skin["inverseBindMatrices"]);
  });
  each_of("animations", [&](Json& animation) {
    for (Json& sampler : animation["samplers"]) {
      visit(sampler["input"]);
      visit(sampler["output"]);
    }
  });
  each_of("nodes", [&](Json& node) {
    if (extension_of(node, mesh_gpu_instancing) == nullptr) return;
    for (Json& number : node["extensions"][mesh_gpu_instancing]["attributes"]) visit(number);
  });
}

void release_unnamed(std::set<std::size_t> accessors, const Document& document, Json& json, AccessorStore& store) {
  if (accessors.empty()) return;
  std::set<std::size_t> named = used_by_products(json, document.products);
  each_extension(json, [&](const std::string& name, const Json& held) {
    if (!document.knows_extension(name)) collect_numbers(held, named);
  });
  each_accessor_named(json, [&](const Json& number) { named.insert(number.get<std::size_t>()); });
  for (const std::size_t accessor : accessors) {
    if (!named.contains(accessor)) store.release(accessor);
  }
}

}  // namespace foredraw::gltf
