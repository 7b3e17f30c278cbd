// Every simplifier on the same meshes: how far what is left lies from the original, and what that took. Positions
// alone: vertices at one place are one, and nobody has an error limit. Each is asked for the same numbers of triangles.
// Rounds are interleaved, times are medians of the rounds': of the processor, one thread, and by the clock where there
// are two; energy-collapse runs once, on small meshes. Distances are measured alike for all: rms of 200,000 points of
// each surface, and the largest distance, proved within 2 per cent; both in per cent of the box's diagonal.
//   simplifiers-bench [--rounds=7] [--most-energy=7000] [--tsv=FILE] FILES

#include <benchmarks/meshes/one_mesh.h>
#include <benchmarks/peers/energy_collapse/energy_collapse.h>
#include <plugins/processors/openmesh_decimate/openmesh_decimate.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>
#ifdef FOREDRAW_HAS_CGAL_COLLAPSE
#include <plugins/processors/cgal_collapse/cgal_collapse.h>
#endif

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/collapses/replay.h>

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <glm/geometric.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>

namespace foredraw::bench {
namespace {

constexpr std::array ratios{0.5, 0.25, 0.1, 0.02};

using Mesh = WeldedMesh;

Surface surface_of(const Mesh& mesh) { return {mesh.positions, mesh.indices}; }

Mesh simplified_by_peer(const Mesh& mesh, std::size_t triangles, double& time) {
  Mesh left = mesh;
  std::size_t indices = 0;
  time = seconds_of([&] {
    indices = meshopt_simplify(left.indices.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x,
                               mesh.positions.size(), sizeof(glm::vec3), 3 * triangles, 1e30f, 0, nullptr);
  });
  left.indices.resize(indices);
  return left;
}

Mesh updated_by_peer(const Mesh& mesh, std::size_t triangles, double& time) {
  Mesh left = mesh;
  std::size_t indices = 0;
  time = seconds_of([&] {
    indices = meshopt_simplifyWithUpdate(left.indices.data(), left.indices.size(), &left.positions[0].x,
                                         left.positions.size(), sizeof(glm::vec3), nullptr, 0, nullptr, 0, nullptr,
                                         3 * triangles, 1e30f, 0, nullptr);
  });
  left.indices.resize(indices);
  return left;
}

struct Errors {
  double rms = 0, largest = 0;
};

Errors errors(const Mesh& from, const Mesh& to, const Executor& executor) {
  const ClosestPoints a(surface_of(from)), b(surface_of(to));
  return {surface_distance(surface_of(from), surface_of(to), {200'000, 1}, executor)->rms,
          hausdorff_distance({surface_of(from), a}, {surface_of(to), b}, {}, executor)->bound};
}

struct Contestant {
  std::string name;
  std::function<Mesh(const Mesh& mesh, std::size_t triangles, double& time)> run;
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< triangles; more take too long
  bool once = false;
};

Mesh cut_by(const CollapseSequence& sequence, const Mesh& mesh) {
  const Collapsed after = collapsed(sequence, sequence.collapses.size(), mesh.positions, mesh.indices);
  return {after.places, after.indices};
}

/// Of one that answers with a sequence. To run that is not timed.
template <class Simplify>
auto cut_of(const Simplify& simplify) {
  return [simplify](const Mesh& mesh, std::size_t triangles, double& time) {
    CollapseSequence sequence;
    time = seconds_of([&] { sequence = simplify(mesh, triangles); });
    return cut_by(sequence, mesh);
  };
}

/// On two threads, by the clock.
Contestant quadric_collapse_on_two(const Executor& two) {
  return {"quadric-collapse, two threads", [&two](const Mesh& mesh, std::size_t triangles, double& time) {
            CollapseSequence sequence;
            const auto begin = std::chrono::steady_clock::now();
            sequence = quadric_collapse(mesh.positions, mesh.indices, {.least = triangles, .executor = &two});
            time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            return cut_by(sequence, mesh);
          }};
}

std::vector<Contestant> contestants(std::size_t most_energy, const Executor& two) {
  std::vector<Contestant> all;
  for (const auto placement : {CollapsePlacement::optimal, CollapsePlacement::endpoint}) {
    const std::string name = placement == CollapsePlacement::optimal ? "optimal" : "endpoint";
    all.push_back({"quadric-collapse, " + name, cut_of([placement](const Mesh& mesh, std::size_t least) {
                     return quadric_collapse(mesh.positions, mesh.indices, {.placement = placement, .least = least});
                   })});
  }
  all.push_back(quadric_collapse_on_two(two));
  all.push_back({"meshopt_simplify", simplified_by_peer});
  all.push_back({"meshopt_simplifyWithUpdate", updated_by_peer});
  all.push_back({"openmesh-decimate", cut_of([](const Mesh& mesh, std::size_t least) {
                   return openmesh_decimate(mesh.positions, mesh.indices, {.least = least});
                 })});
#ifdef FOREDRAW_HAS_CGAL_COLLAPSE
  for (const auto cost : {CgalCost::lindstrom_turk, CgalCost::garland_heckbert}) {
    const std::string name = cost == CgalCost::lindstrom_turk ? "Lindstrom-Turk" : "Garland-Heckbert";
    all.push_back({"cgal-collapse, " + name, cut_of([cost](const Mesh& mesh, std::size_t least) {
                     return cgal_collapse(mesh.positions, mesh.indices, {.cost = cost, .least = least});
                   })});
  }
#endif
  all.push_back({"energy-collapse", cut_of([](const Mesh& mesh, std::size_t least) {
                   return energy_collapse(mesh.positions, mesh.indices, {}, {.least = least});
                 }),
                 most_energy, true});
  return all;
}

double diagonal_of(const Mesh& mesh) {
  glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
  for (const glm::vec3& p : mesh.positions) {
    least = glm::min(least, glm::dvec3(p));
    most = glm::max(most, glm::dvec3(p));
  }
  return glm::length(most - least);
}

void measure(const std::string& path, std::size_t rounds, std::size_t most_energy, std::FILE* to) {
  const Executor executor, two(2);
  const Mesh mesh = welded_mesh(read_joined(path));
  const double percent = 100 / diagonal_of(mesh);
  const std::string name = std::filesystem::path(path).stem().string();
  const std::vector<Contestant> all = contestants(most_energy, two);
  for (const double ratio : ratios) {
    const auto triangles = static_cast<std::size_t>(ratio * static_cast<double>(mesh.triangles()));
    std::vector<std::vector<double>> times(all.size());
    std::vector<Mesh> left(all.size());
    for (std::size_t round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (mesh.triangles() > all[i].most || (all[i].once && round > 0)) continue;
        left[i] = all[i].run(mesh, triangles, times[i].emplace_back());
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (times[i].empty()) continue;
      const Errors found = errors(mesh, left[i], executor);
      fmt::print(to, "{}\t{}\t{}\t{}\t{}\t{:.6f}\t{:.6f}\t{:.6f}\n", name, mesh.triangles(), all[i].name, ratio,
                 left[i].triangles(), percent * found.rms, percent * found.largest, median(times[i]));
      std::fflush(to);
    }
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  std::size_t rounds = 7, most_energy = 7000;
  std::FILE* to = stdout;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string value = word.substr(std::min(word.size(), word.find('=') + 1));
    if (word.starts_with("--rounds=")) {
      rounds = std::stoul(value);
    } else if (word.starts_with("--most-energy=")) {
      most_energy = std::stoul(value);
    } else if (word.starts_with("--tsv=")) {
      to = std::fopen(value.c_str(), "w");
    } else {
      files.push_back(word);
    }
  }
  if (to == nullptr) throw std::runtime_error("the file of figures can not be written");
  fmt::print(to, "mesh\ttriangles\tsimplifier\tkept\tleft\trms\tlargest\tseconds\n");
  for (const std::string& file : files) foredraw::bench::measure(file, rounds, most_energy, to);
  return 0;
}
