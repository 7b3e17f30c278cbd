// The pictures of docs/guides/displacement.md.
//   displacement-pictures MOVED.glb COW.glb FOLDER
//
// Both are of one draw with its map, after `displacement`: a head, and a surface on which the map's seams gape. Files
// are written for the head: displaced_head.png (cage, and what it shows), displaced_levels.png (the cage's triangles by
// their levels, and what they show), displaced_seams.png (the seams by their gaps) and displaced_crowd.png (a crowd
// by who chooses how it is drawn); and displaced_cracks.png of the other.

#include "crowd_pictures.h"
#include "pictures.h"
#include "seam_pictures.h"

#include <foredraw/displaced/tessellation_levels.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/technique/built_in_plugins.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr FrameSize half{320, 352}, third{280, 300};

Scene read(const std::string& path) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  auto file = read_scene(path, diagnostics, {.products = registry.products()});
  if (!file || file->scene.draws.size() != 1) throw std::runtime_error(path + " is no scene of one draw");
  return std::move(file->scene);
}

Scene in_colour(Scene scene, const glm::vec3& colour) {
  for (Material& material : scene.materials) {
    material.colour = colour;
    material.base_colour.reset();
    material.normal_map.reset();
  }
  return scene;
}

/// The triangles of each level, 1 to 64 parts, in a colour of their own.
Scene by_levels(const Scene& shown, std::span<const LogLevels> levels, std::span<const std::uint32_t> owners) {
  static constexpr std::array<glm::vec3, 7> colours = {{{0.1f, 0.15f, 0.5f},
                                                        {0.1f, 0.45f, 0.75f},
                                                        {0.1f, 0.65f, 0.5f},
                                                        {0.35f, 0.7f, 0.15f},
                                                        {0.85f, 0.7f, 0.1f},
                                                        {0.85f, 0.35f, 0.08f},
                                                        {0.7f, 0.06f, 0.06f}}};
  Scene scene = in_colour(shown, glm::vec3(1));
  const Draw whole = scene.draws[0];
  const auto indices = whole.full().stream().indices.view();
  const Material plain = scene.materials.empty() ? Material{} : scene.materials[0];
  scene.draws.clear();
  scene.materials.clear();
  scene.meshes[0].draws.clear();
  for (std::size_t log = 0; log < colours.size(); ++log) {
    std::vector<std::uint32_t> own;
    for (std::size_t t = 0; t < indices.size() / 3; ++t) {
      if (std::ranges::max(levels[owners.empty() ? t : owners[t]]) != log) continue;
      own.insert(own.end(), {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
    }
    if (own.empty()) continue;
    Draw draw = whole;
    draw.full().stream() = {.indices = Shared(std::move(own))};
    draw.material = static_cast<MaterialId>(scene.materials.size());
    scene.meshes[0].draws.push_back(static_cast<DrawId>(scene.draws.size()));
    scene.draws.push_back(std::move(draw));
    scene.materials.push_back(plain);
    scene.materials.back().colour = colours[log];
    scene.materials.back().displacement.reset();
  }
  return scene;
}

FrameCamera camera_at(const Scene& scene, const glm::dvec3& from, const glm::dvec3& to = glm::dvec3(0)) {
  const BoundingSphere sphere = placed(scene).sphere;
  return looking_at(sphere.centre + sphere.radius * from, sphere.centre + sphere.radius * to);
}

void write(const Scene& moved, const Scene& cow, const std::filesystem::path& folder) {
  write_png(folder / "displaced_seams.png", seam_lines(moved, camera_at(moved, {0.6, 0.35, -1.35}), third));
  write_png(folder / "displaced_cracks.png",
            seam_cracks(cow, camera_at(cow, {-0.6, -0.25, -0.85}, {-0.05, -0.3, -0.25}), third));
  write_png(folder / "displaced_crowd.png", crowd_pictures(moved, {420, 300}));

  const FrameCamera face = camera_at(moved, {0.55, 0.15, 1.45});
  const glm::vec3 skin(0.62f, 0.45f, 0.38f);
  const Scene fine = after("displacement-seams, tessellate(texels=8)", moved);
  write_png(folder / "displaced_head.png",
            {drawn(in_colour(moved, skin), face, half), drawn(in_colour(fine, skin), face, half)});

  const Scene levelled = after("displacement-seams, tessellation-levels", moved);
  const auto levels = tessellation_of(levelled, 0)->levels.view();
  const Scene divided = after("tessellate", levelled);
  write_png(folder / "displaced_levels.png",
            {drawn(by_levels(levelled, levels, {}), face, half),
             drawn(by_levels(divided, levels, divided.draws[0].full().stream().triangle_origin.view()), face, half)});
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::runtime_error("displacement-pictures MOVED.glb COW.glb FOLDER");
    foredraw::bench::write(foredraw::bench::read(argv[1]), foredraw::bench::read(argv[2]), argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}
