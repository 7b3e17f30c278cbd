#pragma once
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>

#include <glm/mat4x3.hpp>

#include <vector>

namespace foredraw {

/// The positions of a part's draw (level 0), one for each vertex; empty where the draw has none.
///   Without a node: as they are stored, in the draw's own space.
///   With a node: morph targets at the node's weights; then by joints and inverse bind matrices where the node has a
///   skin (weights over their sum, all sets JOINTS_n/WEIGHTS_n), else by the node's transform. World space. Joints that
///   the skin does not have move nothing, and a vertex that no joint moves keeps the node's transform.
/// `nodes`: posed_nodes() of the scene; not read without a node.
std::vector<glm::vec3> posed_positions(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes);

/// Vertices of a level as a node shows them, in world space: as posed_positions() has them. Normals move alike, and are
/// not of length 1; empty where the level has none.
struct VerticesInPose {
  std::vector<glm::vec3> positions, normals;
};
VerticesInPose vertices_in_pose(const Scene& scene, const VertexStreams& vertices, NodeId node,
                                const PosedNodes& nodes);

/// How posed_positions() moves each vertex: a stored position x comes to lie at map * (x, 1). One for each vertex of
/// the part's draw (level 0). Maps are linear in the joint weights, where their sum is 1.
std::vector<glm::dmat4x3> vertex_maps(const Scene& scene, const SubjectPart& part, const PosedNodes& nodes);

/// Whether the node's transform turns front faces clockwise; it decides for skinned draws too (glTF 2.0, 3.7.4).
bool is_mirrored(const SubjectPart& part, const PosedNodes& nodes);

}  // namespace foredraw
