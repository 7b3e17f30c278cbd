#include "sprite_atlas.h"

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

Texels sprite_atlas(const std::filesystem::path& folder) {
  std::vector<Texels> sprites;
  for (const ParticleTexture& texture : particle_textures()) {
    if (texture.columns == 1) sprites.push_back(decoded(texture, folder));
  }
  Texels atlas;
  for (const Texels& sprite : sprites) {
    const ImageFacts& facts = sprite.facts;
    if (facts.width != side || facts.height != side || facts.channels != channels || facts.bits != 8) {
      throw std::runtime_error("single particle textures of the corpus have to be 512 x 512 texels of RGBA, 8 bits each");
    }
    atlas.facts = facts;
  }
  atlas.facts.width = atlas.facts.height = across * side;
  atlas.bytes.resize(across * across * side * side * channels);
  for (std::size_t tile = 0; tile < across * across; ++tile) {
    const Texels& sprite = sprites[tile % sprites.size()];
    const std::size_t way = tile / sprites.size();
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t x = 0; x < side; ++x) {
        const std::size_t to = ((tile / across * side + y) * across + tile % across) * side + x;
        std::copy_n(&sprite.bytes[source_texel(x, y, way) * channels], channels, &atlas.bytes[to * channels]);
      }
    }
  }
  return atlas;
}

}  // namespace foredraw::bench
