#include "gltf_copier.h"

namespace foredraw::bench {

using Json = GltfDocument::Json;

std::size_t GltfCopier::mesh(std::size_t number, const std::string& name) {
  const auto [known, is_new] = meshes_.try_emplace(number, to_.json["meshes"].size());
  if (!is_new) return known->second;
  Json mesh = from_.json.at("meshes").at(number);
  mesh["name"] = name;
  for (Json& primitive : mesh.at("primitives")) {
    for (Json& attribute : primitive.at("attributes")) attribute = accessor(attribute.get<std::size_t>());
    if (primitive.contains("indices")) primitive["indices"] = accessor(primitive["indices"].get<std::size_t>());
    if (primitive.contains("material")) primitive["material"] = material(primitive["material"].get<std::size_t>());
  }
  to_.json["meshes"].push_back(std::move(mesh));
  return known->second;
}

std::size_t GltfCopier::accessor(std::size_t number) {
  const auto [known, is_new] = accessors_.try_emplace(number, 0);
  if (!is_new) return known->second;
  Json accessor = from_.json.at("accessors").at(number);
  accessor["bufferView"] = view(accessor.at("bufferView").get<std::size_t>());
  to_.json["accessors"].push_back(std::move(accessor));
  return known->second = to_.json["accessors"].size() - 1;
}

std::size_t GltfCopier::view(std::size_t number) {
  const auto [known, is_new] = views_.try_emplace(number, 0);
  if (is_new) known->second = to_.add_view(from_.view(number), from_.json["bufferViews"][number]);
  return known->second;
}

std::size_t GltfCopier::material(std::size_t number) {
  Json material = from_.json.at("materials").at(number);
  replace_textures(material);
  return to_.add_once("materials", material);
}

void GltfCopier::replace_textures(Json& value) {
  if (!value.is_structured()) return;
  for (const auto& [key, part] : value.items()) {
    const bool is_texture = value.is_object() && key.ends_with("Texture") && part.contains("index");
    if (is_texture) part["index"] = texture(part["index"].get<std::size_t>());
    replace_textures(part);
  }
}

std::size_t GltfCopier::texture(std::size_t number) {
  Json texture = from_.json.at("textures").at(number);
  if (texture.contains("source")) texture["source"] = image(texture["source"].get<std::size_t>());
  if (texture.contains("sampler")) {
    texture["sampler"] = to_.add_once("samplers", from_.json.at("samplers").at(texture["sampler"].get<std::size_t>()));
  }
  return to_.add_once("textures", texture);
}

std::size_t GltfCopier::image(std::size_t number) {
  Json image = from_.json.at("images").at(number);
  std::vector<std::byte> bytes;
  if (image.contains("uri")) {
    bytes = contents(folder_ / image["uri"].get<std::string>());
    image.erase("uri");
  } else {
    const auto held = from_.view(image.at("bufferView").get<std::size_t>());
    bytes.assign(held.begin(), held.end());
  }
  return to_.add_image(bytes, std::move(image));
}

void GltfCopier::list_extensions() {
  if (!from_.json.contains("extensionsUsed")) return;
  const std::string text = to_.json.dump();
  for (const Json& name : from_.json["extensionsUsed"]) {
    if (text.find(name.dump() + ":") != std::string::npos) to_.add_once("extensionsUsed", name);
  }
}

}  // namespace foredraw::bench
