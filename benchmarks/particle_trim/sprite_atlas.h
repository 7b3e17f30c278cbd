#pragma once
// A large atlas to time trimming on.

#include "particle_textures.h"

namespace foredraw::bench {

/// 4096 x 4096 texels, RGBA of 8 bits: 64 tiles, the single sprites of the corpus over and over, each time turned or
/// mirrored in another way, so that no two tiles are equal. Throws std::runtime_error where one can not be read.
Texels sprite_atlas(const std::filesystem::path& folder);

/// Its tiles.
inline const ParticleTexture sprite_atlas_grid{"generated_atlas", 8, 8};

}  // namespace foredraw::bench
