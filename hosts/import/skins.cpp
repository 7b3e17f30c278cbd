#include "skins.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace foredraw::import {

namespace {

/// glTF writes columns, Assimp rows.
void put_columns(const aiMatrix4x4& matrix, std::vector<float>& into) {
  for (unsigned column = 0; column < 4; ++column) {
    for (unsigned row = 0; row < 4; ++row) into.push_back(row < 3 ? matrix[row][column] : column < 3 ? 0.0f : 1.0f);
  }
}

bool bones_move_all(const aiMesh& mesh) {
  std::vector<bool> moved(mesh.mNumVertices, false);
  for (unsigned i = 0; i < mesh.mNumBones; ++i) {
    const aiBone& bone = *mesh.mBones[i];
    for (unsigned k = 0; k < bone.mNumWeights; ++k) {
      const aiVertexWeight& one = bone.mWeights[k];
      if (one.mVertexId < mesh.mNumVertices && one.mWeight > 0 && std::isfinite(one.mWeight))
        moved[one.mVertexId] = true;
    }
  }
  return std::ranges::find(moved, false) == moved.end();
}

}  // namespace

std::optional<std::size_t> add_skin(const aiMesh& mesh, std::size_t own, const aiMatrix4x4& of_geometry,
                                    const NodeNumbers& nodes, Glb& glb) {
  nlohmann::json joints = nlohmann::json::array();
  std::vector<float> inverse;
  for (unsigned i = 0; i < mesh.mNumBones; ++i) {
    const auto node = nodes.by_name.find(mesh.mBones[i]->mName.C_Str());
    if (node == nodes.by_name.end()) return std::nullopt;
    joints.push_back(node->second);
    put_columns(mesh.mBones[i]->mOffsetMatrix * of_geometry, inverse);
  }
  if (!bones_move_all(mesh)) {
    joints.push_back(own);
    put_columns(aiMatrix4x4(), inverse);
  }
  return glb.add("skins", {{"joints", joints}, {"inverseBindMatrices", glb.add_floats(inverse, "MAT4", 16, 0)}});
}

}  // namespace foredraw::import
