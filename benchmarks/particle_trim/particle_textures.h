#pragma once
// The particle textures of the corpus, and how atlases among them are cut.

#include <foredraw/scene/texture.h>
#include <plugins/processors/particle_trim/particle_trim.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foredraw::bench {

struct ParticleTexture {
  std::string name;  ///< of the file, without .png
  int columns = 1;
  int rows = 1;
};

/// By name.
std::vector<ParticleTexture> particle_textures();

/// As it lies in the folder. Throws std::runtime_error where it can not be read.
Texels decoded(const ParticleTexture& texture, const std::filesystem::path& folder);

/// Row after row. Every side can be divided.
std::vector<TrimFrame> tiles(const ParticleTexture& texture, const ImageFacts& facts);

/// Like sprites that are read from image files: blended, and clamped at the edges.
inline constexpr Sampling particle_sampling{{Wrap::clamped, Wrap::clamped}, false};

}  // namespace foredraw::bench
