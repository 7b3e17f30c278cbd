#include <foredraw/viewing/slerp.h>

namespace foredraw {

// The usual formula needs arcs and sines, whose last bits differ between machines. Here the arc is halved instead: the
// sum of its ends points to its middle, exactly, and only a square root is needed to bring that to unit length. After
// so many halvings a right angle is an arc of 1.2e-5, on which going straight and going round differ by 1e-17.
constexpr int halvings = 17;

glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double t) {
  glm::dquat begin = from;
  glm::dquat end = glm::dot(from, to) < 0 ? -to : to;
  for (int i = 0; i < halvings; ++i) {
    const glm::dquat middle = glm::normalize(begin + end);
    t *= 2;
    if (t < 1) {
      end = middle;
    } else {
      begin = middle;
      t -= 1;
    }
  }
  return glm::normalize(begin * (1 - t) + end * t);
}

}  // namespace foredraw
