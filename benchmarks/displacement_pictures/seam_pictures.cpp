#include "seam_pictures.h"

#include <evaluators/seam_gap/seam_gap.h>
#include <foredraw/displaced/map_seams.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/io/image/images.h>
#include <foredraw/scene/triangle_draw.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace foredraw::bench {

namespace {

const std::array<std::string, 3> repairs = {"", "displacement-seams(method=average, iterations=100), ",
                                            "displacement-seams, "};

/// A draw more, in the scene's first mesh.
void add(Scene& scene, Draw draw, const glm::vec3& colour) {
  draw.material = static_cast<MaterialId>(scene.materials.size());
  Material material;
  material.colour = colour;
  material.double_sided = true;
  scene.materials.push_back(material);
  scene.meshes[0].draws.push_back(static_cast<DrawId>(scene.draws.size()));
  scene.draws.push_back(std::move(draw));
}

/// The draw's positions, moved along their directions.
std::vector<glm::vec3> moved_by(const Scene& scene, float units) {
  Analyses analyses(image_decoder({}));
  std::vector<glm::vec3> positions = positions_of(analyses, *scene.draws[0].full().vertices)->values;
  const std::vector<glm::vec3> directions = displacement_directions(scene, 0, analyses);
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += units * directions[v];
  return positions;
}

struct Lines {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  /// Two crossed strips, so that it is seen from everywhere.
  void add(const glm::vec3& from, const glm::vec3& to, float width) {
    const glm::vec3 along = to - from;
    if (!(glm::dot(along, along) > 0)) return;
    const glm::vec3 aside = glm::normalize(
        glm::cross(along, std::abs(along.y) < 0.9f * glm::length(along) ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    for (const glm::vec3& half : {0.5f * width * aside, 0.5f * width * glm::normalize(glm::cross(along, aside))}) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      positions.insert(positions.end(), {from - half, from + half, to - half, to + half});
      indices.insert(indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
    }
  }
};

constexpr std::array gap_limits = {0.001, 0.01, 0.1};
constexpr std::array<glm::vec3, 4> gap_colours = {
    {{0.05f, 1.2f, 0.1f}, {1.6f, 1.4f, 0.05f}, {2, 0.5f, 0.02f}, {2, 0.02f, 0.02f}}};

/// On the plain cage.
Scene with_lines(const Scene& repaired, float width) {
  Analyses analyses(image_decoder({}));
  const SceneSeams seams = seams_of_maps(repaired, {0}, analyses);
  const MapSeams& of = seams.maps.at(0);
  const std::vector<double> gaps = seam_gap(of.seams, of.sampled()).largest_of;
  const std::vector<glm::vec3> positions = moved_by(repaired, width / 2);
  const auto indices = repaired.draws[0].full().stream().indices.view();
  std::array<Lines, 4> lines;
  for (std::size_t e = 0; e < gaps.size(); ++e) {
    if (of.seams.edges[e].kind != EdgeKind::seam) continue;
    const EdgeSide& side = of.seams.sides_of(of.seams.edges[e]).front();
    const auto corner = [&](std::uint32_t c) { return positions[indices[3 * std::size_t{side.triangle} + c % 3]]; };
    const auto of_gap = std::ranges::lower_bound(gap_limits, gaps[e]) - gap_limits.begin();
    lines[static_cast<std::size_t>(of_gap)].add(corner(side.corner), corner(side.corner + 1u), width);
  }
  Scene scene = repaired;
  for (Material& material : scene.materials) {
    material.displacement.reset();
    material.colour = glm::vec3(0.45f);
    material.base_colour.reset();
    material.normal_map.reset();
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].indices.empty()) continue;
    add(scene, triangle_draw("lines", lines[i].positions, lines[i].indices), gap_colours[i]);
  }
  return scene;
}

/// The cage a little below the surface in red: nothing of it is seen where there is no crack.
Scene over_red(const Scene& moved, const std::string& stages, float below) {
  Scene scene = after(stages, moved);
  for (Material& material : scene.materials) {
    material.colour = glm::vec3(1.6f, 1.52f, 1.4f);
    material.double_sided = false;
    material.base_colour.reset();
  }
  const auto indices = moved.draws[0].full().stream().indices.view();
  add(scene, triangle_draw("below", moved_by(moved, -below), {indices.begin(), indices.end()}), {4, 0, 0});
  return scene;
}

}  // namespace

std::vector<FramePicture> seam_lines(const Scene& moved, const FrameCamera& camera, FrameSize size) {
  const auto width = static_cast<float>(0.012 * placed(moved).sphere.radius);
  std::vector<FramePicture> pictures;
  for (const std::string& repair : repairs) {
    const Scene repaired = repair.empty() ? moved : after(repair.substr(0, repair.rfind(',')), moved);
    pictures.push_back(drawn(with_lines(repaired, width), camera, size));
  }
  return pictures;
}

std::vector<FramePicture> seam_cracks(const Scene& moved, const FrameCamera& camera, FrameSize size) {
  const auto below = static_cast<float>(0.002 * placed(moved).sphere.radius);
  std::vector<FramePicture> pictures;
  for (const std::string& repair : repairs)
    pictures.push_back(drawn(over_red(moved, repair + "tessellate(texels=4)", below), camera, size));
  return pictures;
}

}  // namespace foredraw::bench
