#include "relief.h"

#include <foredraw/displaced/height_map.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace foredraw::processors::vertex_pack {

namespace {

constexpr double per_height = 1.0 / 65535;

/// Of heights from 0 to 1, for the whole width and height of the map.
double steepest(const HeightMap& map) {
  const auto at = [&](std::size_t x, std::size_t y) { return static_cast<int>(map.texels[y * map.width + x]); };
  int along = 0, up = 0;
  for (std::size_t y = 0; y < map.height; ++y) {
    for (std::size_t x = 0; x < map.width; ++x) {
      if (x + 1 < map.width) along = std::max(along, std::abs(at(x + 1, y) - at(x, y)));
      if (y + 1 < map.height) up = std::max(up, std::abs(at(x, y + 1) - at(x, y)));
    }
  }
  const double across = along * per_height * map.width, down = up * per_height * map.height;
  return std::sqrt(across * across + down * down);
}

}  // namespace

std::optional<Relief> relief_of(const Scene& scene, DrawId draw, Analyses& analyses) {
  const Material* material = scene.material_of(scene.draws[draw]);
  if (material == nullptr || !material->displacement) return std::nullopt;
  const double factor = static_cast<double>(material->displacement->factor);
  const double offset = static_cast<double>(material->displacement->offset);
  const Texture& texture = material->displacement->texture;
  Relief relief{std::max(std::abs(offset), std::abs(offset + factor))};
  if (!std::isfinite(relief.displacement)) return std::nullopt;
  if (!texture.image || *texture.image >= scene.images.size()) return relief;
  const auto map = height_map_of(analyses, scene.images[*texture.image]);
  const auto* heights = std::get_if<std::shared_ptr<const HeightMap>>(&map);
  if (heights == nullptr || (*heights)->texels.empty()) return relief;
  const auto [lowest, highest] = std::ranges::minmax((*heights)->texels);
  relief.displacement =
      std::max(std::abs(offset + factor * lowest * per_height), std::abs(offset + factor * highest * per_height));
  const double scale = std::max(std::abs(texture.scale.x), std::abs(texture.scale.y));
  if (const double slope = std::abs(factor) * steepest(**heights) * scale; std::isfinite(slope)) relief.slope = slope;
  return relief;
}

}  // namespace foredraw::processors::vertex_pack
