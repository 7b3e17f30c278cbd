#include <foredraw/frames/sampled_picture.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>

namespace foredraw {

SampledPicture sampled_picture(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                               FrameSize size, std::span<const DrawnObject> objects, std::span<const glm::dvec2> places,
                               const FrameDetail& detail) {
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  std::vector<glm::dvec3> sums(width * height, glm::dvec3(0));
  std::vector<double> wires(detail.marks_wires ? sums.size() : 0, 0);
  std::vector<glm::vec3> least, most;
  for (const glm::dvec2& place : places) {
    ReferenceRenderer renderer(size, 1, place);
    renderer.draw(scene, moment, camera, objects, FrameStyle::lit, detail);
    const std::span<const glm::vec3> colours = renderer.colours();
    if (least.empty()) {
      least.assign(colours.begin(), colours.end());
      most = least;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += glm::dvec3(colours[i]);
      least[i] = glm::min(least[i], colours[i]);
      most[i] = glm::max(most[i], colours[i]);
    }
    for (std::size_t i = 0; i < wires.size(); ++i) wires[i] += static_cast<double>(renderer.wires()[i]);
  }
  SampledPicture made{
      {size, std::vector<glm::vec3>(sums.size())}, std::vector<float>(wires.size()), std::vector<float>(sums.size())};
  const double share = 1 / static_cast<double>(places.size());
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t from = y * width + x, to = (height - 1 - y) * width + x;
      const glm::vec3 apart = most[from] - least[from];
      made.picture.colours[to] = glm::vec3(sums[from] * share);
      made.spreads[to] = std::max({apart.x, apart.y, apart.z});
      if (!wires.empty()) made.wires[to] = static_cast<float>(wires[from] * share);
    }
  }
  return made;
}

}  // namespace foredraw
