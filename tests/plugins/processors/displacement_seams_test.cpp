#include "plugins/processors/displacement_seams/displacement_seams.h"

#include "support/meshes.h"
#include "support/uv_charts.h"

#include <foredraw/io/scene_file.h>

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <set>
#include <thread>

namespace foredraw::displacement_seams_test {
namespace {

using namespace testing;

/// The map with its new texels, if there are any.
Map repaired_map(const Map& map, const RepairedMap& repaired) {
  Map now = map;
  if (!repaired.texels.empty()) now.texels = repaired.texels;
  return now;
}

/// Repairs, and holds what is promised against a second opinion. The repaired map.
Map expect_repaired(const Charts& charts, const Map& map, const DisplacementSeamsOptions& options = {}) {
  const RepairedMap repaired = displacement_seams(charts.seams(), map.view(), options);
  const Map now = repaired_map(map, repaired);
  const Opinion before = opinion(charts.mesh(), map, static_cast<int>(options.bits));
  const Opinion after = opinion(charts.mesh(), now, static_cast<int>(options.bits));
  EXPECT_GT(before.unequal, 0u);
  EXPECT_EQ(after.unequal, 0u);
  EXPECT_EQ(repaired.unequal_after, 0u);
  EXPECT_EQ(repaired.factors, repaired.rule);
  EXPECT_TRUE(displacement_seams(charts.seams(), now.view(), options).texels.empty()) << "a second run";
  return now;
}

/// Texels with a weight at any of 4001 places on any side of a seam.
std::set<std::size_t> texels_along_seams(const Charts& charts, const Map& map) {
  std::set<std::size_t> texels;
  for (const auto& [ends, sides] : edges_of(charts.mesh())) {
    for (const auto& side : sides) {
      if (side == sides.front() && sides.size() == 2 && sides[0] == sides[1]) continue;
      for (int k = 0; k <= 4000; ++k) {
        const glm::dvec2 at = glm::dvec2(side[0]) + (glm::dvec2(side[1]) - glm::dvec2(side[0])) * (k / 4000.0);
        // 1/256 texel to all sides, for places are rounded to these
        for (const double reach : {-1 / 256.0, 1 / 256.0}) {
          const double x = std::floor(at.x * map.width - 0.5 + reach), y = std::floor(at.y * map.height - 0.5 + reach);
          for (int i = 0; i < 4; ++i) {
            texels.insert(static_cast<std::size_t>(
                walked(static_cast<std::int64_t>(y) + i / 2, map.height, map.wrap[1]) * map.width +
                walked(static_cast<std::int64_t>(x) + i % 2, map.width, map.wrap[0])));
          }
        }
      }
    }
  }
  return texels;
}

TEST(DisplacementSeams, OfChartsThatAreTurnedMirroredAndStretchedAreEqual) {
  const Charts charts = cube_sphere(6, turned_places());
  const Map map = noise_map(256, 256, 1);
  const Map now = expect_repaired(charts, map);
  const Opinion before = opinion(charts.mesh(), map), after = opinion(charts.mesh(), now);
  EXPECT_EQ(after.edges, 72u);
  EXPECT_GT(before.largest, 0.7);
  EXPECT_LT(after.largest, 0.01) << "even of noise, from texel to texel";
  EXPECT_LT(after.rms, 0.0005);
  EXPECT_GT(before.at_factors, 0.7);
  EXPECT_LT(after.at_factors, 0.0001) << "of floats";
}

TEST(DisplacementSeams, LeavesTexelsAsideAsTheyWere) {
  const Charts charts = cube_sphere(4, turned_places());
  Map map = noise_map(128, 160, 2);
  for (std::uint16_t& texel : map.texels) texel = static_cast<std::uint16_t>(20000 + texel / 4);  // room on both sides
  const RepairedMap repaired = displacement_seams(charts.seams(), map.view());
  ASSERT_EQ(repaired.at_zero, 0);
  ASSERT_EQ(repaired.at_one, 1);
  const std::set<std::size_t> along = texels_along_seams(charts, map);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < map.texels.size(); ++i) {
    if (repaired.texels[i] == map.texels[i]) continue;
    ++changed;
    EXPECT_TRUE(along.contains(i)) << i;
    EXPECT_TRUE(std::ranges::binary_search(repaired.seam_texels, i)) << i;
  }
  EXPECT_GT(changed, 100u);
  EXPECT_LE(repaired.seam_texels.size(), along.size());
}

/// A texel's height before is at_zero + (at_one - at_zero) * its height now.
TEST(DisplacementSeams, ScalesTheWholeMapWhereASolutionLeavesItsRange) {
  const Charts charts = cube_sphere(4, turned_places());
  Map map = noise_map(128, 128, 3, 1);
  for (std::uint16_t& texel : map.texels) texel = texel == 0 ? 0 : 65535;
  const RepairedMap repaired = displacement_seams(charts.seams(), map.view());
  EXPECT_LT(repaired.at_zero, 0);
  EXPECT_GT(repaired.at_one, 1);
  const std::set<std::uint32_t> changed(repaired.seam_texels.begin(), repaired.seam_texels.end());
  for (std::uint32_t i = 0; i < map.texels.size(); ++i) {
    if (changed.contains(i)) continue;
    const double back = repaired.at_zero + (repaired.at_one - repaired.at_zero) * repaired.texels[i] / 65535.0;
    EXPECT_NEAR(back, map.texels[i] / 65535.0, (repaired.at_one - repaired.at_zero) * 0.51 / 65535);
  }
  expect_repaired(charts, map);
}

TEST(DisplacementSeams, OfChartsThatLieOnEachOtherAreEqual) {
  auto places = turned_places();
  places[1] = places[0];
  places[1].along_u = -places[0].along_u;
  places[4] = places[3];
  places[5].middle = places[2].middle + glm::vec2(.02f, .01f);
  expect_repaired(cube_sphere(4, places), noise_map(256, 256, 4));
}

TEST(DisplacementSeams, AreEqualHoweverTheMapWraps) {
  auto places = turned_places();
  places[0].middle = {.02f, .03f};  // over the edge
  places[3].middle = {-1.4f, 2.3f};
  places[5].middle = {1.0f, .99f};
  for (const std::uint8_t across : {0, 1, 2}) {
    for (const std::uint8_t down : {0, 1, 2}) {
      Map map = noise_map(200, 128, 5);
      map.wrap = {across, down};
      SCOPED_TRACE(int{across} * 10 + down);
      expect_repaired(cube_sphere(3, places), map);
    }
  }
}

TEST(DisplacementSeams, AreEqualWhereATexelIsNotBlended) {
  Map map = noise_map(128, 128, 6);
  map.is_nearest = true;
  expect_repaired(cube_sphere(4, turned_places()), map, {.bits = 16});
}

TEST(DisplacementSeams, AreEqualInAsManyBitsAsAreAskedFor) {
  for (const std::uint32_t bits : {8u, 12u, 14u, 16u}) {
    SCOPED_TRACE(bits);
    expect_repaired(cube_sphere(4, turned_places()), noise_map(256, 256, 7), {.bits = bits});
  }
}

/// Dozens of corners in four texels.
TEST(DisplacementSeams, OfChartsSmallerThanATexelAreEqual) {
  auto places = turned_places();
  places[3] = {{.2001f, .6001f}, {.002f, .0005f}, {-.0005f, .003f}};
  places[5] = {{.8f, .8f}, {.0001f, .0002f}, {-.0003f, .0001f}};
  const Charts charts = cube_sphere(12, places);
  for (const std::uint32_t size : {64u, 256u, 1024u}) {
    SCOPED_TRACE(size);
    expect_repaired(charts, noise_map(size, size, size));
  }
}

TEST(DisplacementSeams, OfMapsOfFewTexelsAreEqual) {
  const Charts charts = cube_sphere(3, turned_places());
  const Map one = noise_map(1, 1, 8);
  EXPECT_TRUE(displacement_seams(charts.seams(), one.view()).texels.empty()) << "it has one height";
  expect_repaired(charts, noise_map(1, 7, 9));
  expect_repaired(charts, noise_map(2, 2, 10));
  expect_repaired(charts, noise_map(5, 1, 11));
}

TEST(DisplacementSeams, OfWhatIsEqualAlreadyStay) {
  const Charts charts = cube_sphere(4, turned_places());
  Map flat = noise_map(64, 64, 1, 0);
  std::ranges::fill(flat.texels, std::uint16_t{40000});
  const RepairedMap repaired = displacement_seams(charts.seams(), flat.view());
  EXPECT_TRUE(repaired.texels.empty());
  EXPECT_GT(repaired.points, 0u);
  EXPECT_EQ(repaired.factors, repaired.rule);
}

TEST(DisplacementSeams, BearAnything) {
  Charts charts = cube_sphere(3, turned_places());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Map map = noise_map(64, 64, 12);
  for (const float odd : {nan, 1e30f, -1e30f, 3e7f, std::numeric_limits<float>::infinity(), 1e-40f}) {
    Charts damaged = charts;
    for (std::size_t v = 0; v < damaged.uvs.size(); v += 5) damaged.uvs[v].x = odd;
    const RepairedMap repaired = displacement_seams(damaged.seams(), map.view());
    EXPECT_LT(repaired.unequal_after, repaired.unequal_before) << odd;
    displacement_seams(damaged.seams(), map.view(), {.method = SeamMethod::average});
  }
  for (glm::vec2& uv : charts.uvs) uv = {.5f, .5f};  // no seam is left
  EXPECT_TRUE(displacement_seams(charts.seams(), map.view()).texels.empty());
  EXPECT_TRUE(displacement_seams(charts.seams(), {nullptr, 0, 0, {0, 0}, 0}).texels.empty());
  EXPECT_TRUE(displacement_seams({}, map.view()).texels.empty());
}

TEST(DisplacementSeams, EndWhenTheyAreCancelled) {
  const std::atomic<bool> cancel = true;
  const RepairedMap left =
      displacement_seams(cube_sphere(3, turned_places()).seams(), noise_map(256, 256, 12).view(), {.cancel = &cancel});
  EXPECT_TRUE(left.texels.empty());
  EXPECT_GT(left.unequal_after, 0u);
}

/// Of a sliver a million times as long as it is wide, beside a whole chart.
TEST(DisplacementSeams, BearSidesOfVeryUnlikeLength) {
  auto places = turned_places();
  places[3] = {{.2f, .6f}, {.2f, 0}, {0, 2e-7f}};
  expect_repaired(cube_sphere(3, places), noise_map(256, 256, 13));
}

/// Fifty triangles around one point, each in a chart of its own: a corner has fifty texture coordinates.
TEST(DisplacementSeams, OfAPointWithFiftyPlacesAreEqual) {
  Charts fan;
  constexpr int parts = 50;
  const auto around = [](int i) {
    const float angle = 6.2831853f * static_cast<float>(i % parts) / parts;
    return glm::vec3(std::cos(angle), std::sin(angle), 0);
  };
  Random random(19);
  for (int i = 0; i < parts; ++i) {
    const auto first = static_cast<std::uint32_t>(fan.positions.size());
    const glm::vec2 middle((static_cast<float>(i % 8) + 0.5f) / 8, (static_cast<float>(i / 8) + 0.5f) / 8);
    const float turn = static_cast<float>(6.28 * random.unit());
    for (int c = 0; c < 3; ++c) {
      fan.positions.push_back(c == 0 ? glm::vec3(0) : around(i + c - 1));
      const float angle = turn + 2.1f * static_cast<float>(c);
      fan.uvs.push_back(middle + 0.05f * glm::vec2(std::cos(angle), std::sin(angle)));
      fan.indices.push_back(first + static_cast<std::uint32_t>(c));
    }
  }
  const SeamEdges seams = fan.seams();
  EXPECT_EQ(seams.seams, 50u);
  const auto most = std::ranges::max_element(seams.corners, {}, &UvCorner::uv_count);
  EXPECT_EQ(most->uv_count, 50u);
  expect_repaired(fan, noise_map(512, 512, 20));
}

/// A million rounds take an hour, which no test may: no loop of either method goes on.
TEST(DisplacementSeams, OfLargeMapsEndAfterTheyAreCancelled) {
  const SeamEdges seams = cube_sphere(24, turned_places()).seams();
  const Map map = noise_map(2048, 2048, 21);
  for (const SeamMethod method : {SeamMethod::exact, SeamMethod::average}) {
    std::atomic<bool> cancel = false;
    std::thread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      cancel = true;
    });
    const RepairedMap left =
        displacement_seams(seams, map.view(), {.method = method, .iterations = 1000000, .cancel = &cancel});
    later.join();
    EXPECT_TRUE(left.texels.empty());
  }
}

