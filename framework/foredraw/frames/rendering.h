#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace foredraw {

/// By which algorithm a surface is shaded: R in (object, level, rendering).
enum class Rendering : std::uint8_t {
  full,                ///< lit for each pixel, with the normal map
  without_normal_map,  ///< lit for each pixel, by the vertices' normals
  unlit,               ///< the base colour alone
};

inline constexpr std::array all_renderings = {Rendering::full, Rendering::without_normal_map, Rendering::unlit};

constexpr std::string_view to_text(Rendering rendering) {
  switch (rendering) {
    case Rendering::full: return "full";
    case Rendering::without_normal_map: return "without-normal-map";
    case Rendering::unlit: break;
  }
  return "unlit";
}

}  // namespace foredraw
