// MSFT_lod: a node that coarser nodes stand for from afar. Where these draw the same primitives in the same place, they
// are levels of its mesh; everything else that it can say stays as it came.
#include <foredraw/io/gltf/private/levels.h>
#include <foredraw/io/gltf/private/member.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::gltf {

namespace {

using Why = std::optional<std::string>;

/// Extensions of a primitive that do not tell a level from what it is a level of.
bool is_plain(const Json& primitive) {
  const auto extensions = primitive.find("extensions");
  if (extensions == primitive.end()) return true;
  if (!extensions->is_object()) return false;
  return std::ranges::all_of(extensions->items(),
                             [](const auto& one) { return one.key() == "KHR_materials_variants"; });
}

class LodNodes {
 public:
  LodNodes(const Scene& scene, const Document& document) : scene_(scene), json_(document.json), document_(document) {
    for (const Node& node : scene.nodes) held_.insert(node.children.begin(), node.children.end());
    if (const auto scenes = json_.find("scenes"); scenes != json_.end()) {
      for (const Json& roots : *scenes) {
        if (roots.contains("nodes")) held_.merge(roots["nodes"].get<std::set<NodeId>>());
      }
    }
    for (const Skin& skin : scene.skins) joints_.insert(skin.joints.begin(), skin.joints.end());
    for (const Animation& animation : scene.animations) {
      for (const AnimationChannel& channel : animation.channels) {
        (channel.path == AnimatedPath::weights ? bent_ : moved_).insert(channel.node);
      }
    }
    for (const Ladder& ladder : document.ladders) with_levels_.insert(ladder.full.mesh);
  }

  std::vector<Ladder> find(Diagnostics& diagnostics) {
    for (NodeId n = 0; n < scene_.nodes.size(); ++n) {
      const Json* lod = extension_of(json_["nodes"][n], lod_extension);
      if (lod == nullptr) continue;
      std::vector<NodeId> coarser;
      const Why why = levels_of(n, *lod, coarser);
      why_of_node_[n] = why;
      coarser_[n] = std::move(coarser);
    }
    refuse_meshes_that_differ();
    std::vector<Ladder> ladders;
    std::set<MeshId> done;
    for (const auto& [n, why] : why_of_node_) {
      if (why) {
        diagnostics.note({.file = document_.name, .inside = fmt::format("nodes[{}]", n)}, "lod-left-as-it-came",
                         "MSFT_lod is kept, but its nodes are not read as levels of detail: " + *why);
      } else if (done.insert(*scene_.nodes[n].mesh).second) {
        add_ladders(n, ladders);
      }
    }
    return ladders;
  }

 private:
  Why levels_of(NodeId n, const Json& lod, std::vector<NodeId>& coarser) const {
    const Json* ids = member(lod, "ids");
    if (ids == nullptr || !ids->is_array() || ids->empty()) return "it names no nodes";
    for (const Json& id : *ids) {
      if (!id.is_number_unsigned() || id.get<std::uint64_t>() >= scene_.nodes.size())
        return "it names a node that does not exist";
      coarser.push_back(id.get<NodeId>());
    }
    std::set<NodeId> all(coarser.begin(), coarser.end());
    if (!all.insert(n).second || all.size() != coarser.size() + 1) return "it names a node twice";
    if (Why why = not_full(n)) return why;
    for (const NodeId c : coarser) {
      if (Why why = not_coarser(n, c)) return fmt::format("node {} {}", c, *why);
    }
    return std::nullopt;
  }

  Why not_full(NodeId n) const {
    const Node& node = scene_.nodes[n];
    if (!node.mesh) return "the node has no mesh";
    if (!node.children.empty()) return "the node has children, which go with it";
    if (!node.instances.empty()) return "the node is drawn many times by instancing";
    if (bent_.contains(n)) return "an animation moves its morph weights, and not those of the coarser nodes";
    if (moved_.contains(n) && !node.skin) return "an animation moves the node, and not the coarser nodes";
    if (joints_.contains(n)) return "the node is a joint";
    if (with_levels_.contains(*node.mesh)) return "its mesh already has levels";
    return std::nullopt;
  }

  Why not_coarser(NodeId n, NodeId c) const {
    const Node& full = scene_.nodes[n];
    const Node& node = scene_.nodes[c];
    if (!node.mesh) return "has no mesh";
    if (*node.mesh == *full.mesh) return "draws the same mesh";
    if (node.is_shown) return "is in the scene";
    if (held_.contains(c)) return "is below another node, or in a scene";
    if (!node.children.empty()) return "has children";
    if (!node.instances.empty()) return "is drawn many times by instancing";
    if (moved_.contains(c) || bent_.contains(c)) return "is animated by itself";
    if (joints_.contains(c)) return "is a joint";
    if (node.skin != full.skin) return "has a different skin";
    if (node.weights != full.weights) return "has different morph weights";
    if (node.local() != full.local()) return "has a different transform";
    if (json_["nodes"][c].contains("extensions")) return "has extensions of its own";
    if (with_levels_.contains(*node.mesh)) return "has a mesh with levels of its own";
    return not_alike(*full.mesh, *node.mesh);
  }

