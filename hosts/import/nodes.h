#pragma once
#include "glb.h"
#include "told.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

namespace foredraw::import {

struct NodeNumbers {
  std::map<std::string, std::size_t> by_name;  ///< of several of a name the first that bears no mesh
  std::map<std::string, std::vector<std::size_t>>
      morphs;  ///< nodes that bear a mesh with targets, by its name and theirs
};

/// Nodes in the file's order, where the first one has the transform `of_root`; meshes that several nodes name are
/// instances of one. A node with several meshes bears them in nodes below itself. FBX files may call a bone as they
/// call the mesh that it moves: animations and skins then mean the bone.
NodeNumbers add_nodes(const aiScene& scene, const aiMatrix4x4& of_root, Glb& glb, Told& told);

}  // namespace foredraw::import
