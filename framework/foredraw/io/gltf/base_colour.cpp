#include <foredraw/io/gltf/private/base_colour.h>

#include <algorithm>
#include <type_traits>

namespace foredraw::gltf {

namespace {

/// A number at a place in an array or object, where there is one.
template <class Key>
double number_in(const Json& holder, const Key& key, double otherwise) {
  if constexpr (std::is_integral_v<Key>) {
    return holder.is_array() && holder.size() > key && holder[key].is_number() ? holder[key].template get<double>()
                                                                               : otherwise;
  } else {
    const auto found = holder.find(key);
    return found != holder.end() && found->is_number() ? found->template get<double>() : otherwise;
  }
}

std::uint32_t texcoord_in(const Json& holder, std::uint32_t otherwise) {
  return static_cast<std::uint32_t>(std::clamp(number_in(holder, "texCoord", otherwise), 0.0, 1e6));
}

const Json& member(const Json& holder, const char* key) {
  static const Json nothing = Json::object();
  const auto found = holder.find(key);
  return found == holder.end() ? nothing : *found;
}

glm::dvec2 pair_in(const Json& holder, const char* key, double otherwise) {
  const Json& pair = member(holder, key);
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
    const Json& source = member(*holder, "source");
    if (source.is_number_unsigned() && source.get<std::size_t>() < member(document, "images").size())
      return source.get<ImageId>();
  }
  return std::nullopt;
}

Texture texture_of(const Json& use, const Json& document) {
  const Json& texture = document["textures"][use["index"].get<std::size_t>()];
  Texture made;
  made.image = image_of(texture, document);
  made.texcoord = texcoord_in(use, 0);
  if (const Json& number = member(texture, "sampler"); number.is_number()) {
    const Json& sampler = document["samplers"][number.get<std::size_t>()];
    made.wrap = {wrap_of(sampler, "wrapS"), wrap_of(sampler, "wrapT")};
    made.is_nearest = number_in(sampler, "magFilter", 9729) == 9728;
  }
  if (const Json* transform = extension_of(use, "KHR_texture_transform"); transform && transform->is_object()) {
    made.scale = pair_in(*transform, "scale", 1);
    made.rotation = number_in(*transform, "rotation", 0);
    made.offset = pair_in(*transform, "offset", 0);
    made.texcoord = texcoord_in(*transform, made.texcoord);
  }
  return made;
}

}  // namespace

void add_base_colour(Material& material, const Json& from, const Json& document) {
  const Json& surface = member(from, "pbrMetallicRoughness");
  const Json& factor = member(surface, "baseColorFactor");
  for (int i = 0; i < 3; ++i) {
    material.colour[i] = static_cast<float>(number_in(factor, static_cast<std::size_t>(i), 1));
  }
  material.alpha = static_cast<float>(number_in(factor, std::size_t{3}, 1));
  if (const Json& use = member(surface, "baseColorTexture"); use.contains("index")) {
    material.base_colour = texture_of(use, document);
  }
  if (const Json& use = member(from, "normalTexture"); use.contains("index")) {
    material.normal_map = texture_of(use, document);
    material.normal_scale = static_cast<float>(number_in(use, "scale", 1));
  }
}

}  // namespace foredraw::gltf
