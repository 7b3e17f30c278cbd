#pragma once
// A glTF document that grows, and becomes a .glb.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace foredraw::bench {

class GltfDocument {
 public:
  using Json = nlohmann::ordered_json;

  Json json = {{"asset", {{"version", "2.0"}, {"generator", "foredraw"}}}};

  /// Each of these returns the new number. A view has the "byteStride" and the "target" of `like`.
  std::size_t add(const char* kind, Json value);
  std::size_t add_view(std::span<const std::byte> bytes, const Json& like = {});

  /// Values in a view of their own: {0, 0, 0, 1, 0, 0} as "VEC3". `target`: 34962 of vertices, 34963 of indices, 0.
  template <class T>
  std::size_t add_values(std::span<const T> values, const char* type, int target = 0) {
    const std::size_t view = add_view(std::as_bytes(values), target == 0 ? Json() : Json{{"target", target}});
    return add("accessors", {{"bufferView", view},
                             {"componentType", component_type<T>()},
                             {"count", values.size() / components(type)},
                             {"type", type}});
  }

  /// As above, with the least and the greatest of each component.
  std::size_t add_bounded(std::span<const float> values, const char* type, int target = 0);

  /// The number of what has this content, added unless it was. Its name does not count.
  std::size_t add_once(const char* kind, const Json& value);

  /// An image with these bytes in a view, added unless one with the same bytes was; `image` says what else it is.
  std::size_t add_image(std::span<const std::byte> bytes, Json image);

  std::vector<std::byte> glb() const;

  /// A file taken apart; it has one buffer. Throws std::runtime_error where that fails.
  struct Opened {
    std::string name;  ///< of the file, for messages
    Json json;
    std::vector<std::byte> buffer;

    /// What a view holds; throws std::runtime_error where it does not lie in the buffer.
    std::span<const std::byte> view(std::size_t number) const;
  };
  static Opened opened(const std::filesystem::path& file);

 private:
  template <class T>
  static constexpr int component_type() {
    if constexpr (std::is_same_v<T, float>) return 5126;
    if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
    return 5125;
  }

  static std::size_t components(std::string_view type) {
    return type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
  }

  std::vector<std::byte> bin_;
  std::map<std::string, std::size_t> once_;  ///< kind and content without its name: the number
};

/// The bytes of a file. Throws std::runtime_error where it can not be read.
std::vector<std::byte> contents(const std::filesystem::path& path);

}  // namespace foredraw::bench
