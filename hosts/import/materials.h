#pragma once
#include "confined_files.h"
#include "glb.h"

#include <assimp/scene.h>

namespace foredraw::import {

/// Every material, in the scene's order, with its textures. What is no metal and roughness model is brought near it:
/// diffuse is the base colour, nothing is metal, and shininess s has the roughness sqrt(2 / (s + 2)). In FBX a picture
/// takes the colour's place, and is not multiplied by it.
void add_materials(const aiScene& scene, const ConfinedFiles& files, Glb& glb, Told& told);

/// The material of a mesh, once they are added: where it looks up texture coordinates that the mesh lacks, which glTF
/// forbids, one without these textures.
std::size_t material_for(const aiMesh& mesh, Glb& glb, Told& told);

}  // namespace foredraw::import
