#include "particle_textures.h"

#include "support/meshes.h"

#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace fs = std::filesystem;

std::vector<fs::path> particle_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(testing::project_file("benchmarks/corpus/particles"))) {
    const fs::path list = fs::path(entry.path()).replace_extension(".json");
    if (entry.path() == list || !fs::exists(list)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

ParticleTexture particle_texture(const fs::path& file) {
  Diagnostics diagnostics;
  const auto read = read_scene(file.string(), diagnostics);
  if (!read) throw std::runtime_error(to_text(diagnostics));
  ParticleTexture texture{file.stem().string(), {}, {}};
  auto texels = image_decoder(file)(read->scene.images.at(0));
  if (const std::string* why = std::get_if<std::string>(&texels)) throw std::runtime_error(file.string() + ": " + *why);
  texture.texels = std::move(std::get<Texels>(texels));
  for (const Draw& draw : read->scene.draws) {
    const processors::particle_trim::Point corner{draw.frame->x * steps_per_texel, draw.frame->y * steps_per_texel};
    const processors::particle_trim::Point size{draw.frame->width * steps_per_texel,
                                                draw.frame->height * steps_per_texel};
    texture.frames.push_back({corner, corner + size});
  }
  return texture;
}

}  // namespace foredraw::bench
