#include <foredraw/io/gltf/private/material_textures.h>

#include <algorithm>

namespace foredraw::gltf {

const Json& object_in(const Json& holder, const char* key) {
  static const Json nothing = Json::object();
  const auto found = holder.find(key);
  return found == holder.end() ? nothing : *found;
}

namespace {

std::uint32_t texcoord_in(const Json& holder, std::uint32_t otherwise) {
  return static_cast<std::uint32_t>(std::clamp(number_in(holder, "texCoord", otherwise), 0.0, 1e6));
}

glm::dvec2 pair_in(const Json& holder, const char* key, double otherwise) {
  const Json& pair = object_in(holder, key);
  return {number_in(pair, std::size_t{0}, otherwise), number_in(pair, std::size_t{1}, otherwise)};
}

Wrap wrap_of(const Json& sampler, const char* key) {
  const double word = number_in(sampler, key, 10497);
  return word == 33071 ? Wrap::clamped : word == 33648 ? Wrap::mirrored : Wrap::repeat;
}

/// That which every viewer can show comes first; without it, the one that an extension names.
std::optional<ImageId> image_of(const Json& texture, const Json& document) {
  const Json* holders[] = {&texture, extension_of(texture, "KHR_texture_basisu"),
                           extension_of(texture, "EXT_texture_webp"), extension_of(texture, "EXT_texture_avif"),
                           extension_of(texture, "MSFT_texture_dds")};
  for (const Json* holder : holders) {
    if (holder == nullptr || !holder->is_object()) continue;
    const Json& source = object_in(*holder, "source");
    if (source.is_number_unsigned() && source.get<std::size_t>() < object_in(document, "images").size())
      return source.get<ImageId>();
  }
  return std::nullopt;
}

int word(Wrap wrap) { return wrap == Wrap::clamped ? 33071 : wrap == Wrap::mirrored ? 33648 : 10497; }

}  // namespace

std::optional<Texture> texture_of(const Json& use, const Json& document) {
  if (!use.contains("index")) return std::nullopt;
  const Json& texture = document["textures"][use["index"].get<std::size_t>()];
  Texture made;
  made.image = image_of(texture, document);
  if (const Json& number = object_in(texture, "sampler"); number.is_number()) {
    const Json& sampler = document["samplers"][number.get<std::size_t>()];
    made.wrap = {wrap_of(sampler, "wrapS"), wrap_of(sampler, "wrapT")};
    made.is_nearest = number_in(sampler, "magFilter", 9729) == 9728;
  }
  add_place(made, use);
  return made;
}

void add_place(Texture& texture, const Json& use) {
  texture.texcoord = texcoord_in(use, 0);
  const Json* transform = extension_of(use, texture_transform);
  if (transform == nullptr || !transform->is_object()) return;
  texture.scale = pair_in(*transform, "scale", 1);
  texture.rotation = number_in(*transform, "rotation", 0);
  texture.offset = pair_in(*transform, "offset", 0);
  texture.texcoord = texcoord_in(*transform, texture.texcoord);
}

bool differ_in_place_alone(const Texture& a, const Texture& b) {
  Texture moved = a;
  moved.scale = b.scale;
  moved.rotation = b.rotation;
  moved.offset = b.offset;
  return a != b && moved == b;
}

void put_place(const Texture& texture, Json& use) {
  Json& transform = use["extensions"][texture_transform];
  if (!transform.is_object()) transform = Json::object();
  transform["offset"] = {texture.offset.x, texture.offset.y};
  if (texture.rotation != number_in(transform, "rotation", 0)) transform["rotation"] = texture.rotation;
  transform["scale"] = {texture.scale.x, texture.scale.y};
}

Json texture_use(const Texture& texture, Json& document) {
  const int filter = texture.is_nearest ? 9728 : 9729;
  const Json sampler = JsonObject{
      {"magFilter", filter}, {"minFilter", filter}, {"wrapS", word(texture.wrap[0])}, {"wrapT", word(texture.wrap[1])}};
  const std::size_t number = listed(document["samplers"], sampler);
  Json use =
      JsonObject{{"index", listed(document["textures"], JsonObject{{"sampler", number}, {"source", *texture.image}})}};
  if (texture.texcoord != 0) use["texCoord"] = texture.texcoord;
  if (texture.scale != glm::dvec2(1) || texture.rotation != 0 || texture.offset != glm::dvec2(0)) {
    put_place(texture, use);
    listed(document["extensionsUsed"], texture_transform);
  }
  return use;
}

}  // namespace foredraw::gltf
