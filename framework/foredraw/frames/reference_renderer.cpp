#include <foredraw/frames/reference_renderer.h>

#include <foredraw/frames/private/draw_painter.h>
#include <foredraw/viewing/posed_positions.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace foredraw {

ReferenceRenderer::ReferenceRenderer(FrameSize size, int samples, glm::dvec2 shift)
    : size_(size), samples_(std::clamp(samples, 1, 16)), all_{.shift = shift} {
  const int longest = std::max(size.width, size.height);
  if (std::min(size.width, size.height) < 1 || longest > most_samples / samples_) {
    throw std::invalid_argument("a picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                                " pixels and " + std::to_string(samples_) +
                                " samples along each has too many or none; at most " + std::to_string(most_samples) +
                                " samples fit along an edge");
  }
  all_.size = {size.width * samples_, size.height * samples_};
}

void ReferenceRenderer::draw(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                             std::span<const DrawnObject> objects, FrameStyle style, const FrameDetail& detail) {
  const std::size_t count = static_cast<std::size_t>(all_.size.width) * static_cast<std::size_t>(all_.size.height);
  all_.nearness.assign(count, 0);
  all_.colours.assign(count, style == FrameStyle::lit ? sky_colour : glm::vec3(0.1f, 0.15f, 0.3f));
  all_.wires.assign(detail.marks_wires ? count : 0, 0);
  all_.work = {};
  DrawPainter painter(all_, camera, detail);
  const auto draw_all_of = [&](const DrawnObject& drawn, DrawPainter::Turn turn) {
    const bool is_blended = turn == DrawPainter::Turn::blended;
    const PlacedObject& object = scene.objects()[drawn.object];
    const FrameMesh& mesh = scene.mesh_of(drawn.object);
    const bool is_turned = is_mirrored(scene, moment, drawn.object);
    for (const FrameDraw& draw : mesh.draws) {
      const std::size_t first_triangles = detail.backs_of == nullptr ? ~std::size_t{0} : (*detail.backs_of)[draw.draw];
      if (first_triangles == 0) continue;
      if ((draw.surface.alpha_mode == AlphaMode::blend) != is_blended) continue;
      const std::size_t number = std::min<std::size_t>(drawn.level, draw.levels.size() - 1);
      const FrameLevel& level = draw.levels[number];
      const float grey =
          draw.levels.size() < 2 ? 1.0f : 1 - static_cast<float>(number) / static_cast<float>(draw.levels.size() - 1);
      const glm::vec3 flat =
          style == FrameStyle::objects ? glm::vec3(static_cast<float>(drawn.object), 0, 0) : glm::vec3(grey * grey);
      const glm::vec3* flat_colour = style == FrameStyle::lit ? nullptr : &flat;
      if (object.is_posed) {
        const Level& posed = scene.scene().draws[draw.draw].levels[number];
        const VerticesInPose vertices = vertices_in_pose(scene.scene(), *posed.vertices, object.node, moment.nodes);
        painter.draw({level, draw.surface, vertices.positions, vertices.normals, glm::dmat4(1), is_turned,
                      drawn.rendering, flat_colour, turn, true, first_triangles});
      } else {
        painter.draw({level, draw.surface, std::span(level.positions->values).first(level.vertices), level.normals,
                      moment.world[drawn.object], is_turned, drawn.rendering, flat_colour, turn, false,
                      first_triangles});
      }
    }
  };
  for (const DrawnObject& object : objects) draw_all_of(object, DrawPainter::Turn::opaque);
  if (detail.wires != FrameWires::as_they_are) {
    for (std::size_t i = objects.size(); i-- > 0;) draw_all_of(objects[i], DrawPainter::Turn::faded);
  }
  for (std::size_t i = objects.size(); i-- > 0;) draw_all_of(objects[i], DrawPainter::Turn::blended);
}

FramePicture ReferenceRenderer::picture() const {
  FramePicture picture{size_, {}};
  const auto side = static_cast<std::size_t>(samples_), width = static_cast<std::size_t>(size_.width);
  picture.colours.assign(width * static_cast<std::size_t>(size_.height), glm::vec3(0));
  const float share = 1 / static_cast<float>(side * side);
  for (std::size_t y = 0; y < static_cast<std::size_t>(all_.size.height); ++y) {
    glm::vec3* to = &picture.colours[(static_cast<std::size_t>(size_.height) - 1 - y / side) * width];
    const glm::vec3* from = &all_.colours[y * static_cast<std::size_t>(all_.size.width)];
    for (std::size_t x = 0; x < static_cast<std::size_t>(all_.size.width); ++x) to[x / side] += share * from[x];
  }
  return picture;
}

}  // namespace foredraw