  Why not_alike(MeshId full, MeshId coarse) const {
    const Mesh& a = scene_.meshes[full];
    const Mesh& b = scene_.meshes[coarse];
    if (a.draws.size() != b.draws.size()) return "has a different number of primitives";
    if (a.weights != b.weights) return "has different morph weights";
    for (std::size_t p = 0; p < a.draws.size(); ++p) {
      const Draw& x = scene_.draws[a.draws[p]];
      const Draw& y = scene_.draws[b.draws[p]];
      if (x.material != y.material) return "has different materials";
      if (x.material && extension_of(json_["materials"][*x.material], lod_extension) != nullptr) {
        return "has a material with levels";
      }
      if (x.topology != y.topology) return "draws another kind of primitive";
      if (x.full().vertices->morph_targets.size() != y.full().vertices->morph_targets.size()) {
        return "has a different number of morph targets";
      }
      if (y.full().vertices->find("POSITION") == nullptr) return "has no positions";
      if (!is_plain(json_["meshes"][coarse]["primitives"][p])) return "has a primitive with extensions of its own";
    }
    return std::nullopt;
  }

  std::vector<MeshId> meshes_of(NodeId n) const {
    std::vector<MeshId> meshes;
    const auto coarser = coarser_.find(n);
    if (coarser == coarser_.end() || why_of_node_.at(n)) return meshes;
    for (const NodeId c : coarser->second) meshes.push_back(*scene_.nodes[c].mesh);
    return meshes;
  }

  /// A mesh has the same levels wherever it is drawn, and a coarser one is a level of one mesh alone.
  void refuse_meshes_that_differ() {
    std::map<NodeId, NodeId> full_of;  // coarser node -> who names it
    std::set<NodeId> of_several;
    for (const auto& [n, coarser] : coarser_) {
      for (const NodeId c : coarser) {
        const auto [known, is_new] = full_of.try_emplace(c, n);
        if (!is_new && known->second != n) of_several.insert({n, known->second});
      }
    }
    for (const NodeId n : of_several) refuse(n, "another node names the same coarser nodes");
    for (bool changed = true; changed;) {
      changed = false;
      std::map<MeshId, std::set<std::vector<MeshId>>> levels;          // of each mesh that is drawn as full detail
      std::map<MeshId, std::set<std::pair<MeshId, std::size_t>>> use;  // of each coarser mesh
      for (NodeId n = 0; n < scene_.nodes.size(); ++n) {
        const Node& node = scene_.nodes[n];
        if (!node.mesh) continue;
        const auto full = full_of.find(n);
        if (full != full_of.end() && !why_of_node_.at(full->second)) continue;
        levels[*node.mesh].insert(meshes_of(n));
        use[*node.mesh].insert({*node.mesh, 0});
        const std::vector<MeshId> coarser = meshes_of(n);
        for (std::size_t i = 0; i < coarser.size(); ++i) use[coarser[i]].insert({*node.mesh, i + 1});
      }
      for (auto& [n, why] : why_of_node_) {
        if (why) continue;
        const bool differs = levels[*scene_.nodes[n].mesh].size() > 1;
        const std::vector<MeshId> coarser = meshes_of(n);
        const bool is_shared = std::ranges::any_of(coarser, [&](MeshId mesh) { return use[mesh].size() > 1; });
        if (!differs && !is_shared) continue;
        why = differs ? "another node draws its mesh without these levels"
                      : "a coarser mesh is also drawn by itself, or as a level of another mesh";
        changed = true;
      }
    }
  }

  void refuse(NodeId n, const char* reason) {
    if (!why_of_node_[n]) why_of_node_[n] = reason;
  }

  void add_ladders(NodeId n, std::vector<Ladder>& ladders) const {
    const MeshId full = *scene_.nodes[n].mesh;
    for (std::uint32_t p = 0; p < scene_.meshes[full].draws.size(); ++p) {
      Ladder ladder{{full, p}, {}, {}};
      for (const MeshId mesh : meshes_of(n)) ladder.coarser.push_back({mesh, p});
      ladders.push_back(std::move(ladder));
    }
  }

  const Scene& scene_;
  const Json& json_;
  const Document& document_;
  std::set<NodeId> held_;  ///< below another node, or in a scene
  std::set<NodeId> joints_;
  std::set<NodeId> moved_;
  std::set<NodeId> bent_;  ///< whose morph weights an animation moves
  std::set<MeshId> with_levels_;
  std::map<NodeId, Why> why_of_node_;
  std::map<NodeId, std::vector<NodeId>> coarser_;
};

}  // namespace

std::vector<Ladder> lod_ladders(const Scene& scene, const Document& document, Diagnostics& diagnostics) {
  const auto nodes = document.json.find("nodes");
  const auto has_lod = [](const Json& node) { return extension_of(node, lod_extension) != nullptr; };
  if (nodes == document.json.end() || std::ranges::none_of(*nodes, has_lod)) return {};
  return LodNodes(scene, document).find(diagnostics);
}

}  // namespace foredraw::gltf
