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

/// Of each mesh, the nodes that bend it: by a skin, or by morph weights that an animation moves.
std::vector<std::set<NodeId>> nodes_that_bend(const Scene& scene) {
  std::vector<std::set<NodeId>> nodes(scene.meshes.size());
  for (NodeId node = 0; node < scene.nodes.size(); ++node) {
    if (scene.nodes[node].mesh && scene.nodes[node].skin) nodes[*scene.nodes[node].mesh].insert(node);
  }
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

/// Subjects as they are found: those of several meshes first, then each mesh that none of them shows.
class SubjectList {
 public:
  explicit SubjectList(const Scene& scene) : scene_(scene), is_shown_(scene.meshes.size(), false) {}

  void add_scene() {
    Subject whole{"scene", {}};
    for (const NodeId node : walk(scene_)) {
      if (scene_.nodes[node].is_shown) add_node(whole, node);
    }
    add(std::move(whole));
  }

  void add_characters() {
    const Characters characters(scene_);
    std::vector<Subject> by_skin(scene_.skins.size());
    for (const NodeId node : walk(scene_)) {
      if (const auto character = characters.of(node)) add_node(by_skin[*character], node);
    }
    for (SkinId skin = 0; skin < by_skin.size(); ++skin) {
      if (by_skin[skin].parts.empty()) continue;
      by_skin[skin].name = character_name(scene_, skin);
      add(std::move(by_skin[skin]));
    }
  }

  void add_other_meshes() {
    const std::vector<std::set<NodeId>> bending = nodes_that_bend(scene_);
    for (MeshId mesh = 0; mesh < scene_.meshes.size(); ++mesh) {
      if (scene_.meshes[mesh].draws.empty()) continue;
      for (const NodeId node : bending[mesh]) {
        if (is_shown_at_.contains(node)) continue;
        Subject subject{mesh_name(scene_, mesh), {}};
        add_node(subject, node);
        add(std::move(subject));
      }
      if (is_shown_[mesh]) continue;
      Subject subject{mesh_name(scene_, mesh), {}};
      for (const DrawId draw : scene_.meshes[mesh].draws) subject.parts.push_back({draw, std::nullopt});
      add(std::move(subject));
    }
  }

  std::vector<Subject> take() { return std::move(subjects_); }

 private:
  void add_node(Subject& subject, NodeId node) {
    const auto mesh = scene_.nodes[node].mesh;
    if (!mesh) return;
    for (const DrawId draw : scene_.meshes[*mesh].draws) subject.parts.push_back({draw, node});
    is_shown_[*mesh] = true;
    is_shown_at_.insert(node);
  }

  void add(Subject subject) {
    if (!subject.parts.empty()) subjects_.push_back(std::move(subject));
  }

  const Scene& scene_;
  std::vector<Subject> subjects_;
  std::vector<bool> is_shown_;  // [mesh] by a subject of nodes
  std::set<NodeId> is_shown_at_;
};

}  // namespace

std::optional<SubjectPart> shown_part(const Scene& scene, DrawId draw) {
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.mesh || !node.is_shown) continue;
    const std::vector<DrawId>& draws = scene.meshes[*node.mesh].draws;
    if (std::ranges::find(draws, draw) != draws.end()) return SubjectPart{draw, i};
  }
  return std::nullopt;
}

std::vector<Subject> subjects_of(const Scene& scene, SubjectUnit unit) {
  SubjectList subjects(scene);
  if (unit == SubjectUnit::scene) subjects.add_scene();
  if (unit == SubjectUnit::character) subjects.add_characters();
  subjects.add_other_meshes();
  return subjects.take();
}

}  // namespace foredraw
