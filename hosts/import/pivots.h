#pragma once
#include <assimp/scene.h>

#include <optional>
#include <set>
#include <string>

namespace foredraw::import {

/// Assimp makes a node for each pivot, offset and extra rotation of an FBX node "hip": "hip_$AssimpFbx$_PreRotation"
/// and others, one below the other, and last "hip" itself, with its meshes and children.
struct StillPivots {
  const aiNode* node = nullptr;  ///< the last one
  aiMatrix4x4 of_node;           ///< all before it, but those of its geometry
  aiMatrix4x4 of_geometry;       ///< those, which move its meshes and, with their inverses, no children
};

/// The pivots that begin at a node, if no animation moves one of them. They have to be joined then: an animation of the
/// node, if there is one, holds them all, and takes their place.
std::optional<StillPivots> still_pivots(const aiNode& first, const std::set<std::string>& moved);

}  // namespace foredraw::import
