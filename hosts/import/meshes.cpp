#include "meshes.h"

#include "materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;

std::vector<float> floats_of(const aiVector3D* from, const aiVector3D* minus, const aiMesh& mesh, const char* what) {
  std::vector<float> values;
  values.reserve(std::size_t{3} * mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D value = minus == nullptr ? from[i] : from[i] - minus[i];
    if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z)) {
      throw std::runtime_error("mesh '" + std::string(mesh.mName.C_Str()) + "': " + what + " " + std::to_string(i) +
                               " is not a finite number");
    }
    values.insert(values.end(), {value.x, value.y, value.z});
  }
  return values;
}

/// Of each vertex that of its last triangle with an area; where there is none, upwards.
std::vector<aiVector3D> normals_of_triangles(const aiMesh& mesh) {
  std::vector<aiVector3D> normals(mesh.mNumVertices, aiVector3D(0, 1, 0));
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const std::span<const unsigned> corners(mesh.mFaces[i].mIndices, mesh.mFaces[i].mNumIndices);
    const auto is_there = [&](unsigned corner) { return corner < mesh.mNumVertices; };
    if (corners.size() != 3 || !std::ranges::all_of(corners, is_there)) continue;
    const aiVector3D& first = mesh.mVertices[corners[0]];
    const aiVector3D normal = (mesh.mVertices[corners[1]] - first) ^ (mesh.mVertices[corners[2]] - first);
    const float length = normal.Length();
    if (!(length > 0) || !std::isfinite(length)) continue;
    for (const unsigned corner : corners) normals[corner] = normal / length;
  }
  return normals;
}

/// Of length 1, which glTF asks for; where the file has none, that of a triangle.
std::vector<float> normals_of(const aiMesh& mesh) {
  std::vector<float> values = floats_of(mesh.mNormals, nullptr, mesh, "normal");
  std::vector<aiVector3D> of_triangles;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    aiVector3D normal(values[i], values[i + 1], values[i + 2]);
    const float length = normal.Length();
    if (std::abs(length - 1) < 1e-5f) continue;
    if (length > 0 && std::isfinite(length)) {
      normal /= length;
    } else {
      if (of_triangles.empty()) of_triangles = normals_of_triangles(mesh);
      normal = of_triangles[i / 3];
    }
    for (unsigned k = 0; k < 3; ++k) values[i + k] = normal[k];
  }
  return values;
}

/// glTF's v grows downwards.
std::vector<float> coordinates_of(const aiMesh& mesh, unsigned set) {
  std::vector<float> values;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    values.insert(values.end(), {mesh.mTextureCoords[set][i].x, 1 - mesh.mTextureCoords[set][i].y});
  }
  return values;
}

/// glTF has colours from 0 to 1 alone.
std::vector<float> colours_of(const aiMesh& mesh, unsigned set, Told& told) {
  const float* first = &mesh.mColors[set][0].r;
  std::vector<float> values(first, first + std::size_t{4} * mesh.mNumVertices);
  bool is_any_beyond = false;
  for (float& value : values) {
    const float kept = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 1.0f;
    is_any_beyond = is_any_beyond || kept != value;
    value = kept;
  }
  if (is_any_beyond) {
    told.left_out.push_back("what colours of the mesh '" + std::string(mesh.mName.C_Str()) +
                            "' have below 0 or above 1 is left out");
  }
  return values;
}

Json attributes_of(const aiMesh& mesh, Glb& glb, Told& told) {
  Json attributes;
  attributes["POSITION"] =
      glb.add_floats(floats_of(mesh.mVertices, nullptr, mesh, "vertex"), "VEC3", 3, vertices, true);
  if (mesh.HasNormals()) attributes["NORMAL"] = glb.add_floats(normals_of(mesh), "VEC3", 3, vertices);
  for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set); ++set) {
    attributes["TEXCOORD_" + std::to_string(set)] = glb.add_floats(coordinates_of(mesh, set), "VEC2", 2, vertices);
  }
  for (unsigned set = 0; set < AI_MAX_NUMBER_OF_COLOR_SETS && mesh.HasVertexColors(set); ++set) {
    attributes["COLOR_" + std::to_string(set)] = glb.add_floats(colours_of(mesh, set, told), "VEC4", 4, vertices);
  }
  return attributes;
}

