#pragma once
// What moves as one, in every pose: triangles that follow one joint alone, or one node.

#include <foredraw/scene/subject.h>

#include <cstdint>
#include <vector>

namespace foredraw::processors::hidden {

/// The node that carries a triangle, or one of these.
using Body = std::uint32_t;
inline constexpr Body stands_still = ~Body{0};   ///< no animation moves it, and no joint
inline constexpr Body bends = stands_still - 1;  ///< several nodes carry its corners: it may take any shape

/// [node] the nearest joint, or node that an animation moves, from it upwards: itself, the one that it hangs below, and
/// so on.
std::vector<Body> carriers(const Scene& scene);

/// [triangle] of a part that a node shows. Joints without weight do not count.
std::vector<Body> bodies_of(const Scene& scene, const SubjectPart& part, const std::vector<Body>& carriers);

}  // namespace foredraw::processors::hidden
