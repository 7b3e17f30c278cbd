#include "crowd_pictures.h"

#include <foredraw/base/random.h>
#include <foredraw/crowds/crowd_levels.h>
#include <foredraw/runtime/crowd_select.h>
#include <foredraw/runtime/tessellation_level.h>
#include <foredraw/scene/levels.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace foredraw::bench {

namespace {

/// The cage has a quarter of the triangles, and is the middle of the heights: a character made for tessellation.
const std::string to_cage = "displacement(offset=-0.125), quadric-collapse, simplify(ratio=0.25), displacement-seams";
const std::string to_levels =
    "quadric-collapse, levels(ratios=\"0.5, 0.25, 0.1, 0.04, 0.015\"), crowd-levels(characters=3, most=8, "
    "spacing=fractional-even)";
constexpr std::uint32_t people = 200;

constexpr glm::vec3 colour_of(CrowdClass of) {
  return of == CrowdClass::tessellated ? glm::vec3(0.75f, 0.12f, 0.08f)
         : of == CrowdClass::plain     ? glm::vec3(0.12f, 0.6f, 0.12f)
                                       : glm::vec3(0.12f, 0.25f, 0.8f);
}

struct Standing {
  std::vector<glm::dvec3> places;
  std::vector<float> distances;
  FrameCamera camera;
};

/// On a plane, in rows that fill the picture, each a little out of its place.
Standing standing(double size) {
  Standing all;
  Random random(1);
  for (int row = 0; all.places.size() < people; ++row) {
    const int across = 3 + 2 * row;
    for (int i = 0; i < across && all.places.size() < people; ++i) {
      const double x = 1.75 * (i - 0.5 * (across - 1)) + 0.5 * (random.unit() - 0.5);
      const double z = -1.8 * row + 0.5 * (random.unit() - 0.5);
      all.places.push_back(size * glm::dvec3(x, 0, z));
    }
  }
  all.camera = looking_at(size * glm::dvec3(0, 4.5, 5), size * glm::dvec3(0, 0, -4));
  for (const glm::dvec3& at : all.places) all.distances.push_back(static_cast<float>(glm::length(at - all.camera.eye)));
  return all;
}

/// One mesh a row of the table that is in use.
class CrowdScene {
 public:
  CrowdScene(const Scene& cage, const Scene& levelled, const Crowd& crowd)
      : cage_(cage), levelled_(levelled), crowd_(crowd) {
    whole_.name = "crowd";
  }

  void put(std::uint8_t row, const glm::dvec3& at) {
    const auto [found, is_new] = meshes_.try_emplace(row, static_cast<MeshId>(whole_.meshes.size()));
    if (is_new) add_mesh(crowd_.levels[row]);
    Node node;
    node.matrix = glm::translate(glm::mat4(1), glm::vec3(at));
    node.mesh = found->second;
    whole_.nodes.push_back(std::move(node));
  }

  FramePicture picture(const FrameCamera& camera, FrameSize size) const { return drawn(whole_, camera, size); }

 private:
  void add_mesh(const CrowdLevel& of) {
    const Scene shown = of.kind == CrowdClass::tessellated
                            ? after(fmt::format("tessellate(parts={}, spacing=fractional-even)", of.number), cage_)
                            : at_level(levelled_, of.kind == CrowdClass::simplified ? of.number : 0);
    Draw draw = shown.draws[0];
    draw.material = static_cast<MaterialId>(whole_.materials.size());
    Material material;
    material.colour = colour_of(of.kind);
    whole_.materials.push_back(material);
    Mesh mesh;
    mesh.draws.push_back(static_cast<DrawId>(whole_.draws.size()));
    whole_.meshes.push_back(std::move(mesh));
    whole_.draws.push_back(std::move(draw));
  }

  const Scene& cage_;
  const Scene& levelled_;
  const Crowd& crowd_;
  Scene whole_;
  std::map<std::uint8_t, MeshId> meshes_;
};

/// All at the same row.
std::uint8_t by_paper(const Crowd& crowd, std::uint32_t characters, foredraw_spacing spacing) {
  const float level = foredraw_tessellation_by_count(characters, crowd.levels.front().number, people);
  const std::uint32_t parts = foredraw_tessellation_floor(level, spacing);
  const auto row = std::ranges::find(crowd.levels, parts, &CrowdLevel::number);
  return static_cast<std::uint8_t>(row - crowd.levels.begin());
}

void tell(const std::string& who, const Crowd& crowd, std::span<const std::uint8_t> rows,
          std::span<const float> distances) {
  std::array<int, 3> classes{};
  std::uint64_t triangles = 0;
  double squares = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CrowdLevel& level = crowd.levels[rows[i]];
    ++classes[static_cast<std::size_t>(level.kind)];
    triangles += level.triangles;
    squares += std::pow(static_cast<double>(level.rms) / static_cast<double>(distances[i]), 2);
  }
  fmt::print("{}: tessellated {}, plain {}, simplified {}; {} triangles, {:.1f} % of the budget; rms {:.3f} mrad\n",
             who, classes[0], classes[1], classes[2], triangles,
             100 * static_cast<double>(triangles) / static_cast<double>(crowd.budget),
             1000 * std::sqrt(squares / static_cast<double>(rows.size())));
}

}  // namespace

std::vector<FramePicture> crowd_pictures(const Scene& moved, FrameSize size) {
  const Scene cage = after(to_cage, moved);
  const Scene levelled = after(to_levels, cage);
  const CrowdLevels& levels = *levelled.products.find<CrowdLevels>();
  const Crowd crowd = crowds_of(levels).front();
  const Standing all = standing(placed(cage).sphere.radius);

  std::vector<foredraw_crowd_level> rows;
  for (const CrowdLevel& level : crowd.levels) rows.push_back({level.triangles, level.rms});
  foredraw_crowd_table table{};
  foredraw_crowd_prepare(rows.data(), static_cast<std::uint32_t>(rows.size()), &table);
  std::vector<std::uint32_t> memory(foredraw_crowd_memory(&table) / sizeof(std::uint32_t) + 1);
  std::vector<std::uint8_t> exact(people, FOREDRAW_CROWD_NEW);
  foredraw_crowd_select(&table, all.distances.data(), people, crowd.budget, 0, exact.data(), memory.data());
  const std::vector<std::uint8_t> constant(people, by_paper(crowd, levels.characters, levels.spacing));

  std::vector<FramePicture> pictures;
  for (const std::vector<std::uint8_t>* chosen : {&constant, &std::as_const(exact)}) {
    tell(chosen == &exact ? "crowd_select.h" : "the paper's formula", crowd, *chosen, all.distances);
    CrowdScene scene(cage, levelled, crowd);
    for (std::uint32_t i = 0; i < people; ++i) scene.put((*chosen)[i], all.places[i]);
    pictures.push_back(scene.picture(all.camera, size));
  }
  return pictures;
}

}  // namespace foredraw::bench
