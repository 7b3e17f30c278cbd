#pragma once
#include <foredraw/analysis/analyses.h>
#include <foredraw/runtime/displaced_height.h>
#include <foredraw/scene/texture.h>
#include <foredraw/scene/vertex_streams.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foredraw {

/// The first channel of an image as heights: 0 to 65535, rows from the top. At most 65536 texels wide and high.
struct HeightMap {
  static constexpr std::string_view name = "height-map";

  std::uint32_t width = 1, height = 1;
  std::vector<std::uint16_t> texels;

  std::size_t bytes() const { return texels.size() * sizeof(std::uint16_t); }
};

/// 8 bits are multiplied by 257. Floats are clamped to 0 to 1 and rounded to 1/65535; what is no number is 0.
HeightMap height_map(const Texels& texels);

/// Decoded once and kept. Or why it cannot be: the rest of a sentence.
std::variant<std::shared_ptr<const HeightMap>, std::string> height_map_of(Analyses& analyses, const Image& image);

/// The map as the texture samples it, for the runtime's functions. It refers to the texels.
foredraw_height_map sampled(const HeightMap& map, const Texture& texture);

/// Where each vertex lies on the map: [vertex] along u and v, in 1/256 texel.
std::vector<std::array<std::int32_t, 2>> height_places(const VertexStream& texcoords, const Texture& texture,
                                                       const HeightMap& map);

}  // namespace foredraw
