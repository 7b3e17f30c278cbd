#include "plugins/processors/displacement_seams/gutter.h"

#include "support/displaced.h"
#include "support/staged.h"
#include "support/uv_charts.h"

#include <gtest/gtest.h>

#include <limits>

namespace foredraw::displacement_seams_gutter_test {
namespace {

using namespace testing;

std::vector<UvTriangle> triangles_of(const Charts& charts) {
  std::vector<UvTriangle> triangles;
  for (std::size_t i = 0; i < charts.indices.size(); i += 3) {
    UvTriangle& of = triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) of[c] = charts.uvs[charts.indices[i + c]];
  }
  return triangles;
}

/// Which texels bilinear filtering reads at many places of all triangles: a second opinion.
std::vector<bool> read_texels(const Charts& charts, const testing::Map& map) {
  std::vector<bool> is_read(map.texels.size(), false);
  constexpr int steps = 40;
  for (const UvTriangle& of : triangles_of(charts)) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const glm::dvec2 uv = (of[0] * double(i) + of[1] * double(j) + of[2] * double(steps - i - j)) / double(steps);
        const double x = uv.x * map.width - 0.5, y = uv.y * map.height - 0.5;
        for (int k = 0; k < 4; ++k) {
          const auto column = walked(static_cast<std::int64_t>(std::floor(x)) + k % 2, map.width, map.wrap[0]);
          const auto row = walked(static_cast<std::int64_t>(std::floor(y)) + k / 2, map.height, map.wrap[1]);
          is_read[static_cast<std::size_t>(row * map.width + column)] = true;
        }
      }
    }
  }
  return is_read;
}

TEST(Gutter, LeavesWhatTrianglesReadAndSaysTheSameBesideThem) {
  const Charts charts = cube_sphere(3, turned_places());
  for (const std::uint8_t wrap : {FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_CLAMPED}) {
    testing::Map map = noise_map(96, 96, 5);
    map.wrap = {wrap, wrap};
    const std::vector<bool> is_read = read_texels(charts, map);
    std::vector<std::uint16_t> texels = map.texels;
    for (std::size_t t = 0; t < texels.size(); ++t) {
      if (is_read[t]) texels[t] = 40000;  // all charts say that
    }
    const std::vector<std::uint16_t> before = texels;
    EXPECT_GT(fill_gutter(texels, map.view(), triangles_of(charts), 3), 100u);
    std::size_t beside = 0, kept = 0;
    for (std::size_t t = 0; t < texels.size(); ++t) {
      if (is_read[t]) EXPECT_EQ(texels[t], before[t]);
      if (texels[t] == before[t]) ++kept;
      if (!is_read[t] && texels[t] == 40000) ++beside;
    }
    EXPECT_GT(beside, 100u);
    EXPECT_GT(kept, texels.size() / 3) << "what lies farther away stays";
    EXPECT_EQ(fill_gutter(texels, map.view(), triangles_of(charts), 3), 0u) << "a second time";
  }
}

TEST(Gutter, OfTrianglesThatGoAroundTheMapIsNone) {
  testing::Map map = noise_map(16, 16, 6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::uint16_t> texels = map.texels;
  EXPECT_EQ(fill_gutter(texels, map.view(), std::vector<UvTriangle>{{{{-40, 0}, {40, 3}, {0, 1e30}}}}, 4), 0u);
  EXPECT_EQ(fill_gutter(texels, map.view(), std::vector<UvTriangle>{{{{nan, 0}, {0, 3}, {0, 1}}}}, 4), 0u);
  EXPECT_EQ(fill_gutter(texels, map.view(), {}, 4), 0u);
  EXPECT_EQ(texels, map.texels);
}

TEST(Gutter, IsFilledWhereTheStageIsAskedTo) {
  const Charts charts = cube_sphere(3, turned_places());
  const testing::Map map = noise_map(96, 96, 7);
  const auto image = [&] { return height_image(96, 96, [&](auto x, auto y) { return map.texels[96 * y + x]; }); };
  const Scene scene = displaced_scene({charts.positions, charts.indices}, charts.uvs, image(), 0.2f);
  const auto texels_after = [&](const char* stage, const Scene& from) {
    const Scene made = run(stage, from).scene;
    const auto bytes = made.images[*made.materials[0].displacement->texture.image].bytes.view();
    std::vector<std::uint16_t> texels(bytes.size() / 2);
    std::memcpy(texels.data(), bytes.data(), bytes.size());
    return std::pair(texels, made);
  };
  const auto [plain, without] = texels_after("displacement-seams", scene);
  const auto [filled, with] = texels_after("displacement-seams(gutter=2)", scene);
  const std::vector<bool> is_read = read_texels(charts, map);
  std::size_t differ = 0;
  for (std::size_t t = 0; t < plain.size(); ++t) {
    if (plain[t] == filled[t]) continue;
    EXPECT_FALSE(is_read[t]);
    ++differ;
  }
  EXPECT_GT(differ, 100u);
  EXPECT_EQ(run("displacement-seams(gutter=2)", with).scene.images.size(), with.images.size()) << "a second run";
}

}  // namespace
}  // namespace foredraw::displacement_seams_gutter_test