TEST(DisplacementSeams, AreTheSameBytesAgain) {
  const Charts charts = cube_sphere(5, turned_places());
  const Map map = noise_map(128, 128, 14);
  EXPECT_EQ(displacement_seams(charts.seams(), map.view()).texels,
            displacement_seams(charts.seams(), map.view()).texels);
}

/// What the paper does, and where it stands still.
TEST(AveragedSeams, ComeNearerAndStall) {
  const Charts charts = cube_sphere(6, turned_places());
  const Map map = noise_map(256, 256, 15);
  const auto after = [&](int iterations) {
    const auto repaired =
        displacement_seams(charts.seams(), map.view(), {.method = SeamMethod::average, .iterations = iterations});
    return opinion(charts.mesh(), repaired_map(map, repaired));
  };
  const Opinion raw = opinion(charts.mesh(), map), once = after(1), often = after(20), very_often = after(100);
  EXPECT_LT(once.rms, 0.9 * raw.rms);
  EXPECT_LT(often.rms, once.rms);
  EXPECT_GT(very_often.rms, 0.7 * often.rms);
  EXPECT_GT(very_often.largest, 0.2);
  EXPECT_GT(very_often.unequal, very_often.points / 2);
}

Charts draws_of(const Scene& scene, std::size_t draw) {
  Charts charts;
  const Level& level = scene.draws[draw].full();
  charts.positions = decode_vec3(*level.vertices->find("POSITION"));
  for (const glm::vec3& uv : decode_vec3(*level.vertices->find("TEXCOORD_0"))) charts.uvs.emplace_back(uv);
  const auto indices = level.stream().indices.view();
  charts.indices.assign(indices.begin(), indices.end());
  return charts;
}

