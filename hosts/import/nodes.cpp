#include "nodes.h"

#include "axes.h"
#include "meshes.h"
#include "pivots.h"
#include "skins.h"

#include <set>
#include <stdexcept>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;

class NodesMade {
 public:
  NodesMade(const aiScene& scene, const aiMatrix4x4& of_root, Glb& glb, Told& told)
      : scene_(scene), of_root_(of_root), glb_(glb), told_(told) {
    for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
      const aiAnimation& animation = *scene.mAnimations[i];
      for (unsigned c = 0; c < animation.mNumChannels; ++c) moved_.insert(animation.mChannels[c]->mNodeName.C_Str());
    }
  }

  std::size_t add(const aiNode& node, int depth = 0) {
    if (depth > 1000) throw std::runtime_error("its nodes lie more than 1000 deep");
    if (const auto pivots = still_pivots(node, moved_)) return add_joined(*pivots, depth);
    return add_one(node.mName.C_Str(), depth == 0 ? of_root_ : node.mTransformation, node, depth);
  }

  /// Once all nodes are there, for bones name any.
  void bear_meshes() {
    std::map<unsigned, std::size_t> made;
    for (const Bearer& one : bearers_) {
      const aiMesh& mesh = *scene_.mMeshes[one.mesh];
      if (mesh.mNumFaces == 0 || mesh.mNumVertices == 0) continue;
      Json& node = glb_.json["nodes"][one.node];
      const auto skin = mesh.HasBones() ? add_skin(mesh, one.node, one.of_geometry, numbers, glb_) : std::nullopt;
      if (mesh.HasBones() && !skin) {
        told_.left_out.push_back("the skin of '" + std::string(mesh.mName.C_Str()) +
                                 "' is left out: one of its bones is no node of the scene");
      }
      if (const auto [place, is_new] = made.try_emplace(one.mesh, 0); is_new) {
        const bool is_relative = mesh.mMethod == aiMorphingMethod_MORPH_RELATIVE;
        place->second = add_mesh(scene_, mesh, !is_fbx(scene_), is_relative, skin.has_value(), glb_, told_);
      }
      node["mesh"] = made.at(one.mesh);
      if (skin) node["skin"] = *skin;
      if (mesh.mNumAnimMeshes == 0) continue;
      for (const std::string& name : std::set<std::string>{mesh.mName.C_Str(), one.name}) {
        numbers.morphs[name].push_back(one.node);
      }
    }
  }

  NodeNumbers numbers;

 private:
  std::size_t put(const std::string& name, const aiMatrix4x4& transform, bool bears) {
    const std::size_t number = glb_.add("nodes", {{"name", name}});
    const auto [place_of_name, is_new] = numbers.by_name.try_emplace(name, number);
    if (!is_new && !bears && bearing_.contains(name)) place_of_name->second = number;
    if (is_new && bears) bearing_.insert(name);
    if (!is_new && !bears) bearing_.erase(name);
    place(transform, moved_.contains(name), glb_.json["nodes"][number]);
    return number;
  }

  std::size_t add_one(const std::string& name, const aiMatrix4x4& transform, const aiNode& node, int depth,
                      const aiMatrix4x4& of_geometry = {}) {
    const std::size_t number = put(name, transform, node.mNumMeshes != 0);
    Json children = Json::array();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      std::size_t bearer = number;
      if (node.mNumMeshes > 1) {
        bearer = glb_.add("nodes", {{"name", scene_.mMeshes[node.mMeshes[i]]->mName.C_Str()}});
        children.push_back(bearer);
      }
      bearers_.push_back({bearer, node.mMeshes[i], name, of_geometry});
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) children.push_back(add(*node.mChildren[i], depth + 1));
    if (!children.empty()) glb_.json["nodes"][number]["children"] = children;
    return number;
  }

  std::size_t add_joined(const StillPivots& pivots, int depth) {
    const std::string name = pivots.node->mName.C_Str();
    if (pivots.of_geometry.IsIdentity()) {
      return add_one(name, pivots.of_node * pivots.node->mTransformation, *pivots.node, depth);
    }
    const std::size_t number = put(name, pivots.of_node, false);
    const std::size_t below = add_one(name + " geometry", pivots.of_geometry * pivots.node->mTransformation,
                                      *pivots.node, depth + 1, pivots.of_geometry);
    glb_.json["nodes"][number]["children"] = {below};
    return number;
  }

  struct Bearer {
    std::size_t node;
    unsigned mesh;
    std::string name;
    aiMatrix4x4 of_geometry;  ///< what lies between the mesh and the FBX node, for which its bones are bound
  };

  /// What is animated has to say its parts.
  static void place(const aiMatrix4x4& matrix, bool in_parts, Json& node) {
    if (matrix.IsIdentity() && !in_parts) return;
    if (!in_parts) {
      for (unsigned i = 0; i < 16; ++i) node["matrix"].push_back(i % 4 < 3 ? matrix[i % 4][i / 4] : i == 15 ? 1 : 0);
      return;
    }
    aiVector3D scale, position;
    aiQuaternion turn;
    matrix.Decompose(scale, turn, position);
    turn.Normalize();
    node["translation"] = {position.x, position.y, position.z};
    node["rotation"] = {turn.x, turn.y, turn.z, turn.w};
    node["scale"] = {scale.x, scale.y, scale.z};
  }

  const aiScene& scene_;
  aiMatrix4x4 of_root_;
  Glb& glb_;
  Told& told_;
  std::set<std::string> moved_;    ///< names that channels of animations have
  std::set<std::string> bearing_;  ///< names whose node so far bears a mesh
  std::vector<Bearer> bearers_;
};

}  // namespace

NodeNumbers add_nodes(const aiScene& scene, const aiMatrix4x4& of_root, Glb& glb, Told& told) {
  NodesMade made(scene, of_root, glb, told);
  const std::size_t root = made.add(*scene.mRootNode);
  made.bear_meshes();
  glb.add("scenes", {{"nodes", {root}}});
  glb.json["scene"] = 0;
  return std::move(made.numbers);
}

}  // namespace foredraw::import
