#include "plugins/processors/displacement_seams/displacement_seams.h"

#include "support/uv_charts.h"

#include <foredraw/displaced/seam_table.h>

#include <gtest/gtest.h>

namespace foredraw::displacement_seams_table_test {
namespace {

using namespace testing;

/// What a triangle reads at a place of one of its edges, from the table on seams.
struct Reader {
  const Charts& charts;
  const testing::Map& map;
  const SeamTable& table;

  std::array<std::int32_t, 2> place_of(std::uint32_t vertex) const {
    return {foredraw_height_place(charts.uvs[vertex].x, map.width),
            foredraw_height_place(charts.uvs[vertex].y, map.height)};
  }

  std::uint32_t height(std::uint32_t side, std::uint32_t place) const {
    const foredraw_height_map view = map.view();
    const std::uint32_t from = charts.indices[side], to = charts.indices[side % 3 == 2 ? side - 2 : side + 1];
    const auto a = place_of(from), b = place_of(to);
    const auto& sides = table.sides[0];
    if (const auto* found = foredraw_seam_side_of(sides.data(), sides.size(), side)) {
      const std::uint32_t ends[2] = {foredraw_displaced_height(&view, a[0], a[1], 14),
                                     foredraw_displaced_height(&view, b[0], b[1], 14)};
      const foredraw_seam_table of = table.view();
      return foredraw_seam_height(&of, found, ends, place, 14);
    }
    const std::uint32_t weights[3] = {65536 - place, place, 0};
    const std::int32_t x[3] = {a[0], b[0], 0}, y[3] = {a[1], b[1], 0};
    return foredraw_displaced_height(&view, foredraw_height_between(x, weights), foredraw_height_between(y, weights),
                                     14);
  }
};

struct SideOfEdge {
  std::uint32_t side;
  bool is_turned;
};

std::map<std::array<Point, 2>, std::vector<SideOfEdge>> sides_of(const Charts& charts) {
  std::map<std::array<Point, 2>, std::vector<SideOfEdge>> edges;
  for (std::uint32_t i = 0; i < charts.indices.size(); ++i) {
    const Point p = point_of(charts.positions[charts.indices[i]]);
    const Point q = point_of(charts.positions[charts.indices[i % 3 == 2 ? i - 2 : i + 1]]);
    edges[{std::min(p, q), std::max(p, q)}].push_back({i, q < p});
  }
  return edges;
}

/// At any factor, whole or not: at every place that a tessellator could choose.
TEST(SeamTable, IsEqualOnBothSidesEverywhere) {
  const Charts charts = cube_sphere(4, turned_places());
  testing::Map map = noise_map(200, 150, 1);
  map.texels = displacement_seams(charts.seams(), map.view()).texels;
  const SeamEdges seams = charts.seams();
  const SeamTable table = seam_table(seams, map.view(), 1);
  const foredraw_seam_table view = table.view();
  ASSERT_TRUE(foredraw_seam_table_is_sound(&view));
  EXPECT_EQ(table.firsts.size(), seams.seams);
  EXPECT_EQ(table.sides[0].size(), 2 * seams.seams);
  const Reader reader{charts, map, table};
  for (const auto& [ends, sides] : sides_of(charts)) {
    ASSERT_EQ(sides.size(), 2u);
    for (std::uint32_t place = 0; place <= 65536; place += 331) {
      const auto height = [&](const SideOfEdge& s) {
        return reader.height(s.side, s.is_turned ? 65536 - place : place);
      };
      EXPECT_EQ(height(sides[0]), height(sides[1]));
    }
  }
}

/// Of a repaired map it is what the map says where the map is exact, so that surfaces do not change there.
TEST(SeamTable, IsTheMapAtTheFactorsOfTheEdges) {
  const Charts charts = cube_sphere(4, turned_places());
  testing::Map map = noise_map(256, 256, 2);
  map.texels = displacement_seams(charts.seams(), map.view()).texels;
  const SeamTable table = seam_table(charts.seams(), map.view(), 1);
  SeamTable none = table;
  none.sides[0].clear();
  const Reader by_table{charts, map, table}, by_map{charts, map, none};
  std::size_t compared = 0;
  for (const foredraw_seam_side& side : table.sides[0]) {
    const std::uint32_t parts = 1u << table.parts_log2[side.edge / 2];
    for (std::uint32_t k = 0; k <= parts; ++k, ++compared) {
      EXPECT_EQ(by_table.height(side.side, 65536 / parts * k), by_map.height(side.side, 65536 / parts * k));
    }
  }
  EXPECT_GT(compared, 500u);
}

TEST(SeamTable, OfNothingIsEmpty) {
  const testing::Map map = noise_map(2, 2, 3);
  const SeamTable table = seam_table({}, map.view(), 3);
  EXPECT_EQ(table.stored_bytes(), 0u);
  EXPECT_EQ(table.sides.size(), 3u);
  const foredraw_seam_table view = table.view();
  EXPECT_TRUE(foredraw_seam_table_is_sound(&view));
}

}  // namespace
}  // namespace foredraw::displacement_seams_table_test
