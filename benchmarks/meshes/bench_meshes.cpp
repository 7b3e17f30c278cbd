#include "bench_meshes.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/viewing/posed_positions.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace foredraw::bench {

namespace {

namespace fs = std::filesystem;

fs::path corpus_folder() { return testing::project_file("benchmarks/corpus"); }

/// The triangle draws of a model, one mesh each.
std::vector<TestMesh> meshes_of(const fs::path& path) {
  Diagnostics diagnostics;
  const auto file = read_scene(path.string(), diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  std::vector<TestMesh> meshes;
  for (DrawId d = 0; d < file->scene.draws.size(); ++d) {
    const Draw& draw = file->scene.draws[d];
    if (!draw.traits.has(traits::triangles)) continue;
    const auto indices = draw.levels[0].orders[0].indices.view();
    meshes.push_back({posed_positions(file->scene, {d, {}}, {}), {indices.begin(), indices.end()}});
  }
  return meshes;
}

/// One mesh whose vertices of equal position are one, as subdivision would tear it at its seams.
TestMesh welded(const std::vector<TestMesh>& meshes) {
  TestMesh all;
  for (const TestMesh& mesh : meshes) all = all.indices.empty() ? mesh : testing::joined(all, mesh);
  std::vector<std::uint32_t> by_position(all.positions.size());
  std::iota(by_position.begin(), by_position.end(), 0u);
  const auto key = [&](std::uint32_t v) {
    return std::tuple(all.positions[v].x, all.positions[v].y, all.positions[v].z);
  };
  std::ranges::stable_sort(by_position, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(all.positions.size());
  for (std::size_t i = 0; i < by_position.size(); ++i) {
    const bool again = i > 0 && key(by_position[i]) == key(by_position[i - 1]);
    first[by_position[i]] = again ? first[by_position[i - 1]] : by_position[i];
  }
  TestMesh result;
  std::vector<std::uint32_t> number(all.positions.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v) {
      number[v] = static_cast<std::uint32_t>(result.positions.size());
      result.positions.push_back(all.positions[v]);
    }
  }
  for (const std::uint32_t v : all.indices) result.indices.push_back(number[first[v]]);
  return result;
}

std::string short_count(std::size_t count) {
  return count < 1'000'000 ? fmt::format("{}k", (count + 500) / 1000)
                           : fmt::format("{:.1f}M", static_cast<double>(count) / 1e6);
}

}  // namespace

std::size_t MeshSet::triangles() const {
  std::size_t sum = 0;
  for (const TestMesh& mesh : meshes) sum += mesh.indices.size() / 3;
  return sum;
}

TestMesh subdivided(const TestMesh& mesh) {
  TestMesh result{mesh.positions, {}};
  result.indices.reserve(4 * mesh.indices.size());
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, is_new] =
        midpoints.try_emplace(std::uint64_t{low} << 32 | high, static_cast<std::uint32_t>(result.positions.size()));
    if (is_new) result.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5f);
    return found->second;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    result.indices.insert(result.indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return result;
}

TestMesh with_shuffled_vertices(const TestMesh& mesh, std::uint64_t seed) {
  std::vector<std::uint32_t> number(mesh.positions.size());
  std::iota(number.begin(), number.end(), 0u);
  Random random(seed);
  for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random.below(i)]);
  TestMesh result{std::vector<glm::vec3>(mesh.positions.size()), {}};
  for (std::size_t v = 0; v < number.size(); ++v) result.positions[number[v]] = mesh.positions[v];
  for (const std::uint32_t v : mesh.indices) result.indices.push_back(number[v]);
  return result;
}

std::vector<std::uint32_t> reordered(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> result(indices.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    std::copy_n(&indices[3 * std::size_t{order[t]}], 3, &result[3 * t]);
  }
  return result;
}

MeshSet corpus() {
  std::vector<fs::path> models;
  for (const auto& entry : fs::recursive_directory_iterator(corpus_folder())) {
    const fs::path extension = entry.path().extension();
    if (extension == ".glb" || extension == ".gltf") models.push_back(entry.path());
  }
  std::ranges::sort(models);
  MeshSet set{"corpus", {}};
  for (const fs::path& model : models) {
    for (TestMesh& mesh : meshes_of(model)) set.meshes.push_back(std::move(mesh));
  }
  return set;
}

MeshSet draws_of(const std::string& model) { return {model, meshes_of(corpus_folder() / model)}; }

std::vector<MeshSet> subdivisions(const std::string& model, const std::vector<int>& levels) {
  const fs::path path = corpus_folder() / model;
  TestMesh mesh = welded(meshes_of(path));
  std::vector<MeshSet> sets;
  int reached = 0;
  for (const int level : levels) {
    for (; reached < level; ++reached) mesh = subdivided(mesh);
    sets.push_back({fmt::format("{} {}", path.stem().string(), short_count(mesh.indices.size() / 3)), {mesh}});
  }
  return sets;
}

std::vector<MeshSet> arrangements(const MeshSet& set) {
  std::vector<MeshSet> result{set, {set.name + " /t", {}}, {set.name + " /tv", {}}};
  for (const TestMesh& mesh : set.meshes) {
    result[1].meshes.push_back(testing::shuffled(mesh, 1));
    result[2].meshes.push_back(with_shuffled_vertices(result[1].meshes.back(), 2));
  }
  return result;
}

}  // namespace foredraw::bench
