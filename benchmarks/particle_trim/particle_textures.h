#pragma once
// The particle textures of the corpus.

#include <foredraw/scene/texture.h>
#include <plugins/processors/particle_trim/particle_trim.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::bench {

/// Single sprites as images, atlases as the lists of their frames; by name.
std::vector<std::filesystem::path> particle_files();

struct ParticleTexture {
  std::string name;
  Texels texels;
  std::vector<TrimFrame> frames;
};

/// Throws std::runtime_error where it can not be read.
ParticleTexture particle_texture(const std::filesystem::path& file);

/// Like sprites that are read from files: blended, and clamped at the edges.
inline constexpr Sampling particle_sampling{{Wrap::clamped, Wrap::clamped}, false};

}  // namespace foredraw::bench
