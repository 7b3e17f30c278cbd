// What levels cost where there are very many triangles.

#include "support/noisy_levels.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <optional>
#include <string>

namespace foredraw::tessellation_levels_growth_test {
namespace {

/// The largest peak over what was held, by the system's own count.
std::optional<double> peak_bytes(const std::function<void()>& work) {
  const auto line = [](const char* name) -> std::optional<double> {
    std::ifstream file("/proc/self/status");
    for (std::string text; std::getline(file, text);) {
      if (text.rfind(name, 0) == 0) return 1024 * std::stod(text.substr(std::string(name).size()));
    }
    return std::nullopt;
  };
  if (!(std::ofstream("/proc/self/clear_refs") << 5 << std::flush)) return std::nullopt;
  const auto before = line("VmRSS:");
  work();
  const auto peak = line("VmHWM:");
  return before && peak ? std::optional(*peak - *before) : std::nullopt;
}

/// With few texels to a triangle, as a mesh of very many has.
struct ManyTriangles {
  explicit ManyTriangles(std::uint32_t cells)
      : grid(testing::grid(cells, cells)),
        mesh(grid, testing::square_uv(grid, 100, 100), {512, 512, testing::noise(512, 3)}) {}

  ChosenLevels levels() const {
    const HeightPart part{mesh.mesh.positions, mesh.mesh.indices, mesh.places, mesh.sampled, 1};
    return tessellation_levels({&part, 1}, LevelMethod::content, {.triangles = 3 * grid.indices.size() / 3},
                               Executor(1));
  }

  testing::TestMesh grid;
  testing::NoisyMesh mesh;
};

TEST(TessellationLevelsGrowth, TakeAtMost150BytesATriangle) {
  const ManyTriangles many(400);
  ChosenLevels levels;
  const auto peak = peak_bytes([&] { levels = many.levels(); });
  EXPECT_GT(levels.chosen.triangles, 500'000u);
  if (!peak) GTEST_SKIP() << "the system does not say";
  RecordProperty("bytes-a-triangle", std::to_string(*peak / 320'000));
  EXPECT_LT(*peak / 320'000, 150);
  EXPECT_GT(*peak / 320'000, 50) << "nothing was counted";
}

}  // namespace
}  // namespace foredraw::tessellation_levels_growth_test
