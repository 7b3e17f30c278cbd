#include "particle_textures.h"

#include <foredraw/io/images.h>
#include <foredraw/platform/files.h>

#include <stdexcept>

namespace foredraw::bench {

std::vector<ParticleTexture> particle_textures() {
  return {
      {"atlas_godot_flipbook", 2, 2},
      {"atlas_playcanvas_bonus", 4, 2},  // nothing shows in the last one
      {"atlas_playcanvas_numbers", 4, 4},
      {"atlas_smoke15frames", 5, 3},
      {"kenney_dirt_03"},
      {"kenney_fire_01"},
      {"kenney_flame_02"},
      {"kenney_light_03"},
      {"kenney_magic_05"},
      {"kenney_muzzle_01"},
      {"kenney_scorch_02"},
      {"kenney_slash_02"},
      {"kenney_smoke_04"},
      {"kenney_spark_05"},
      {"kenney_star_09"},
      {"kenney_trace_04"},
      {"kenney_twirl_03"},
  };
}

Texels decoded(const ParticleTexture& texture, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  const std::string path = (folder / (texture.name + ".png")).string();
  const auto bytes = read_file(path, diagnostics);
  auto texels = bytes ? decode_image(*bytes, {path}, diagnostics) : std::nullopt;
  if (!texels) throw std::runtime_error(to_text(diagnostics));
  return std::move(*texels);
}

std::vector<TrimFrame> tiles(const ParticleTexture& texture, const ImageFacts& facts) {
  const std::int64_t width = facts.width * steps_per_texel / texture.columns;
  const std::int64_t height = facts.height * steps_per_texel / texture.rows;
  std::vector<TrimFrame> frames;
  for (int row = 0; row < texture.rows; ++row) {
    for (int column = 0; column < texture.columns; ++column) {
      const trim::Point corner{column * width, row * height};
      frames.push_back({corner, corner + trim::Point{width, height}});
    }
  }
  return frames;
}

}  // namespace foredraw::bench
