#include "materials.h"

#include "axes.h"
#include "textures.h"

#include <assimp/material.h>

#include <algorithm>
#include <cmath>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;

int wrap_of(aiTextureMapMode mode) {
  constexpr int repeat = 10497, clamp = 33071, mirror = 33648;
  return mode == aiTextureMapMode_Mirror                                    ? mirror
         : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? clamp
                                                                            : repeat;
}

/// The first texture of a kind; null: there is none.
Json texture_of(const aiMaterial& material, aiTextureType kind, Textures& textures) {
  aiString path;
  unsigned channel = 0;
  aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  if (material.GetTexture(kind, 0, &path, nullptr, &channel, nullptr, nullptr, modes) != aiReturn_SUCCESS) return {};
  const auto number = textures.texture(path.C_Str(), wrap_of(modes[0]), wrap_of(modes[1]));
  if (!number) return {};
  Json info{{"index", *number}};
  if (channel != 0) info["texCoord"] = channel;
  return info;
}

float within_one(float value, float otherwise) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

Json material_of(const aiMaterial& from, bool picture_is_colour, Textures& textures) {
  Json material{{"name", from.GetName().C_Str()}};
  aiColor4D base(1, 1, 1, 1);
  if (from.Get(AI_MATKEY_BASE_COLOR, base) != aiReturn_SUCCESS) from.Get(AI_MATKEY_COLOR_DIFFUSE, base);
  float opacity = 1, metallic = 0, roughness = 1, shininess = 0;
  from.Get(AI_MATKEY_OPACITY, opacity);
  from.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
  if (from.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) != aiReturn_SUCCESS &&
      from.Get(AI_MATKEY_SHININESS, shininess) == aiReturn_SUCCESS && shininess > 0) {
    roughness = std::sqrt(2 / (shininess + 2));
  }
  opacity = within_one(opacity, 1);
  Json pbr;
  Json picture = texture_of(from, aiTextureType_BASE_COLOR, textures);
  if (picture.is_null()) picture = texture_of(from, aiTextureType_DIFFUSE, textures);
  if (!picture.is_null()) {
    pbr["baseColorTexture"] = picture;
    if (picture_is_colour) base = aiColor4D(1, 1, 1, 1);
  }
  pbr["baseColorFactor"] = {within_one(base.r, 1), within_one(base.g, 1), within_one(base.b, 1), opacity};
  pbr["metallicFactor"] = within_one(metallic, 0);
  pbr["roughnessFactor"] = within_one(roughness, 1);
  material["pbrMetallicRoughness"] = pbr;
  const bool has_alpha = !picture.is_null() && from.GetTextureCount(aiTextureType_OPACITY) != 0;
  if (opacity < 1 || has_alpha) material["alphaMode"] = "BLEND";

  if (const Json normals = texture_of(from, aiTextureType_NORMALS, textures); !normals.is_null()) {
    material["normalTexture"] = normals;
  }
  aiColor3D emitted(0, 0, 0);
  from.Get(AI_MATKEY_COLOR_EMISSIVE, emitted);
  const Json glow = texture_of(from, aiTextureType_EMISSIVE, textures);
  if (!glow.is_null()) {
    material["emissiveTexture"] = glow;
    if (emitted.IsBlack()) emitted = aiColor3D(1, 1, 1);
  }
  if (!emitted.IsBlack()) {
    material["emissiveFactor"] = {within_one(emitted.r, 0), within_one(emitted.g, 0), within_one(emitted.b, 0)};
  }
  int two_sided = 0;
  if (from.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS && two_sided != 0) material["doubleSided"] = true;
  return material;
}

}  // namespace

void add_materials(const aiScene& scene, const ConfinedFiles& files, Glb& glb, Told& told) {
  Textures textures(scene, files, glb, told);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i)
    glb.add("materials", material_of(*scene.mMaterials[i], is_fbx(scene), textures));
}

}  // namespace foredraw::import
