#pragma once
// Small glTF files put together on the spot. The JSON stays open, for whatever a test wants to say or to break.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace foredraw::testing {

using GltfJson = nlohmann::ordered_json;

class GltfBuilder {
 public:
  GltfJson json = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::byte> buffer;

  /// Each of these returns the new number.
  std::size_t add(const char* kind, GltfJson value);
  std::size_t add_view(std::span<const std::byte> bytes, std::size_t stride = 0);
  std::size_t add_accessor(std::size_t view, std::size_t offset, int component_type, const std::string& type,
                           std::size_t count);

  /// Values in a view of their own: {0, 0, 0, 1, 0, 0} as "VEC3".
  template <class T>
  std::size_t add_values(const std::vector<T>& values, const std::string& type) {
    const std::size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
    const std::size_t view = add_view(std::as_bytes(std::span(values)));
    return add_accessor(view, 0, component_type<T>(), type, values.size() / components);
  }

  /// A mesh with one primitive, and a node that draws it.
  std::size_t add_mesh(GltfJson primitive);

  std::vector<std::byte> glb() const;
  std::vector<std::byte> gltf() const;  ///< the buffer as a data URI

 private:
  template <class T>
  static constexpr int component_type() {
    if constexpr (std::is_same_v<T, float>) return 5126;
    if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    return 5125;
  }
};

/// The chunks of a GLB, as bytes: for tests that want them wrong.
std::vector<std::byte> glb_of(const std::string& json, std::span<const std::byte> bin);

/// A strip of `squares` squares, two triangles each, in the xy plane, with TEXCOORD_0 and 16-bit indices.
GltfBuilder ribbon(std::size_t squares);

/// A little of everything that the checks look at: a skinned, morphed, textured ribbon that an animation moves.
GltfBuilder puppet();

std::vector<std::byte> bytes_of(const std::string& text);

/// The JSON of a .glb or .gltf.
GltfJson json_of(std::span<const std::byte> file);

}  // namespace foredraw::testing
