// Our simplifier against a newer meshoptimizer's that moves vertices (meshopt_simplifyWithUpdate) on meshes with
// normals and texture coordinates. The peer's weights are those of its documentation, .5 for normals and 1 for texture
// coordinates, without an error limit; ours are the plugin's own. Both are asked for the same number of triangles.
// Errors are measured alike for both, on 200,000 points (--samples=) of each surface: rms of distances, of texture
// coordinates and of normals at nearest points. Times are of the processor, one thread, medians of seven rounds that do
// both.
//   attributes-bench FILES     a table of files, each as one mesh
//   attributes-bench --normals=.01 --texcoords=.1 FILES     with other weights
//   attributes-bench --solve=0 FILES                        blended along the edge instead of solved for
//   attributes-bench --endpoint=1 FILES                     vertices stay where they are; the peer's, too
//   attributes-bench --permissive=1 FILES                   the peer may collapse across seams

#include <benchmarks/meshes/one_mesh.h>
#include <evaluators/attribute_error/attribute_error.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/collapses/cut.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <cstring>
#include <filesystem>

namespace foredraw::bench {
namespace {

constexpr std::array ratios{0.5, 0.25, 0.1};

struct Carrying {
  std::vector<glm::vec3> positions, normals, uvs;
  std::vector<std::uint32_t> indices;

  AttributedSurface surface() const { return {{positions, indices}, uvs, normals}; }
};

std::vector<glm::vec3> carried(const JoinedMesh& mesh, std::string_view semantic) {
  std::vector<glm::vec3> all;
  for (const auto& vertices : mesh.streams) {
    const VertexStream* stream = vertices->find(semantic);
    if (stream == nullptr) return {};
    for (const glm::vec3& value : decode_vec3(*stream)) all.push_back(value);
  }
  return all;
}

Carrying whole(const JoinedMesh& mesh) {
  return {mesh.positions, carried(mesh, "NORMAL"), carried(mesh, "TEXCOORD_0"), mesh.indices};
}

struct Ours {
  AttributeWeights weights;
  bool solves = true;
  bool at_endpoints = false;
};

struct Peers {
  bool is_permissive = false;
  bool at_endpoints = false;
};

Carrying ours(const JoinedMesh& mesh, std::size_t triangles, const Ours& options, double& time) {
  CollapseSequence sequence;
  time = seconds_of([&] {
    const auto placement = options.at_endpoints ? CollapsePlacement::endpoint : CollapsePlacement::optimal;
    sequence = quadric_collapse(mesh.positions, mesh.indices,
                                {.placement = placement, .least = triangles, .solves = options.solves},
                                attribute_rows(mesh, options.weights));
  });
  const std::size_t all = sequence.collapses.size();
  const Collapsed after = collapsed(sequence, all, mesh);
  JoinedMesh left;
  for (const CutDraw& draw : cut(sequence, all, after, mesh)) {
    const auto first = static_cast<std::uint32_t>(left.positions.size());
    for (const glm::vec3& place : decode_vec3(*draw.vertices->find("POSITION"))) left.positions.push_back(place);
    for (const std::uint32_t index : draw.indices.view()) left.indices.push_back(first + index);
    left.streams.push_back(draw.vertices);
  }
  return whole(left);
}

Carrying peers(const Carrying& mesh, std::size_t triangles, const Peers& options, double& time) {
  std::vector<float> rows, weights;
  const std::size_t width = (mesh.normals.empty() ? 0 : 3) + (mesh.uvs.empty() ? 0 : 2);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.normals.empty()) rows.insert(rows.end(), {mesh.normals[v].x, mesh.normals[v].y, mesh.normals[v].z});
    if (!mesh.uvs.empty()) rows.insert(rows.end(), {mesh.uvs[v].x, mesh.uvs[v].y});
  }
  if (!mesh.normals.empty()) weights.insert(weights.end(), 3, 0.5f);
  if (!mesh.uvs.empty()) weights.insert(weights.end(), 2, 1.0f);
  Carrying left = mesh;
  std::size_t indices = 0;
  const unsigned int how = options.is_permissive ? meshopt_SimplifyPermissive : 0;
  time = seconds_of([&] {
    if (options.at_endpoints) {
      indices = meshopt_simplifyWithAttributes(left.indices.data(), mesh.indices.data(), left.indices.size(),
                                               &left.positions[0].x, left.positions.size(), sizeof(glm::vec3),
                                               rows.data(), width * sizeof(float), weights.data(), width, nullptr,
                                               3 * triangles, 1e30f, how, nullptr);
      return;
    }
    indices = meshopt_simplifyWithUpdate(left.indices.data(), left.indices.size(), &left.positions[0].x,
                                         left.positions.size(), sizeof(glm::vec3), rows.data(), width * sizeof(float),
                                         weights.data(), width, nullptr, 3 * triangles, 1e30f, how, nullptr);
  });
  left.indices.resize(indices);
  for (std::size_t v = 0; v < left.positions.size(); ++v) {
    const float* row = rows.data() + v * width;
    if (!mesh.normals.empty()) left.normals[v] = {row[0], row[1], row[2]}, row += 3;
    if (!mesh.uvs.empty()) left.uvs[v] = {row[0], row[1], 0};
  }
  return left;
}

