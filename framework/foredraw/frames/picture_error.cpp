#include <foredraw/frames/picture_error.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <cmath>

namespace foredraw {

namespace {

glm::vec3 stored(const glm::vec3& colour) {
  return glm::vec3(std::sqrt(glm::clamp(colour.x, 0.0f, 1.0f)), std::sqrt(glm::clamp(colour.y, 0.0f, 1.0f)),
                   std::sqrt(glm::clamp(colour.z, 0.0f, 1.0f)));
}

}  // namespace

std::vector<std::uint8_t> as_rgb(const FramePicture& picture) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * picture.colours.size());
  for (const glm::vec3& colour : picture.colours) {
    const glm::vec3 bytes = stored(colour) * 255.0f + 0.5f;
    for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<std::uint8_t>(bytes[c]));
  }
  return rgb;
}

double picture_error(const FramePicture& a, const FramePicture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.colours.size(); ++i) {
    const glm::dvec3 apart(stored(a.colours[i]) - stored(b.colours[i]));
    sum += glm::dot(apart, apart);
  }
  return a.colours.empty() ? 0 : std::sqrt(sum / (3 * static_cast<double>(a.colours.size())));
}

FrameTruth frame_truth(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera, FrameSize size,
                       int samples) {
  std::vector<DrawnObject> objects;
  for (const SeenObject& seen : seen_objects(scene, moment, camera, size)) objects.push_back({seen.object});
  ReferenceRenderer renderer(size, samples), other(size, samples, {0.5, 0.5});
  renderer.draw(scene, moment, camera, objects);
  other.draw(scene, moment, camera, objects);
  FrameTruth truth{renderer.picture(), 0};
  truth.floor = picture_error(truth.picture, other.picture());
  return truth;
}

}  // namespace foredraw
