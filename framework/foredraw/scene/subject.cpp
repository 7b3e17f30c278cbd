#include <foredraw/scene/subject.h>

#include <foredraw/scene/walk.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace foredraw {

namespace {

/// Which character each skin and each node belongs to. Skins whose joints meet (the same joint, or one hanging below
/// another's: a rider on a horse) are one character, known by the smallest of its skins.
class Characters {
 public:
  explicit Characters(const Scene& scene) : scene_(scene), leader_(scene.skins.size()), skin_of_(scene.nodes.size()) {
    std::iota(leader_.begin(), leader_.end(), SkinId{0});
    for (SkinId skin = 0; skin < scene.skins.size(); ++skin) {
      for (const NodeId joint : scene.skins[skin].joints) take_below(joint, skin);
    }
    for (NodeId node = 0; node < scene.nodes.size(); ++node) {
      if (const auto skin = scene.nodes[node].skin; skin && skin_of_[node]) join(*skin, *skin_of_[node]);
    }
  }

  std::optional<SkinId> of(NodeId node) const {
    const auto skin = scene_.nodes[node].skin ? scene_.nodes[node].skin : skin_of_[node];
    return skin ? std::optional(leader(*skin)) : std::nullopt;
  }

 private:
  SkinId leader(SkinId skin) const {
    while (leader_[skin] != skin) skin = leader_[skin];
    return skin;
  }

  void join(SkinId a, SkinId b) {
    a = leader(a);
    b = leader(b);
    leader_[std::max(a, b)] = std::min(a, b);
  }

  void take_below(NodeId joint, SkinId skin) {
    std::vector<NodeId> open = {joint};
    while (!open.empty()) {
      const NodeId node = open.back();
      open.pop_back();
      if (skin_of_[node]) {  // and with it all that hangs below
        join(skin, *skin_of_[node]);
        continue;
      }
      skin_of_[node] = skin;
      open.insert(open.end(), scene_.nodes[node].children.begin(), scene_.nodes[node].children.end());
    }
  }

  const Scene& scene_;
  std::vector<SkinId> leader_;
  std::vector<std::optional<SkinId>> skin_of_;  ///< of nodes at or below a joint
};

std::string character_name(const Scene& scene, SkinId id) {
  const Skin& skin = scene.skins[id];
  if (!skin.name.empty()) return skin.name;
  std::set<NodeId> below_another;
  for (const NodeId joint : skin.joints) {
    below_another.insert(scene.nodes[joint].children.begin(), scene.nodes[joint].children.end());
  }
  const auto root = std::find_if(skin.joints.begin(), skin.joints.end(),
                                 [&](NodeId joint) { return !below_another.contains(joint); });
  if (root != skin.joints.end() && !scene.nodes[*root].name.empty()) return scene.nodes[*root].name;
  return "character " + std::to_string(id);
}

void add_parts(Subject& subject, const Mesh& mesh, std::optional<NodeId> node) {
  for (const DrawId draw : mesh.draws) subject.parts.push_back({draw, node});
}

/// Of each mesh, the nodes whose morph weights an animation moves.
std::vector<std::set<NodeId>> morphing_nodes(const Scene& scene) {
  std::vector<std::set<NodeId>> nodes(scene.meshes.size());
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path != AnimatedPath::weights || channel.node >= scene.nodes.size()) continue;
      if (const auto mesh = scene.nodes[channel.node].mesh) nodes[*mesh].insert(channel.node);
    }
  }
  return nodes;
}

std::string mesh_name(const Scene& scene, MeshId mesh) {
  return scene.meshes[mesh].name.empty() ? "mesh " + std::to_string(mesh) : scene.meshes[mesh].name;
}

}  // namespace

std::vector<Subject> subjects_of(const Scene& scene) {
  const Characters characters(scene);
  std::vector<Subject> by_skin(scene.skins.size());
  std::vector<char> is_shown(scene.meshes.size(), 0);
  for (const NodeId node : walk(scene)) {
    const auto mesh = scene.nodes[node].mesh;
    const auto character = characters.of(node);
    if (!mesh || !character) continue;
    add_parts(by_skin[*character], scene.meshes[*mesh], node);
    is_shown[*mesh] = 1;
  }

  std::vector<Subject> subjects;
  for (SkinId skin = 0; skin < by_skin.size(); ++skin) {
    if (by_skin[skin].parts.empty()) continue;
    by_skin[skin].name = character_name(scene, skin);
    subjects.push_back(std::move(by_skin[skin]));
  }
  const auto add_mesh = [&](MeshId mesh, std::optional<NodeId> node) {
    add_parts(subjects.emplace_back(Subject{mesh_name(scene, mesh), {}}), scene.meshes[mesh], node);
  };
  const std::vector<std::set<NodeId>> morphing = morphing_nodes(scene);
  for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (scene.meshes[mesh].draws.empty()) continue;
    for (const NodeId node : morphing[mesh]) {
      if (characters.of(node)) continue;
      add_mesh(mesh, node);
      is_shown[mesh] = 1;
    }
    if (!is_shown[mesh]) add_mesh(mesh, std::nullopt);
  }
  return subjects;
}

}  // namespace foredraw
