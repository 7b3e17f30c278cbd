#pragma once
#include <foredraw/scene/subject.h>

#include <glm/mat4x4.hpp>

#include <span>
#include <vector>

namespace foredraw {

/// The positions of a part's draw (level 0) at rest, one for each vertex; empty where the draw has none.
///   Without a node: as they are stored, in the draw's own space.
///   With a node: morph targets at the node's weights, or the mesh's where the node has none; then by joints and
///   inverse bind matrices where the node has a skin (weights over their sum, all sets JOINTS_n/WEIGHTS_n), else by the
///   node's transform. World space. A vertex that no joint moves keeps the node's transform.
/// `world`: world_transforms(scene).
std::vector<glm::vec3> rest_positions(const Scene& scene, const SubjectPart& part, std::span<const glm::mat4> world);

}  // namespace foredraw
