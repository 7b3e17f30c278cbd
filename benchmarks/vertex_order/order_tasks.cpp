#include "order_tasks.h"

#include <fmt/format.h>

#include <array>

namespace foredraw::bench {

namespace {

constexpr const char* sizes[] = {"below 10k", "10k to 300k", "above 800k"};

const char* size_of(const TestMesh& mesh) {
  const std::size_t triangles = mesh.indices.size() / 3;
  return sizes[(triangles >= 10'000) + (triangles > 300'000)];
}

/// All in their own order.
std::vector<OrderTask> unmixed_tasks() {
  std::vector<OrderTask> tasks{{sizes[0], "own", {"corpus, small", {}}}, {sizes[1], "own", {"corpus, large", {}}}};
  for (TestMesh& mesh : corpus().meshes) {
    tasks[size_of(mesh) == sizes[0] ? 0 : 1].set.meshes.push_back(std::move(mesh));
  }
  for (const auto& [model, levels] : {std::pair{"static/spot.glb", std::vector{0, 2, 4}},
                                      {"static/head.glb", {0, 2, 3}},
                                      {"animated/mannequiny.glb", {0, 2, 3}},
                                      {"animated/cesium_man_notex.glb", {0, 2, 4}}}) {
    for (const MeshSet& set : subdivisions(model, levels)) tasks.push_back({size_of(set.meshes[0]), "own", set});
  }
  for (const Grid& grid : grids) {
    tasks.push_back({"grid", "own", {grid.name(), {testing::grid(grid.columns, grid.rows)}}});
  }
  return tasks;
}

}  // namespace

std::string Grid::name() const { return fmt::format("grid {}x{}", columns, rows); }

std::vector<OrderTask> order_tasks(std::size_t most_triangles) {
  std::vector<OrderTask> tasks;
  for (const OrderTask& task : unmixed_tasks()) {
    if (task.set.meshes[0].indices.size() / 3 > most_triangles) continue;
    std::vector<MeshSet> sets = arrangements(task.set);
    for (std::size_t i = 0; i < 3; ++i) {
      const char* arrangement = std::array{"own", "t", "tv"}[i];
      tasks.push_back({task.size, arrangement, {task.set.name, std::move(sets[i].meshes)}});
    }
  }
  return tasks;
}

}  // namespace foredraw::bench
