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

struct Making {
  bool is_fbx;
  Textures& textures;
  Told& told;
};

bool moves(const aiUVTransform& placed) {
  return placed.mTranslation != aiVector2D(0, 0) || placed.mScaling != aiVector2D(1, 1) || placed.mRotation != 0;
}

/// The first texture of a kind; null: there is none.
Json texture_of(const aiMaterial& material, aiTextureType kind, Making& making) {
  aiString path;
  unsigned channel = 0;
  aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  if (material.GetTexture(kind, 0, &path, nullptr, &channel, nullptr, nullptr, modes) != aiReturn_SUCCESS) return {};
  const auto number = making.textures.texture(path.C_Str(), wrap_of(modes[0]), wrap_of(modes[1]));
  if (!number) return {};
  Json info{{"index", *number}};
  if (channel != 0) info["texCoord"] = channel;
  aiUVTransform placed;
  if (making.is_fbx && material.Get(AI_MATKEY_UVTRANSFORM(kind, 0), placed) == aiReturn_SUCCESS && moves(placed)) {
    making.told.left_out.push_back("that the material '" + std::string(material.GetName().C_Str()) +
                                   "' tiles, moves or turns its texture '" + path.C_Str() +
                                   "' is left out\nput it into the texture coordinates of the meshes");
  }
  return info;
}

float within_one(float value, float otherwise) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

Json material_of(const aiMaterial& from, Making& making) {
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
  Json picture = texture_of(from, aiTextureType_BASE_COLOR, making);
  if (picture.is_null()) picture = texture_of(from, aiTextureType_DIFFUSE, making);
  if (!picture.is_null()) {
    pbr["baseColorTexture"] = picture;
    if (making.is_fbx) base = aiColor4D(1, 1, 1, 1);
  }
  pbr["baseColorFactor"] = {within_one(base.r, 1), within_one(base.g, 1), within_one(base.b, 1), opacity};
  pbr["metallicFactor"] = within_one(metallic, 0);
  pbr["roughnessFactor"] = within_one(roughness, 1);
  material["pbrMetallicRoughness"] = pbr;
  const bool has_alpha = !picture.is_null() && from.GetTextureCount(aiTextureType_OPACITY) != 0;
  if (opacity < 1 || has_alpha) material["alphaMode"] = "BLEND";

  if (const Json normals = texture_of(from, aiTextureType_NORMALS, making); !normals.is_null()) {
    material["normalTexture"] = normals;
  }
  aiColor3D emitted(0, 0, 0);
  from.Get(AI_MATKEY_COLOR_EMISSIVE, emitted);
  const Json glow = texture_of(from, aiTextureType_EMISSIVE, making);
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
  Making making{is_fbx(scene), textures, told};
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) glb.add("materials", material_of(*scene.mMaterials[i], making));
}

std::size_t material_for(const aiMesh& mesh, Glb& glb, Told& told) {
  const Json& materials = glb.json["materials"];
  Json material = materials[mesh.mMaterialIndex];
  const auto drops = [&](Json& from, const char* texture) {
    const auto at = from.find(texture);
    if (at == from.end() || at->value("texCoord", 0u) < mesh.GetNumUVChannels()) return false;
    from.erase(at);
    return true;
  };
  const bool drops_base = drops(material["pbrMetallicRoughness"], "baseColorTexture");
  const bool drops_normals = drops(material, "normalTexture");
  const bool drops_glow = drops(material, "emissiveTexture");
  if (!drops_base && !drops_normals && !drops_glow) return mesh.mMaterialIndex;
  if (drops_glow) material.erase("emissiveFactor");  // it may be there for the texture alone
  if (const auto same = std::ranges::find(materials, material); same != materials.end()) {
    return static_cast<std::size_t>(same - materials.begin());
  }
  told.left_out.push_back("textures of the material '" + material["name"].get<std::string>() +
                          "' are left out of the mesh '" + mesh.mName.C_Str() +
                          "' and of others like it: it has no texture coordinates for them");
  return glb.add("materials", std::move(material));
}

}  // namespace foredraw::import
