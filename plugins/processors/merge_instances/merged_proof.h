#pragma once
// Whether merged draws show what the nodes show that they stand for.

#include <foredraw/instances/merged_instances.h>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace foredraw::processors::merge_instances {

/// Holds sets of a scene's merged draws against its nodes, so that what was merged before somebody moved a node or
/// changed a mesh is not drawn any more. Takes time in the order of what the scene and the sets hold, whatever they
/// name how often.
class MergedProof {
 public:
  explicit MergedProof(const Scene& scene);

  /// How a set, in which nothing else is wrong and whose places exist, differs from the nodes, as the rest of a
  /// sentence; empty: it does not. Triangles whose corners are one vertex draw nothing and are passed over.
  std::string difference(const MergedInstances& set);

  /// What a slot is compared with: its entries, a mesh from one of its triangles on, turned inside out or not.
  struct Compared {
    std::uint32_t offset = 0, frequency = 0;
    DrawId draw = 0;
    std::uint32_t triangle = 0;
    bool is_mirrored = false;
    friend bool operator==(const Compared&, const Compared&) = default;
  };

 private:
  DrawId draw_at(const MergedPlace& place) const {
    return scene_.meshes[*scene_.nodes[place.node].mesh].draws[place.primitive];
  }
  std::string vertices(const MergedInstances& set);
  std::string placings(const MergedInstances& set) const;
  std::string triangles(const MergedInstances& set);
  /// The mesh's triangle that comes after those of a slot; nothing where the slot draws others.
  std::optional<std::uint32_t> triangle_after(const Compared& slot, std::span<const std::uint32_t> drawn) const;

  const Scene& scene_;
  std::vector<glm::mat4> worlds_;
  std::uint64_t bytes_left_;  ///< of vertices that may be compared
  std::set<std::tuple<const VertexStreams*, const VertexStreams*, std::uint32_t>> same_;
  std::map<DrawId, std::uint32_t> first_vertex_;  ///< of the set
};

}  // namespace foredraw::processors::merge_instances
