#pragma once
// A glTF asset that grows: its JSON, and the one buffer behind it.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::import {

/// Targets of buffer views.
inline constexpr int vertices = 34962, elements = 34963;

class Glb {
 public:
  Glb();

  nlohmann::json json;  ///< but for buffers, which bytes() writes

  /// Appends an object to a list of the asset, and says its number.
  std::size_t add(const char* list, nlohmann::json object);

  /// `target` is vertices, elements, or 0 for none.
  std::size_t add_view(std::span<const std::byte> bytes, int target = 0);
  /// Numbers of one component type, `width` to an element: "VEC3" of floats has 3. `with_bounds` gives min and max.
  std::size_t add_floats(const std::vector<float>& values, const char* type, std::size_t width, int target,
                         bool with_bounds = false);
  std::size_t add_joints(const std::vector<std::uint16_t>& values);
  std::size_t add_indices(const std::vector<std::uint32_t>& values);

  /// The whole file. Throws std::runtime_error where it is longer than a GLB may be.
  std::string bytes() const;

 private:
  std::string buffer_;
};

}  // namespace foredraw::import
