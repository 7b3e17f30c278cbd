#pragma once
// Many nodes that place one mesh, as one node that draws it many times.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

struct GpuInstancesOptions {
  int least = 5;  ///< instances of a mesh that are worth a node of their own, 2 to 65535
};

/// A mesh that one node draws now.
struct InstancedMesh {
  MeshId mesh = 0;
  NodeId node = 0;  ///< the new one
  std::uint32_t instances = 0;
};

/// Nodes that go on placing a mesh themselves.
struct LeftPlaced {
  MeshId mesh = 0;
  std::uint32_t nodes = 0;
  std::string why;  ///< of the mesh's draws or of these nodes: the rest of a sentence
};

struct InstancedNodes {
  std::vector<InstancedMesh> meshes;  ///< rising
  std::vector<LeftPlaced> left;       ///< of meshes that two nodes or more place: once for each mesh and reason
};

/// Of meshes all of whose draws are among `draws` (rising), the nodes that place them lose their mesh, and a new root
/// node at the end, of the mesh's name, draws it at each of these places (Node::instances, in the sequence of the
/// nodes). Nothing else of the nodes changes: names, children and numbers stay. Not taken are draws that are blended,
/// skinned, morphed or animated, or have several orders or levels; and nodes that are skinned, moved by an animation or
/// a joint (or are below such), keep their mesh (Node::keeps_mesh), are shown by merged draws, have instances or
/// weights of their own, or stand in a way that translation, rotation and a scale that does not mirror can not say.
/// O(nodes + merged places).
InstancedNodes gpu_instances(Scene& scene, std::span<const DrawId> draws, const GpuInstancesOptions& options = {});

struct Plugin;
Plugin gpu_instances_plugin();

}  // namespace foredraw
