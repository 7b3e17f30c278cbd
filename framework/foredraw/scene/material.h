#pragma once
#include <cstdint>
#include <string>

namespace foredraw {

using MaterialId = std::uint32_t;

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// What the order of triangles and the count of fragments depend on; the rest stays in the file it came from.
struct Material {
  std::string name;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
};

}  // namespace foredraw
