#include "import_file.h"

#include "animations.h"
#include "axes.h"
#include "confined_files.h"
#include "glb.h"
#include "materials.h"
#include "nodes.h"
#include "refusals.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <new>
#include <stdexcept>

namespace foredraw::import {

std::string import_file(const std::filesystem::path& file, const std::filesystem::path& root, Told& told) {
  Assimp::Importer importer;
  auto* files = new ConfinedFiles(file, root, told);
  importer.SetIOHandler(files);  // which owns it
  // Pivots stay nodes: where they are multiplied into their node, its animation forgets them.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
  // Else scenes without meshes, as of animations alone, get some that show their bones.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_ValidateDataStructure);
  if (scene == nullptr) {
    const std::string why = importer.GetErrorString();
    if (why.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    throw std::runtime_error(reason_in(file).value_or(plain_words(why)));
  }
  // Of FBX, readers differ in what the transform of a texture is.
  if (!is_fbx(*scene)) scene = importer.ApplyPostProcessing(aiProcess_GenUVCoords | aiProcess_TransformUVCoords);
  if (scene == nullptr || scene->mRootNode == nullptr) throw std::runtime_error("it holds no nodes");
  if (scene->mNumMeshes == 0) throw std::runtime_error("it holds no meshes");
  Glb glb;
  add_materials(*scene, *files, glb, told);
  const NodeNumbers nodes = add_nodes(*scene, transform_of_root(*scene), glb, told);
  add_animations(*scene, nodes, is_fbx(*scene), glb, told);
  const bool has_lights = scene->mNumLights != 0, has_cameras = scene->mNumCameras != 0;
  if (has_lights || has_cameras) {
    told.left_out.push_back(std::string("its ") + (has_lights ? "lights" : "") +
                            (has_lights && has_cameras ? " and " : "") + (has_cameras ? "cameras" : "") +
                            " are left out");
  }
  return glb.bytes();
}

}  // namespace foredraw::import
