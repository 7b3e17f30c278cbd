// What it gains that `quadric-collapse` looks at animated meshes in poses, beside rest alone. Both leave the same
// number of triangles. Meshes are measured in 16 poses, in the middles of equal parts of the clips: none of them
// decided anything, as stages look at others. All meshes of a file that an animation bends are one figure, by area.
//   poses-bench FILES

#include <benchmarks/timing.h>

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::array ratios{0.5, 0.25, 0.1};
constexpr std::size_t samples = 10'000;

struct Figures {
  double rms = 0, largest = 0;  ///< per cent of the diagonal at rest
};

struct Measured {
  Figures rest, posed;
  double seconds = 0;  ///< of the stage, processor time of one thread
  std::size_t triangles = 0;
};

struct PosedMesh {
  std::vector<glm::vec3> places;
  std::vector<std::uint32_t> indices;

  Surface surface() const { return {places, indices}; }
};

/// As the first node shows it; nothing of a mesh that no animation bends.
PosedMesh posed_mesh(const Scene& scene, MeshId id, const PosedNodes& nodes) {
  PosedMesh mesh;
  for (const DrawId draw : scene.meshes[id].draws) {
    const auto part = shown_part(scene, draw);
    if (!part || !scene.draws[draw].traits.has(traits::animated)) continue;
    const auto first = static_cast<std::uint32_t>(mesh.places.size());
    const std::vector<glm::vec3> places = posed_positions(scene, *part, nodes);
    mesh.places.insert(mesh.places.end(), places.begin(), places.end());
    for (const std::uint32_t i : scene.draws[draw].full().stream().indices.view()) mesh.indices.push_back(first + i);
  }
  return mesh;
}

double area(const Surface& surface) {
  double sum = 0;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(surface.positions[surface.indices[i + k]]); };
    sum += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return sum;
}

double diagonal(const Scene& scene) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (MeshId id = 0; id < scene.meshes.size(); ++id) {
    const PosedMesh mesh = posed_mesh(scene, id, posed_nodes(scene));
    for (const std::uint32_t v : mesh.indices) {
      low = glm::min(low, glm::dvec3(mesh.places[v]));
      high = glm::max(high, glm::dvec3(mesh.places[v]));
    }
  }
  return glm::length(high - low);
}

Figures figures(const Scene& original, const Scene& changed, const Poses& poses, const Executor& executor) {
  double squares = 0, areas = 0;
  Figures found;
  for (const Pose& pose : poses.poses) {
    const PosedNodes before = posed_nodes(original, pose), now = posed_nodes(changed, pose);
    for (MeshId id = 0; id < original.meshes.size(); ++id) {
      const PosedMesh from = posed_mesh(original, id, before), to = posed_mesh(changed, id, now);
      if (from.indices.empty()) continue;
      const auto distance = surface_distance(from.surface(), to.surface(), {samples, 1}, executor);
      const double weight = pose.weight * area(from.surface());
      squares += weight * distance->rms * distance->rms;
      areas += weight;
      found.largest = std::max(found.largest, distance->largest);
    }
  }
  const double unit = diagonal(original) / 100;
  return {std::sqrt(squares / areas) / unit, found.largest / unit};
}

Scene run(const std::string& stages, const Scene& scene, const Registry& registry, const Executor& executor) {
  Diagnostics diagnostics;
  const auto plan = foredraw::plan(*parse_line(stages, diagnostics), registry, scene, diagnostics);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  Analyses analyses;
  return optimize(*plan, scene, {executor, analyses}).scene;
}

std::size_t triangles(const Scene& scene) {
  std::size_t sum = 0;
  for (const Draw& draw : scene.draws) {
    if (draw.traits.has(traits::animated)) sum += draw.full().stream().triangle_count();
  }
  return sum;
}

/// A ratio of figures that may both be 0.
std::string beside(double value, double of) { return of > 0 ? fmt::format("{:.3f}", value / of) : "-"; }

void measure(const std::string& path, const Registry& registry) {
  Diagnostics diagnostics;
  const auto file = read_scene(path, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  const Executor executor;
  const Scene original = run("weld", file->scene, registry, executor);
  const Poses poses = make_poses(original, {.poses = "16"});
  const std::string name = std::filesystem::path(path).stem().string();
  for (const double ratio : ratios) {
    std::array<Measured, 2> both;  // without poses and with them
    for (const bool in_poses : {false, true}) {
      const std::string stages = fmt::format("quadric-collapse{}", in_poses ? "" : "(poses=0)");
      Scene sequenced;
      std::vector<double> times;
      for (int round = 0; round < 5; ++round) {
        const Executor alone(1);
        times.push_back(seconds_of([&] { sequenced = run(stages, original, registry, alone); }));
      }
      const Scene changed = run(stages + fmt::format(", simplify(ratio={})", ratio), original, registry, executor);
      both[in_poses] = {figures(original, changed, rest_pose, executor), figures(original, changed, poses, executor),
                        median(times), triangles(changed)};
    }
    const auto& [off, on] = both;
    fmt::print("| {} | {} | {:.0f} % | {} / {} | {:.4f} / {:.4f} | {} | {} | {} | {} | {:.2f} |\n", name,
               triangles(original), 100 * ratio, off.triangles, on.triangles, off.posed.rms, on.posed.rms,
               beside(on.posed.rms, off.posed.rms), beside(on.posed.largest, off.posed.largest),
               beside(on.rest.rms, off.rest.rms), beside(on.rest.largest, off.rest.largest), on.seconds / off.seconds);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  foredraw::Registry registry;
  foredraw::add_built_in_plugins(registry);
  fmt::print(
      "| mesh | triangles | kept | left, without / with poses | posed rms, % of the diagonal | posed rms | posed "
      "largest | rms at rest | largest at rest | time |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (int i = 1; i < argc; ++i) foredraw::bench::measure(argv[i], registry);
  return 0;
}
