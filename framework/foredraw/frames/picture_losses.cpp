#include <foredraw/frames/picture_losses.h>

#include <foredraw/frames/picture_error.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

constexpr double smallest = 2;  // pixels across; the next size has four times as many
constexpr std::array<glm::dvec3, 4> sides = {glm::dvec3(1, 0.4, 1), glm::dvec3(-1, 0.7, 0.8), glm::dvec3(0.9, 0.2, -1),
                                             glm::dvec3(-0.8, 0.5, -1)};

/// The objects of a size from one side.
class Portrait {
 public:
  Portrait(const FrameScene& scene, const FrameMoment& moment, std::uint32_t object, const glm::dvec3& side, int across)
      : scene_(scene),
        moment_(moment),
        object_(object),
        renderer_({across, across}, across > 128  ? 1
                                    : across > 32 ? 2
                                    : across > 2  ? 4
                                                  : 16) {
    // At two radii the sphere just fits into a picture that is 60 degrees high.
    const BoundingSphere& sphere = moment.bounds[object].sphere;
    camera_ = looking_at(sphere.centre + glm::normalize(side) * (2 * sphere.radius), sphere.centre);
    camera_.near = 0.1 * sphere.radius;
    full_ = drawn(0, Rendering::full);
  }

  double loss_of(std::uint32_t level, Rendering rendering) { return squares(drawn(level, rendering)); }
  double loss_without() { return squares(pictured({})); }

 private:
  FramePicture drawn(std::uint32_t level, Rendering rendering) {
    const DrawnObject object{object_, level, rendering};
    return pictured({&object, 1});
  }

  FramePicture pictured(std::span<const DrawnObject> objects) {
    renderer_.draw(scene_, moment_, camera_, objects);
    return renderer_.picture();
  }

  double squares(const FramePicture& picture) const {
    const double error = picture_error(picture, full_);
    return error * error * 3 * static_cast<double>(picture.colours.size());
  }

  const FrameScene& scene_;
  const FrameMoment& moment_;
  std::uint32_t object_;
  ReferenceRenderer renderer_;
  FrameCamera camera_;
  FramePicture full_;
};

/// Of the first `levels`, at one size.
void add_losses(PictureLosses& losses, const FrameScene& scene, const FrameMoment& moment, std::uint32_t object,
                std::size_t size, std::uint32_t levels) {
  const int across = static_cast<int>(smallest) << (2 * size);
  const auto seen_from = std::span(sides).first(size + 1 < PictureLosses::sizes ? sides.size() : 2);
  const double covered = scene.mesh_of(object).fill * glm::pi<double>() / 4 * across * across;
  const double share = 1 / (covered * static_cast<double>(seen_from.size()));
  for (const glm::dvec3& side : seen_from) {
    Portrait portrait(scene, moment, object, side, across);
    losses.without[size] += share * portrait.loss_without();
    for (std::uint32_t level = 0; level < levels; ++level) {
      for (const Rendering rendering : all_renderings) {
        if (level == 0 && rendering == Rendering::full) continue;
        losses.of[level][static_cast<std::size_t>(rendering)][size] += share * portrait.loss_of(level, rendering);
      }
    }
  }
}

constexpr std::size_t size_of_accuracies = 3;

}  // namespace

double PictureLosses::at(const BySize& losses, double across) {
  const double place = std::clamp(std::log2(std::max(across, smallest) / smallest) / 2, 0.0, double{sizes - 1});
  const auto before = std::min(static_cast<std::size_t>(place), sizes - 2);
  const double part = place - static_cast<double>(before);
  return losses[before] + part * (losses[before + 1] - losses[before]);
}

PictureLosses picture_losses(const FrameScene& scene, const FrameMoment& moment, std::uint32_t object) {
  const auto levels = static_cast<std::uint32_t>(scene.mesh_of(object).levels);
  PictureLosses losses;
  losses.of.resize(levels);
  for (std::size_t size = 0; size < PictureLosses::sizes; ++size) {
    add_losses(losses, scene, moment, object, size, levels);
  }
  return losses;
}

std::array<double, all_renderings.size()> rendering_accuracies(const PictureLosses& losses) {
  std::array<double, all_renderings.size()> accuracies{};
  for (std::size_t i = 0; i < accuracies.size(); ++i) {
    const double without = losses.without[size_of_accuracies],
                 loss = losses.of.empty() ? 0 : losses.of.front()[i][size_of_accuracies];
    accuracies[i] = without > 0 ? std::max(0.0, 1 - std::sqrt(loss / without)) : 1;
  }
  return accuracies;
}

std::array<double, all_renderings.size()> rendering_accuracies(const FrameScene& scene, const FrameMoment& moment,
                                                               std::uint32_t object) {
  PictureLosses losses;
  losses.of.resize(1);
  add_losses(losses, scene, moment, object, size_of_accuracies, 1);
  return rendering_accuracies(losses);
}

}  // namespace foredraw
