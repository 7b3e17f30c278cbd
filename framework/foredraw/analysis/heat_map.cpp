#include <foredraw/analysis/heat_map.h>

#include <foredraw/analysis/fragments.h>

namespace foredraw {

HeatMap heat_map(std::span<const RasterPart> parts, const View& view, int size) {
  constexpr std::uint32_t nothing = ~std::uint32_t{0};
  const auto edge = static_cast<std::size_t>(size);
  HeatMap map{size, std::vector<std::uint32_t>(edge * edge), {}};
  std::vector<std::uint32_t> depths(edge * edge, nothing);
  std::vector<Corner> corners;
  for (const PreparedPart& part : prepared(parts)) {
    for_each_fragment(
        part, Camera(view, size), corners, [&](std::int32_t x, std::int32_t y, std::uint32_t depth, std::uint32_t) {
          const std::size_t pixel = (edge - 1 - static_cast<std::size_t>(y)) * edge + static_cast<std::size_t>(x);
          if (depth == depths[pixel]) ++map.count.ties;
          if (depth >= depths[pixel]) return;
          if (depths[pixel] == nothing) ++map.count.visible;
          depths[pixel] = depth;
          ++map.times[pixel];
          ++map.count.shaded;
        });
  }
  return map;
}

}  // namespace foredraw