Json targets_of(const aiMesh& mesh, bool is_relative, Glb& glb) {
  Json targets = Json::array();
  for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) {
    const aiAnimMesh& to = *mesh.mAnimMeshes[i];
    if (to.mNumVertices != mesh.mNumVertices) throw std::runtime_error("a morph target has another number of vertices");
    std::vector<float> moved(std::size_t{3} * mesh.mNumVertices, 0.0f);
    if (to.HasPositions()) moved = floats_of(to.mVertices, is_relative ? nullptr : mesh.mVertices, mesh, "vertex");
    Json target{{"POSITION", glb.add_floats(moved, "VEC3", 3, vertices, true)}};
    if (to.HasNormals() && mesh.HasNormals()) {
      target["NORMAL"] = glb.add_floats(floats_of(to.mNormals, is_relative ? nullptr : mesh.mNormals, mesh, "normal"),
                                        "VEC3", 3, vertices);
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace

void add_weights(const aiMesh& mesh, std::uint16_t still, Json& attributes, Glb& glb) {
  struct Share {
    std::uint16_t joint;
    float weight;
  };
  std::vector<std::vector<Share>> shares(mesh.mNumVertices);
  for (unsigned bone = 0; bone < mesh.mNumBones; ++bone) {
    const aiBone& from = *mesh.mBones[bone];
    for (unsigned i = 0; i < from.mNumWeights; ++i) {
      const aiVertexWeight& one = from.mWeights[i];
      if (one.mVertexId >= mesh.mNumVertices || !(one.mWeight > 0) || !std::isfinite(one.mWeight)) continue;
      shares[one.mVertexId].push_back({static_cast<std::uint16_t>(bone), one.mWeight});
    }
  }
  std::size_t most = 1;
  for (auto& all : shares) {
    if (all.empty()) all.push_back({still, 1});
    float sum = 0;
    for (const Share& one : all) sum += one.weight;
    for (Share& one : all) one.weight /= sum;
    most = std::max(most, all.size());
  }
  for (std::size_t set = 0; 4 * set < most; ++set) {
    std::vector<std::uint16_t> joints(4 * shares.size());
    std::vector<float> weights(4 * shares.size());
    for (std::size_t v = 0; v < shares.size(); ++v) {
      for (std::size_t k = 0; k < 4 && 4 * set + k < shares[v].size(); ++k) {
        joints[4 * v + k] = shares[v][4 * set + k].joint;
        weights[4 * v + k] = shares[v][4 * set + k].weight;
      }
    }
    attributes["JOINTS_" + std::to_string(set)] = glb.add_joints(joints);
    attributes["WEIGHTS_" + std::to_string(set)] = glb.add_floats(weights, "VEC4", 4, vertices);
  }
}

std::size_t add_mesh(const aiScene& scene, const aiMesh& mesh, bool has_weights, bool is_relative, bool is_skinned,
                     Glb& glb, Told& told) {
  Json attributes = attributes_of(mesh, glb, told);
  if (is_skinned) add_weights(mesh, static_cast<std::uint16_t>(mesh.mNumBones), attributes, glb);
  const Json targets = targets_of(mesh, is_relative, glb);
  std::array<std::vector<std::uint32_t>, 3> corners;  // of points, lines, triangles
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 1 || face.mNumIndices > 3) continue;
    auto& into = corners[face.mNumIndices - 1];
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices) throw std::runtime_error("a face names a vertex that is not there");
      into.push_back(face.mIndices[k]);
    }
  }
  constexpr std::array<int, 3> modes{0, 1, 4};
  Json primitives = Json::array();
  for (std::size_t kind = 3; kind-- > 0;) {
    if (corners[kind].empty()) continue;
    Json primitive{{"attributes", attributes}, {"indices", glb.add_indices(corners[kind])}, {"mode", modes[kind]}};
    if (mesh.mMaterialIndex < scene.mNumMaterials) primitive["material"] = material_for(mesh, glb, told);
    if (!targets.empty()) primitive["targets"] = targets;
    primitives.push_back(std::move(primitive));
  }
  Json made{{"name", mesh.mName.C_Str()}, {"primitives", std::move(primitives)}};
  for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) {
    made["weights"].push_back(has_weights && std::isfinite(mesh.mAnimMeshes[i]->mWeight) ? mesh.mAnimMeshes[i]->mWeight
                                                                                         : 0);
    made["extras"]["targetNames"].push_back(mesh.mAnimMeshes[i]->mName.C_Str());
  }
  return glb.add("meshes", std::move(made));
}

}  // namespace foredraw::import
