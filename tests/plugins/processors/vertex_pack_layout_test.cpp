// Which layout is chosen, beside layouts that are made by chance.
#include "plugins/processors/vertex_pack/layout_search.h"

#include "support/packed_vertices.h"

#include <foredraw/packing/packed_precision.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw::vertex_pack_layout_test {
namespace {

using processors::vertex_pack::best_layout;
using processors::vertex_pack::Demand;

/// E of the layout: how far a displaced point is off at most.
double displaced_error(const PackedLayout& layout, const Demand& demand) {
  const PackedBounds bounds = packed_bounds(layout);
  return bounds.position + demand.displacement * bounds.normal / 57.29577951308232 +
         demand.slope * std::hypot(bounds.u, bounds.v);
}

Demand random_demand(Random& random) {
  Demand demand = testing::unit_demand();
  demand.box = {};
  const double size = std::pow(10.0, 6 * random.unit() - 3);
  const glm::dvec3 corner(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
  const glm::dvec3 extent(0.05 + random.unit(), 0.05 + random.unit(), 0.05 + random.unit());
  for (const double along : {0.0, 1.0}) demand.box.add(glm::dvec3(glm::vec3((corner + along * extent) * size)));
  demand.displacement = demand.box.diagonal() * std::pow(10.0, 2 * random.unit() - 4);
  demand.slope = demand.box.diagonal() * std::pow(10.0, 2 * random.unit() - 2);
  demand.uv_extent = {0.1 + random.unit(), 0.1 + random.unit()};
  return demand;
}

/// Fields in any order, each into any word that has room: nothing where there is none.
std::optional<PackedLayout> by_chance(const Demand& demand, Random& random) {
  PackedLayout layout{};
  const auto any = [&](std::uint32_t least, std::uint32_t most) {
    return least + static_cast<std::uint32_t>(random.below(most - least + 1));
  };
  const double longest = std::max({demand.box.extent().x, demand.box.extent().y, demand.box.extent().z});
  const int exponent = std::ilogb(longest) - static_cast<int>(any(15, 23));
  layout.step = static_cast<float>(std::ldexp(1.0, exponent));
  std::array<std::uint32_t, FOREDRAW_PACKED_FIELDS> bits{};
  for (int i = 0; i < 3; ++i) {
    const double steps = std::nearbyint(std::ldexp(demand.box.max[i], -exponent)) -
                         std::nearbyint(std::ldexp(demand.box.min[i], -exponent));
    const double farthest = std::max(std::abs(demand.box.min[i]), std::abs(demand.box.max[i]));
    if (std::ldexp(farthest, -exponent) > 0x1p24) return std::nullopt;  // floats do not hold it
    bits[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(std::max(1.0, std::ceil(std::log2(steps + 1))));
  }
  bits[FOREDRAW_PACKED_NORMAL_0] = bits[FOREDRAW_PACKED_NORMAL_1] = any(9, 16);
  bits[FOREDRAW_PACKED_TANGENT] = any(10, 14);
  bits[FOREDRAW_PACKED_SIGN] = 1;
  bits[FOREDRAW_PACKED_U] = any(12, 20);
  bits[FOREDRAW_PACKED_V] = any(12, 20);
  std::array<std::uint32_t, 4> used{};
  for (std::size_t f = 0; f < bits.size(); ++f) {
    std::uint32_t word = any(0, 3);
    for (int tries = 0; used[word] + bits[f] > 32; word = (word + 1) % 4) {
      if (++tries == 4) return std::nullopt;
    }
    layout.field[f] = {word, used[word], bits[f]};
    used[word] += bits[f];
  }
  processors::vertex_pack::set_uv_lattice(layout, glm::dvec2(0), demand.uv_extent);
  return layout;
}

TEST(PackedLayoutSearch, NoLayoutByChanceIsBetter) {
  Random random(4);
  std::size_t tried = 0;
  for (int i = 0; i < 12; ++i) {
    const Demand demand = random_demand(random);
    const auto best = best_layout(demand);
    ASSERT_TRUE(best);
    EXPECT_TRUE(foredraw_packed_is_layout(&*best));
    EXPECT_LE(packed_bounds(*best).tangent, demand.most_angle_error);
    const double least = displaced_error(*best, demand);
    for (int k = 0; k < 200'000; ++k) {
      const auto other = by_chance(demand, random);
      if (!other || packed_bounds(*other).tangent > demand.most_angle_error) continue;
      ++tried;
      ASSERT_GE(displaced_error(*other, demand), least * (1 - 1e-12));
    }
  }
  EXPECT_GT(tried, 5000u);
}

TEST(PackedLayoutSearch, EveryPointOfTheBoxIsOnItsLattice) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    Demand demand = random_demand(random);
    if (i % 5 == 0) demand.box.max.y = demand.box.min.y;  // flat
    if (i % 7 == 0) demand.box = {demand.box.min, demand.box.min};
    const PackedLayout layout = best_layout(demand).value();
    ASSERT_TRUE(foredraw_packed_is_layout(&layout));
    for (int corner = 0; corner < 8; ++corner) {
      foredraw_packed_vertex vertex{{0, 0, 0}, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}};
      for (int c = 0; c < 3; ++c) {
        vertex.position[c] = static_cast<float>((corner >> c & 1) != 0 ? demand.box.max[c] : demand.box.min[c]);
      }
      std::uint32_t row[4];
      EXPECT_EQ(foredraw_packed_encode(&layout, &vertex, row), 0u);
    }
  }
}

