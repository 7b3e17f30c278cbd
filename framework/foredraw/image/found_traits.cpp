#include <foredraw/image/found_traits.h>

#include <foredraw/image/sprite_pieces.h>

#include <algorithm>
#include <set>
#include <string>

namespace foredraw {

namespace {

/// What nodes make of a draw: how many draw it, and whether by a skin and bent by an animation.
struct DrawUse {
  std::size_t nodes = 0;
  bool instanced = false;
  bool skinned = false;
  bool bent = false;
};

constexpr NodeId none = ~NodeId{0};

/// All nodes, none before its children.
std::vector<NodeId> children_first(const std::vector<NodeId>& parent) {
  std::vector<std::size_t> children(parent.size(), 0);
  for (NodeId above : parent) {
    if (above != none) ++children[above];
  }
  std::vector<NodeId> order;
  for (NodeId i = 0; i < parent.size(); ++i) {
    if (children[i] == 0) order.push_back(i);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const NodeId above = parent[order[i]];
    if (above != none && --children[above] == 0) order.push_back(above);
  }
  return order;
}

/// For each skin whether an animation moves a joint, or a node between joints. What moves the skeleton as a whole does
/// not change its shape.
std::vector<bool> bent_skins(const Scene& scene) {
  std::set<NodeId> moved;
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path != AnimatedPath::weights) moved.insert(channel.node);
    }
  }
  std::vector<NodeId> parent(scene.nodes.size(), none);
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    for (NodeId child : scene.nodes[i].children) parent[child] = i;
  }
  const std::vector<NodeId> upwards = children_first(parent);
  std::vector<bool> bent;
  for (const Skin& skin : scene.skins) {
    const std::set<NodeId> joints(skin.joints.begin(), skin.joints.end());
    if (std::any_of(skin.joints.begin(), skin.joints.end(), [&](NodeId joint) { return moved.contains(joint); })) {
      bent.push_back(true);
      continue;
    }
    if (moved.empty() || joints.size() == 1) {
      bent.push_back(false);
      continue;
    }
    std::vector<std::size_t> joints_below(scene.nodes.size(), 0);
    for (NodeId joint : joints) joints_below[joint] = 1;
    for (NodeId node : upwards) {
      if (parent[node] != none) joints_below[parent[node]] += joints_below[node];
    }
    bent.push_back(std::any_of(moved.begin(), moved.end(), [&](NodeId node) {
      return joints_below[node] > 0 && joints_below[node] < joints.size();
    }));
  }
  return bent;
}

std::vector<DrawUse> draw_uses(const Scene& scene) {
  std::vector<DrawUse> uses(scene.draws.size());
  const std::vector<bool> bent = bent_skins(scene);
  std::vector<bool> is_morphed(scene.nodes.size(), false);
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.path == AnimatedPath::weights) is_morphed[channel.node] = true;
    }
  }
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.mesh) continue;
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      DrawUse& use = uses[draw];
      ++use.nodes;
      use.skinned = use.skinned || node.skin.has_value();
      use.bent = use.bent || is_morphed[i] || (node.skin && bent[*node.skin]);
      use.instanced = use.instanced || use.nodes > 1 || !node.instances.empty();
    }
  }
  return uses;
}

bool is_sprite(const Draw& draw, const Material* material) {
  if (draw.frame) return true;
  if (material == nullptr || material->alpha_mode == AlphaMode::opaque) return false;
  if (material->alpha_mode == AlphaMode::mask && material->alpha_cutoff <= 0) return false;  // all of it shows
  return material->base_colour && material->base_colour->image && draw.full().vertices->morph_targets.empty() &&
         !draw.traits.has(traits::skinned) && is_made_of_sprites(draw, material->base_colour->texcoord);
}

bool is_displaced(const Draw& draw, const Material* material) {
  return material != nullptr && material->displacement && material->displacement->texture.image &&
         draw.topology == Topology::triangles &&
         draw.full().vertices->find("TEXCOORD_" + std::to_string(material->displacement->texture.texcoord)) != nullptr;
}

}  // namespace

void find_traits(Scene& scene) {
  const std::vector<DrawUse> uses = draw_uses(scene);
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    Draw& draw = scene.draws[id];
    const DrawUse& use = uses[id];
    const VertexStreams& vertices = *draw.full().vertices;
    const Material* material = scene.material_of(draw);
    const auto add = [&](bool holds, Trait trait) {
      if (holds) draw.traits.add(trait);
    };
    add(draw.topology == Topology::triangles, traits::triangles);
    add(vertices.find("TEXCOORD_0") != nullptr, traits::uv0);
    add(vertices.find("NORMAL") != nullptr, traits::normals);
    add(use.skinned && vertices.find("JOINTS_0") != nullptr, traits::skinned);
    add(!vertices.morph_targets.empty(), traits::morphed);
    add(use.bent, traits::animated);
    add(material != nullptr && material->alpha_mode == AlphaMode::blend, traits::blended);
    add(material != nullptr && material->alpha_mode == AlphaMode::mask, traits::masked);
    add(material != nullptr && material->double_sided, traits::double_sided);
    add(is_displaced(draw, material), traits::displaced);
    add(use.instanced, traits::instanced);
    add(is_sprite(draw, material), traits::sprite);
    const VertexStream* positions = vertices.find("POSITION");
    add(positions != nullptr && positions->format.component != Component::float32, traits::quantized);
  }
}

}  // namespace foredraw
