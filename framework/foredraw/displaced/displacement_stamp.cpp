#include <foredraw/displaced/displacement_stamp.h>

#include <array>

namespace foredraw {

Stamp stamp_of(const Displacement& displacement) {
  const Texture& texture = displacement.texture;
  const std::array<double, 12> numbers = {
      displacement.factor,        displacement.offset,     texture.image ? *texture.image : -1.0,
      double(texture.texcoord),   double(texture.wrap[0]), double(texture.wrap[1]),
      double(texture.is_nearest), texture.scale.x,         texture.scale.y,
      texture.rotation,           texture.offset.x,        texture.offset.y};
  return content_hash(std::span<const double>(numbers));
}

}  // namespace foredraw
