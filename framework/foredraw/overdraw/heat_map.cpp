#include <foredraw/overdraw/heat_map.h>

#include <foredraw/overdraw/fragments.h>

namespace foredraw {

HeatMap heat_map(std::span<const RasterPart> parts, const View& view, int size) {
  constexpr std::uint32_t nothing = ~std::uint32_t{0};
  const auto edge = static_cast<std::size_t>(size);
  HeatMap map{size, std::vector<std::uint32_t>(edge * edge), {}};
  std::vector<std::uint32_t> depths(edge * edge, nothing);
  Rasteriser rasteriser;
  for (const PreparedPart& part : prepared(parts)) {
    rasteriser.draw(part, Camera(view, size), [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        const std::size_t y = some.pixels[i] / edge;
        const std::size_t pixel = (edge - 1 - y) * edge + some.pixels[i] % edge;
        if (some.depths[i] == depths[pixel]) ++map.count.ties;
        if (some.depths[i] >= depths[pixel]) continue;
        if (depths[pixel] == nothing) ++map.count.visible;
        depths[pixel] = some.depths[i];
        ++map.times[pixel];
        ++map.count.shaded;
      }
    });
  }
  return map;
}

}  // namespace foredraw
