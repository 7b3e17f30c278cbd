#pragma once
// What an OBJ's material libraries say, for the scene and for glTF. Private to io.

#include <foredraw/io/gltf/private/source.h>
#include <foredraw/io/reading/faults.h>
#include <foredraw/io/text/private/file_beside.h>

namespace foredraw::mesh_files {

struct MaterialLibrary {
  std::vector<Material> materials;
  std::vector<Image> images;
  Json json = Json::array();  ///< the materials as glTF says them; their textures have the images' numbers
};

/// Reads the libraries that `where` allows. What is missing, or leads out of there, is left out: a fault.
MaterialLibrary read_libraries(const std::vector<std::string>& names, const std::string& obj, const FilePlaces& where,
                               Faults& faults, Diagnostics& diagnostics);

/// A document that holds nothing but the scene's materials and images, for the glTF writer to add the rest to.
/// Materials that the libraries do not hold are names alone: a fault.
std::shared_ptr<const gltf::Source> gltf_source_of(Json materials, Scene& scene, const std::filesystem::path& folder,
                                                   Faults& faults);

}  // namespace foredraw::mesh_files
