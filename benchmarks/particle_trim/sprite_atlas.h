#pragma once
// A large atlas to time trimming on.

#include "particle_textures.h"

#include <span>

namespace foredraw::bench {

/// 4096 x 4096 texels, RGBA of 8 bits, 64 frames: the single sprites among the textures over and over, each time turned
/// or mirrored in another way, so that no two frames are equal. Throws std::invalid_argument where they are of other
/// sizes.
ParticleTexture sprite_atlas(std::span<const ParticleTexture> textures);

}  // namespace foredraw::bench
