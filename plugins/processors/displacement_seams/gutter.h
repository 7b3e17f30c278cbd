#pragma once
// A gutter: what a chart says at its border, also beside it, for filters that read beyond it.

#include <foredraw/runtime/displaced_height.h>

#include <glm/vec2.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foredraw {

using UvTriangle = std::array<glm::dvec2, 3>;

/// Texels that no triangle reads get the mean of those neighbours, of eight, that one does or that have got theirs,
/// ring by ring, `width` times. What a triangle reads is, at most, what lies less than a texel from it along both axes;
/// those texels stay byte for byte. `texels`: the map's, which says size and wrapping alone. Triangles with a
/// coordinate that is not finite are passed over. Returns how many texels changed: a second time none. Once `cancel` is
/// set, what comes out is of no use, and comes soon. O(texels + width * ring).
std::size_t fill_gutter(std::span<std::uint16_t> texels, const foredraw_height_map& map,
                        std::span<const UvTriangle> triangles, int width, const std::atomic<bool>* cancel = nullptr);

}  // namespace foredraw
