#pragma once
// The textures of materials, to and from JSON. What is no number where one should be counts as absent.

#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/texture.h>

#include <type_traits>

namespace foredraw::gltf {

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

/// An object of that name; an empty one where there is none.
const Json& object_in(const Json& holder, const char* key);

inline constexpr const char* texture_transform = "KHR_texture_transform";

/// From the JSON of a use ("baseColorTexture") and the whole document's, which the gate has checked. None where the use
/// has no texture.
std::optional<Texture> texture_of(const Json& use, const Json& document);

/// The set of coordinates of a use, and what becomes of them (KHR_texture_transform, whose own set is the one that
/// counts), put into the texture and into the use. What the transform says besides stays, as does its set; the
/// extension is not listed.
void add_place(Texture& texture, const Json& use);
void put_place(const Texture& texture, Json& use);

/// Whether they are the same image, looked up by the same set, and other places of it.
bool differ_in_place_alone(const Texture& a, const Texture& b);

/// The JSON of a use of a texture that has an image. Whatever the document lists may move in memory: the texture and
/// its sampler are put there, but for those that are there already.
Json texture_use(const Texture& texture, Json& document);

}  // namespace foredraw::gltf
