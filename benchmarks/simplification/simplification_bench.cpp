// Our simplifier against a newer meshoptimizer's that moves vertices (meshopt_simplifyWithUpdate), positions alone:
// vertices at one place are one, attribute weights are 0, and the peer has no error limit. Both are asked for the same
// number of triangles. Every round does both, so that a noisy moment hits both; times are of the processor, one thread,
// and ratios are medians of seven rounds'. Distances are ours, measured alike for both: rms of 200,000 points of each
// surface, and the largest distance, proved within 2 per cent.
//   simplification-bench FILES     a table of files (glTF, OBJ, PLY, ...), each as one mesh

#include "measured.h"

#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/replay.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <array>
#include <filesystem>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 7;
constexpr std::array ratios{0.5, 0.25, 0.1, 0.02};

struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  std::size_t triangles() const { return indices.size() / 3; }
  Surface surface() const { return {positions, indices}; }
};

/// All triangles of the file, in the draws' own spaces.
Mesh mesh_of(const std::string& path) {
  const JoinedMesh joined = read_joined(path);
  const std::vector<std::uint32_t> first = welded(joined.positions);
  Mesh mesh;
  std::vector<std::uint32_t> number(first.size(), ~0u);
  for (std::size_t i = 0; i + 2 < joined.indices.size(); i += 3) {
    const std::array corners{first[joined.indices[i]], first[joined.indices[i + 1]], first[joined.indices[i + 2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (const std::uint32_t v : corners) {
      if (number[v] == ~0u) {
        number[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(joined.positions[v]);
      }
      mesh.indices.push_back(number[v]);
    }
  }
  return mesh;
}

Mesh ours(const Mesh& mesh, std::size_t triangles, double& time) {
  CollapseSequence sequence;
  time = seconds_of([&] { sequence = quadric_collapse(mesh.positions, mesh.indices, {.least = triangles}); });
  const Collapsed after = collapsed(sequence, sequence.collapses.size(), mesh.positions, mesh.indices);
  return {after.places, after.indices};
}

Mesh peers(const Mesh& mesh, std::size_t triangles, double& time) {
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
  const ClosestPoints a(from.surface()), b(to.surface());
  return {surface_distance(from.surface(), to.surface(), {200'000, 1}, executor)->rms,
          hausdorff_distance({from.surface(), a}, {to.surface(), b}, {}, executor)->bound};
}

/// Ratios, ours to the peer's, over all files.
struct Ratios {
  std::vector<double> rms, largest, time;
};

void measure(const std::string& path, std::array<Ratios, ratios.size()>& all, std::vector<double>& chains) {
  const Executor executor;
  const Mesh mesh = mesh_of(path);
  const std::string name = std::filesystem::path(path).stem().string();
  std::array<std::vector<double>, ratios.size()> own_times, times;
  std::vector<double> chain;
  for (std::size_t r = 0; r < rounds; ++r) {
    double of_peer = 0, own = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const auto triangles = static_cast<std::size_t>(ratios[i] * static_cast<double>(mesh.triangles()));
      double peer = 0;
      peers(mesh, triangles, peer);
      ours(mesh, triangles, own);
      times[i].push_back(own / peer);
      own_times[i].push_back(own);
      of_peer += peer;
    }
    chain.push_back(own / of_peer);  // the coarsest has them all
  }
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto triangles = static_cast<std::size_t>(ratios[i] * static_cast<double>(mesh.triangles()));
    double unused = 0;
    const Mesh own = ours(mesh, triangles, unused), peer = peers(mesh, triangles, unused);
    const Errors of_ours = errors(mesh, own, executor), of_peer = errors(mesh, peer, executor);
    all[i].rms.push_back(of_ours.rms / of_peer.rms);
    all[i].largest.push_back(of_ours.largest / of_peer.largest);
    all[i].time.push_back(median(times[i]));
    fmt::print("| {} | {} | {:.0f} % | {} / {} | {:.3f} | {:.3f} | {:.2f} | {:.1f} |\n", name, mesh.triangles(),
               100 * ratios[i], own.triangles(), peer.triangles(), all[i].rms.back(), all[i].largest.back(),
               all[i].time.back(), 1000 * median(own_times[i]));
    std::fflush(stdout);
  }
  chains.push_back(median(chain));
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::array<Ratios, ratios.size()> all;
  std::vector<double> chains;
  fmt::print("| mesh | triangles | kept | left, ours / peer | rms, ours / peer | largest | time | ours, ms |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (int i = 1; i < argc; ++i) measure(argv[i], all, chains);
  fmt::print("\n| kept | rms, mean (worst) | largest, mean (worst) | time, mean (worst) |\n|---:|---:|---:|---:|\n");
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto cell = [](const std::vector<double>& values) {
      return fmt::format("{:.3f} ({:.3f})", geometric_mean(values), *std::ranges::max_element(values));
    };
    fmt::print("| {:.0f} % | {} | {} | {} |\n", 100 * ratios[i], cell(all[i].rms), cell(all[i].largest),
               cell(all[i].time));
  }
  fmt::print("\nOne sequence for all four, beside four calls of the peer: {:.2f} times the time.\n",
             geometric_mean(chains));
  return 0;
}
