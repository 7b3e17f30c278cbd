#include <foredraw/frames/unhidden_objects.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

bool hides(const FrameMesh& mesh) {
  return std::ranges::all_of(mesh.draws,
                             [](const FrameDraw& draw) { return draw.surface.alpha_mode == AlphaMode::opaque; });
}

/// The samples from one to another, in a picture of so many; those outside are left out.
struct Reach {
  std::size_t first, end;

  Reach(double from, double to, int count)
      : first(static_cast<std::size_t>(std::clamp(std::floor(from), 0.0, static_cast<double>(count)))),
        end(static_cast<std::size_t>(std::clamp(std::ceil(to), 0.0, static_cast<double>(count)))) {}
};

}  // namespace

std::vector<SeenObject> unhidden_objects(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                                         FrameSize size, std::vector<SeenObject> seen) {
  const FrameSize half{std::max(1, size.width / 2), std::max(1, size.height / 2)};
  std::vector<DrawnObject> before;
  for (const SeenObject& object : seen) {
    const FrameMesh& mesh = scene.mesh_of(object.object);
    if (hides(mesh)) before.push_back({object.object, static_cast<std::uint32_t>(mesh.levels - 1), Rendering::unlit});
  }
  ReferenceRenderer renderer(half);
  renderer.draw(scene, moment, camera, before, FrameStyle::objects);
  const std::span<const float> nearness = renderer.nearness();
  std::vector<float> samples(scene.objects().size());
  for (std::size_t i = 0; i < nearness.size(); ++i) {
    if (nearness[i] > 0) ++samples[static_cast<std::size_t>(renderer.colours()[i].x)];
  }

  const auto is_hidden = [&](const SeenObject& object) {
    if (static_cast<double>(object.distance) <= camera.near) return false;
    // A sphere looks larger near the eye: its nearest point's scale has room for all of it.
    const double radius =
        moment.bounds[object.object].sphere.radius * camera.pixels_a_unit(static_cast<double>(object.distance), half);
    const double x = half.width / 2.0 + static_cast<double>(object.place.x) * half.height / size.height;
    const double y = half.height / 2.0 + static_cast<double>(object.place.y) * half.height / size.height;
    const Reach columns(x - radius - 1, x + radius + 1, half.width), rows(y - radius - 1, y + radius + 1, half.height);
    for (std::size_t row = rows.first; row < rows.end; ++row) {
      for (std::size_t column = columns.first; column < columns.end; ++column) {
        if (nearness[row * static_cast<std::size_t>(half.width) + column] * object.distance <= 1) return false;
      }
    }
    return true;
  };
  std::erase_if(seen, is_hidden);
  for (SeenObject& object : seen) {
    constexpr float pixels_a_sample = 4;
    if (!hides(scene.mesh_of(object.object))) continue;  // it is not in the picture
    // What is smaller than a sample may be missed by all of them.
    object.shown = std::max(samples[object.object], std::min(1.0f, object.pixels / pixels_a_sample)) * pixels_a_sample;
  }
  return seen;
}

}  // namespace foredraw