struct Effort {
  std::size_t rounds = 7, samples = 200'000;
};

struct Errors {
  double rms = 0, uv = 0, normal = 0;
};

Errors errors(const Carrying& from, const Carrying& to, std::size_t samples, const Executor& executor) {
  const AttributeError found = attribute_error(to.surface(), from.surface(), {.samples = samples}, 1, executor).value();
  return {surface_distance(from.surface().surface, to.surface().surface, {samples, 1}, executor)->rms,
          found.uv() ? found.uv()->value : 0, found.normal() ? found.normal()->value : 0};
}

/// Ratios, ours to the peer's, over all files that carry it.
struct Ratios {
  std::vector<double> rms, uv, normal, time;
};

void measure(const std::string& path, const Ours& options, const Peers& of_peers, const Effort& effort,
             std::array<Ratios, ratios.size()>& all) {
  const Executor executor;
  const JoinedMesh mesh = read_joined(path);
  const Carrying original = whole(mesh);
  const std::string name = std::filesystem::path(path).stem().string();
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto triangles = static_cast<std::size_t>(ratios[i] * static_cast<double>(original.indices.size() / 3));
    std::vector<double> times;
    Carrying own, peer;
    for (std::size_t r = 0; r < effort.rounds; ++r) {
      double of_own = 0, of_peer = 0;
      own = ours(mesh, triangles, options, of_own);
      peer = peers(original, triangles, of_peers, of_peer);
      times.push_back(of_own / of_peer);
    }
    const Errors of_ours = errors(original, own, effort.samples, executor),
                 of_peer = errors(original, peer, effort.samples, executor);
    all[i].rms.push_back(of_ours.rms / of_peer.rms);
    all[i].time.push_back(median(times));
    if (of_peer.uv > 0) all[i].uv.push_back(of_ours.uv / of_peer.uv);
    if (of_peer.normal > 0) all[i].normal.push_back(of_ours.normal / of_peer.normal);
    fmt::print("| {} | {:.0f} % | {} / {} | {:.3f} | {:.4f} / {:.4f} | {:.2f} / {:.2f} | {:.2f} |\n", name,
               100 * ratios[i], own.indices.size() / 3, peer.indices.size() / 3, all[i].rms.back(), of_ours.uv,
               of_peer.uv, of_ours.normal, of_peer.normal, all[i].time.back());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::array<Ratios, ratios.size()> all;
  Ours options;
  Peers of_peers;
  Effort effort;
  fmt::print("| mesh | kept | left, ours / peer | rms, ours / peer | uv, ours / peer | normal, degrees | time |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|\n");
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto takes = [&](const std::string& name, auto& value) {
      if (!word.starts_with(name)) return false;
      value = static_cast<std::remove_reference_t<decltype(value)>>(std::stod(word.substr(name.size())));
      return true;
    };
    if (takes("--normals=", options.weights.normals) || takes("--texcoords=", options.weights.texcoords) ||
        takes("--solve=", options.solves) || takes("--rounds=", effort.rounds) || takes("--samples=", effort.samples) ||
        takes("--permissive=", of_peers.is_permissive) || takes("--endpoint=", options.at_endpoints)) {
      continue;
    }
    of_peers.at_endpoints = options.at_endpoints;
    measure(word, options, of_peers, effort, all);
  }
  fmt::print("\n| kept | rms, mean (worst) | uv | normals | time |\n|---:|---:|---:|---:|---:|\n");
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto cell = [](const std::vector<double>& values) {
      if (values.empty()) return std::string("-");
      return fmt::format("{:.3f} ({:.3f})", geometric_mean(values), *std::ranges::max_element(values));
    };
    fmt::print("| {:.0f} % | {} | {} | {} | {} |\n", 100 * ratios[i], cell(all[i].rms), cell(all[i].uv),
               cell(all[i].normal), cell(all[i].time));
  }
  return 0;
}
