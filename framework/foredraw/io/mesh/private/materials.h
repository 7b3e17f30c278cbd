#pragma once
// What an OBJ's material libraries say, for the scene and for glTF. Private to io.

#include <foredraw/io/gltf/private/source.h>

namespace foredraw::mesh_files {

struct MaterialLibrary {
  std::vector<Material> materials;
  std::vector<Image> images;
  gltf::Json json = gltf::Json::array();  ///< the materials as glTF says them; their textures have the images' numbers
};

/// Reads the libraries that lie in the folder. What can not be read, or leads out of it, is left out with a warning.
MaterialLibrary read_libraries(const std::vector<std::string>& names, const std::string& obj,
                               const std::filesystem::path& folder, Diagnostics& diagnostics);

/// A document that holds nothing but the scene's materials and images, for the glTF writer to add the rest to.
/// Materials that the libraries do not hold are names alone, with a warning.
std::shared_ptr<const gltf::Source> gltf_source_of(gltf::Json materials, Scene& scene,
                                                   const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace foredraw::mesh_files
