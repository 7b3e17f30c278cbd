#pragma once
#include <glm/gtc/quaternion.hpp>

namespace foredraw {

/// The rotation that lies the part `t` (0 to 1) of the way from one to the other, the shorter way round (glTF 2.0,
/// appendix C.4). Both of unit length, and so is the result; within 1e-15 of the exact one.
glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double t);

}  // namespace foredraw