Scene corpus_scene(const char* file) {
  Diagnostics diagnostics;
  return read_scene(project_file(std::string("benchmarks/corpus/") + file).string(), diagnostics)->scene;
}

/// An edge between two vertices that have several uvs each need not be a seam.
TEST(SeamEdgesOfModels, AreFewerThanEdgesOfVerticesWithSeveralUvs) {
  const Scene helmet = corpus_scene("static/flight_helmet_notex.glb");
  const auto by_vertices = [](const Charts& charts) {
    std::map<Point, std::set<std::array<float, 2>>> uvs;
    for (const std::uint32_t v : charts.indices) {
      uvs[point_of(charts.positions[v])].insert({charts.uvs[v].x, charts.uvs[v].y});
    }
    std::size_t edges = 0;
    for (const auto& [ends, sides] : edges_of(charts.mesh())) {
      if (uvs[ends[0]].size() > 1 && uvs[ends[1]].size() > 1) ++edges;
    }
    return edges;
  };
  const Charts metal = draws_of(helmet, 3), leather = draws_of(helmet, 4);
  EXPECT_EQ(leather.seams().seams, 1580u);
  EXPECT_EQ(by_vertices(leather), 2509u);
  EXPECT_EQ(metal.seams().seams, 3448u);
  EXPECT_EQ(by_vertices(metal), 5594u);
  EXPECT_EQ(draws_of(corpus_scene("static/head.glb"), 0).seams().seams, 375u);
}

TEST(DisplacementSeams, OfModelsWithNoiseAreEqual) {
  expect_repaired(draws_of(corpus_scene("static/head.glb"), 0), noise_map(512, 512, 16));
  expect_repaired(draws_of(corpus_scene("animated/cesium_man_notex.glb"), 0), noise_map(512, 512, 17));
  expect_repaired(draws_of(corpus_scene("static/spot.glb"), 0), noise_map(512, 512, 22));
  expect_repaired(draws_of(corpus_scene("animated/fox.glb"), 0), noise_map(512, 512, 23));
  const Charts metal = draws_of(corpus_scene("static/flight_helmet_notex.glb"), 3);
  expect_repaired(metal, noise_map(1024, 1024, 18));
}

}  // namespace
}  // namespace foredraw::displacement_seams_test
