#pragma once
#include <assimp/scene.h>

namespace foredraw::import {

/// Whether a scene says its axes and its unit, as FBX files alone do.
bool is_fbx(const aiScene& scene);

/// What brings a scene into glTF's space, which is in metres, with Y up and Z to the viewer: the transform that its
/// root gets in place of the one that it has. An FBX file says its axes, and its unit in centimetres; Assimp hands on
/// both as metadata. Scenes of all other formats come in glTF's space already, and keep their root's transform.
aiMatrix4x4 transform_of_root(const aiScene& scene);

}  // namespace foredraw::import