TEST(PackedLayoutSearch, WeighsWhatTheSurfaceDoes) {
  Demand demand = testing::unit_demand();
  demand.displacement = 0.0001;
  const PackedLayout flat = best_layout(demand).value();
  demand.displacement = 0.1;
  const PackedLayout deep = best_layout(demand).value();
  EXPECT_LT(flat.field[FOREDRAW_PACKED_NORMAL_0].bits, deep.field[FOREDRAW_PACKED_NORMAL_0].bits);
  EXPECT_GT(flat.field[FOREDRAW_PACKED_X].bits, deep.field[FOREDRAW_PACKED_X].bits);
}

/// What is far from the origin is stored no finer than floats have it, and what is tiny or huge is no worse.
TEST(PackedLayoutSearch, HoldsBoxesAnywhereAndOfAnySize) {
  for (const double scale : {1e-20, 1e-3, 1.0, 1e6, 1e20, 1e28}) {
    for (const double away : {0.0, 1.0, 1e3, 1e6}) {
      Demand demand = testing::unit_demand();
      demand.box = {};
      demand.box.add(glm::dvec3(away * scale));
      demand.box.add(glm::dvec3((away + 1) * scale));
      demand.displacement *= scale;
      demand.slope *= scale;
      const auto layout = best_layout(demand);
      ASSERT_TRUE(layout) << scale << ' ' << away;
      EXPECT_TRUE(foredraw_packed_is_layout(&*layout));
      const double floats = (away + 1) * scale * 0x1p-23;
      EXPECT_LE(static_cast<double>(layout->step), std::max(4e-6 * scale, floats)) << scale << ' ' << away;
    }
  }
}

TEST(PackedLayoutSearch, WithoutDirectionsGivesTheirBitsToPositions) {
  Demand demand = testing::unit_demand();
  demand.normals = demand.tangents = false;
  const PackedLayout layout = best_layout(demand).value();
  EXPECT_EQ(layout.field[FOREDRAW_PACKED_TANGENT].bits, 0u);
  EXPECT_EQ(layout.field[FOREDRAW_PACKED_SIGN].bits, 0u);
  EXPECT_GE(layout.field[FOREDRAW_PACKED_X].bits, 23u);
}

TEST(PackedLayoutSearch, TellsWhereALimitCanNotBeKept) {
  Demand demand = testing::unit_demand();
  demand.most_angle_error = 1e-4;
  EXPECT_FALSE(best_layout(demand));
}

TEST(PackedLayoutSearch, TextureCoordinatesHaveALatticeOfTheirOwn) {
  PackedLayout layout = testing::unit_layout();
  for (const glm::dvec2 range :
       {glm::dvec2(0, 1), glm::dvec2(-3, 5), glm::dvec2(1000, 1000.5), glm::dvec2(0.25, 0.25)}) {
    ASSERT_TRUE(processors::vertex_pack::set_uv_lattice(layout, glm::dvec2(range.x), glm::dvec2(range.y)));
    ASSERT_TRUE(foredraw_packed_is_layout(&layout));
    const double bound = packed_bounds(layout).u;
    for (int i = 0; i <= 10'000; ++i) {
      const auto u = static_cast<float>(range.x + (range.y - range.x) * i / 10'000);
      foredraw_packed_vertex vertex{{0, 0, 0}, {0, 0, 1}, {1, 0, 0, 1}, {u, u}}, again;
      std::uint32_t row[4];
      ASSERT_EQ(foredraw_packed_encode(&layout, &vertex, row), 0u) << u;
      foredraw_packed_decode(&layout, row, &again);
      ASSERT_LE(std::abs(static_cast<double>(again.uv[0]) - static_cast<double>(u)), bound) << u;
    }
  }
  EXPECT_FALSE(processors::vertex_pack::set_uv_lattice(layout, glm::dvec2(0), glm::dvec2(1e30)));
}

}  // namespace
}  // namespace foredraw::vertex_pack_layout_test
