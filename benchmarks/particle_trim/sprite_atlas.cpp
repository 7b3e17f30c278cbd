#include "sprite_atlas.h"

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace {

constexpr std::size_t side = 512, across = 8, channels = 4;

/// One of the eight ways to lay a square on itself.
std::size_t source_texel(std::size_t x, std::size_t y, std::size_t way) {
  if (way & 1) x = side - 1 - x;
  if (way & 2) y = side - 1 - y;
  if (way & 4) std::swap(x, y);
  return y * side + x;
}

}  // namespace

ParticleTexture sprite_atlas(std::span<const ParticleTexture> textures) {
  constexpr ImageFacts sprite_facts{side, side, channels, 8, false};
  std::vector<const Texels*> sprites;
  for (const ParticleTexture& texture : textures) {
    if (texture.frames.size() > 1) continue;
    if (texture.texels.facts != sprite_facts) {
      throw std::invalid_argument(texture.name + ": the large atlas needs 512 x 512 texels of RGBA with 8 bits each");
    }
    sprites.push_back(&texture.texels);
  }
  ParticleTexture atlas{"generated_atlas", {{across * side, across * side, channels, 8, false}, {}}, {}};
  atlas.texels.bytes.resize(across * across * side * side * channels);
  for (std::size_t tile = 0; tile < across * across; ++tile) {
    const std::vector<std::byte>& sprite = sprites[tile % sprites.size()]->bytes;
    const std::size_t way = tile / sprites.size(), left = tile % across * side, up = tile / across * side;
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t x = 0; x < side; ++x) {
        const std::size_t to = (up + y) * across * side + left + x;
        std::copy_n(&sprite[source_texel(x, y, way) * channels], channels, &atlas.texels.bytes[to * channels]);
      }
    }
    constexpr std::int64_t steps = side * steps_per_texel;
    const processors::particle_trim::Point corner{static_cast<std::int64_t>(left) * steps_per_texel,
                                                  static_cast<std::int64_t>(up) * steps_per_texel};
    atlas.frames.push_back({corner, corner + processors::particle_trim::Point{steps, steps}});
  }
  return atlas;
}

}  // namespace foredraw::bench
