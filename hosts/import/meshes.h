#pragma once
#include "glb.h"
#include "told.h"

#include <assimp/scene.h>

namespace foredraw::import {

/// A mesh of the asset with a primitive for each kind that the mesh has: triangles, lines, points. Corners stay in the
/// file's order. `has_weights`: the scene says how far morph targets are blended at rest; else they are not.
/// `is_relative`: morph targets hold differences and no places. Throws std::runtime_error at numbers that are not
/// finite.
std::size_t add_mesh(const aiScene& scene, const aiMesh& mesh, bool has_weights, bool is_relative, bool is_skinned,
                     Glb& glb, Told& told);

/// JOINTS_n and WEIGHTS_n of a mesh with bones, four to a set. `still`: the joint of vertices that no bone moves.
void add_weights(const aiMesh& mesh, std::uint16_t still, nlohmann::json& attributes, Glb& glb);

}  // namespace foredraw::import
