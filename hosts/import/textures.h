#pragma once
#include "confined_files.h"
#include "glb.h"

#include <assimp/scene.h>

#include <map>
#include <optional>
#include <string>

namespace foredraw::import {

/// The images that materials name, each put into the asset once.
class Textures {
 public:
  Textures(const aiScene& scene, const ConfinedFiles& files, Glb& glb, Told& told)
      : scene_(scene), files_(files), glb_(glb), told_(told) {}

  /// The number of a glTF texture; nullopt, which is told, where there is no PNG, JPEG or TGA. A TGA becomes a PNG.
  /// `wrap_u`, `wrap_v`: as samplers of glTF say.
  std::optional<std::size_t> texture(const std::string& named, int wrap_u, int wrap_v);

 private:
  std::optional<std::size_t> image(const std::string& named);
  void leave_out(const std::string& named, const std::string& why, const std::string& hint);

  const aiScene& scene_;
  const ConfinedFiles& files_;
  Glb& glb_;
  Told& told_;
  std::map<std::string, std::optional<std::size_t>> images_;
  std::map<std::pair<int, int>, std::size_t> samplers_;
};

}  // namespace foredraw::import
