// Levels put into meshes of their own, on nodes that MSFT_lod names.
#include <foredraw/io/gltf/private/levels.h>

#include <foredraw/scene/levels.h>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>

namespace foredraw::gltf {

namespace {

class LodOutput {
 public:
  LodOutput(const Scene& scene, const Document& document) : scene_(scene), document_(document) {
    for (const Animation& animation : scene.animations) {
      for (const AnimationChannel& channel : animation.channels) {
        if (channel.path == AnimatedPath::weights || !scene.nodes[channel.node].skin) moved_.insert(channel.node);
      }
    }
    for (const Skin& skin : scene.skins) moved_.insert(skin.joints.begin(), skin.joints.end());
  }

  Scene run(LodsOf& lods, Diagnostics& diagnostics) {
    Scene result = scene_;
    for (MeshId m = 0; m < scene_.meshes.size(); ++m) {
      const Mesh& mesh = scene_.meshes[m];
      const auto is_own = [&](DrawId id) { return has_own_levels(scene_.draws[id]); };
      if (std::ranges::none_of(mesh.draws, is_own)) continue;
      if (const std::string why = why_not(m); !why.empty()) {
        diagnostics.note({.file = scene_.name, .inside = mesh.name}, "levels-stay-with-primitive",
                         "its levels do not fit MSFT_lod and are written as FOREDRAW_levels: " + why);
        continue;
      }
      const std::size_t levels = scene_.draws[mesh.draws[0]].levels.size();
      for (std::size_t level = 1; level < levels; ++level) add_level(m, level, result, lods);
      const std::vector<double> coverage = coverage_of(m, levels);
      for (NodeId n = 0; n < scene_.nodes.size(); ++n) {
        if (scene_.nodes[n].mesh == m) lods[n].coverage = coverage;
      }
      for (const DrawId id : mesh.draws) result.draws[id].levels.resize(1);
    }
    return result;
  }

 private:
  static bool has_own_levels(const Draw& draw) {
    return draw.levels.size() > 1 && !is_in_coarser_mesh(draw, draw.levels[1]);
  }

  std::string why_not(MeshId m) const {
    const Mesh& mesh = scene_.meshes[m];
    const std::size_t count = scene_.draws[mesh.draws[0]].levels.size();
    for (const DrawId id : mesh.draws) {
      if (scene_.draws[id].levels.size() != count) return "its primitives have different numbers of levels";
    }
    for (NodeId n = 0; n < scene_.nodes.size(); ++n) {
      const Node& node = scene_.nodes[n];
      if (node.mesh != m) continue;
      const bool is_old = document_.json.contains("nodes") && n < document_.json["nodes"].size();
      const char* why = moved_.contains(n)        ? "is animated"
                        : !node.children.empty()  ? "has children"
                        : !node.instances.empty() ? "is drawn many times by instancing"
                        : is_old && extension_of(document_.json["nodes"][n], lod_extension) != nullptr
                            ? "has coarser nodes"
                            : nullptr;
      if (why != nullptr) return fmt::format("node {} {}", n, why);
    }
    return {};
  }

  /// A level is for so much of the screen that the next coarser one would be off by more than a pixel there; the
  /// coarsest is for any. Scaled nodes have the same: what counts is the error's share of the mesh.
  std::vector<double> coverage_of(MeshId m, std::size_t levels) const {
    constexpr double screen = 1920.0 * 1080.0;  // pixels
    const double radius = radius_of(m);
    std::vector<double> coverage(levels, 0);
    double most = 1;
    for (std::size_t level = 1; level < levels; ++level) {
      double error = 0;
      for (const DrawId id : scene_.meshes[m].draws) {
        error = std::max(error, double{scene_.draws[id].levels[level].error});
      }
      if (!(error > 0)) return {};
      const double pixels = radius / error;
      most = std::min(most, std::numbers::pi * pixels * pixels / screen);
      coverage[level - 1] = most;
    }
    return coverage;
  }

  /// Of the sphere around the box of full detail.
  double radius_of(MeshId m) const {
    glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
    for (const DrawId id : scene_.meshes[m].draws) {
      const VertexStream* positions = scene_.draws[id].full().vertices->find("POSITION");
      if (positions == nullptr) continue;
      for (const glm::dvec3 position : decode_vec3(*positions)) {
        least = glm::min(least, position);
        most = glm::max(most, position);
      }
    }
    return glm::distance(least, most) / 2;
  }

  void add_level(MeshId m, std::size_t level, Scene& result, LodsOf& lods) const {
    const std::string ending = fmt::format(" (level {})", level);
    Mesh mesh{scene_.meshes[m].name + ending, {}, scene_.meshes[m].weights};
    for (const DrawId id : scene_.meshes[m].draws) {
      Draw draw = at_level(scene_.draws[id], level);
      draw.name += ending;
      mesh.draws.push_back(static_cast<DrawId>(result.draws.size()));
      result.draws.push_back(std::move(draw));
    }
    for (NodeId n = 0; n < scene_.nodes.size(); ++n) {
      if (scene_.nodes[n].mesh != m) continue;
      Node node = scene_.nodes[n];
      if (!node.name.empty()) node.name += ending;
      node.mesh = static_cast<MeshId>(result.meshes.size());
      node.is_shown = false;
      lods[n].ids.push_back(static_cast<NodeId>(result.nodes.size()));
      result.nodes.push_back(std::move(node));
    }
    result.meshes.push_back(std::move(mesh));
  }

  const Scene& scene_;
  const Document& document_;
  std::set<NodeId> moved_;
};

}  // namespace

Scene with_lod_nodes(const Scene& scene, const Document& document, LodsOf& lods, Diagnostics& diagnostics) {
  return LodOutput(scene, document).run(lods, diagnostics);
}

}  // namespace foredraw::gltf
