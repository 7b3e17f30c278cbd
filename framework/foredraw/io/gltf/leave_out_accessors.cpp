// Accessors that nothing names any more, left out of the text: others move up.
#include <foredraw/io/gltf/private/layout.h>

#include <algorithm>
#include <functional>

namespace foredraw::gltf {

namespace {

using Visit = std::function<void(Json& number)>;

/// Whether an extension of ours is anywhere: products name accessors, and the rows alone know where.
bool holds_products(const Json& value) {
  if (!value.is_structured()) return false;
  return std::ranges::any_of(value.items(), [&](const auto& item) {
    const bool is_ours = value.is_object() && item.key().starts_with("FOREDRAW_");
    return is_ours || holds_products(item.value());
  });
}

/// All that names an accessor, products apart.
void each_accessor_named(Json& json, const Visit& visit) {
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

}  // namespace

void leave_out_accessors(Json& json) {
  if (!json.contains("accessors") || holds_products(json)) return;
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> number(json["accessors"].size(), none);
  each_accessor_named(json, [&](const Json& named) { number[named.get<std::size_t>()] = 0; });
  Json left = Json::array();
  for (std::size_t a = 0; a < number.size(); ++a) {
    if (number[a] == none) continue;
    number[a] = left.size();
    left.push_back(std::move(json["accessors"][a]));
  }
  each_accessor_named(json, [&](Json& named) { named = number[named.get<std::size_t>()]; });
  if (left.empty()) {
    json.erase("accessors");
  } else {
    json["accessors"] = std::move(left);
  }
}

}  // namespace foredraw::gltf
