#include "plugins/processors/merge_instances/class_search.h"
#include "plugins/processors/merge_instances/frequency.h"

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace foredraw::processors::merge_instances::merge_instances_frequency_test {
namespace {

std::vector<MeshSize> random_sizes(Random& random, std::size_t count, std::uint64_t most_triangles) {
  std::vector<MeshSize> meshes;
  for (std::size_t i = 0; i < count; ++i)
    meshes.push_back({3 * (1 + random.below(most_triangles)), 1 + random.below(20)});
  return meshes;
}

std::uint64_t largest_of(const std::vector<MeshSize>& meshes) {
  std::uint64_t largest = 0;
  for (const MeshSize& mesh : meshes) largest = std::max(largest, mesh.indices);
  return largest;
}

double cost_at(const std::vector<MeshSize>& meshes, std::initializer_list<std::uint32_t> frequencies,
               const FrequencyOptions& options) {
  const Prices prices{options.padded_cost, options.slot_bytes * options.slot_byte_cost};
  double sum = 0;
  for (const MeshSize& mesh : meshes) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t frequency : frequencies) least = std::min(least, cost_of(mesh, frequency, prices));
    sum += least;
  }
  return sum;
}

TEST(MergeFrequency, ThePapersExample) {
  const std::vector<MeshSize> meshes{{39, 1}, {90, 1}};
  // Just where a slot costs what lies between: 45 is the best when a slot costs more than two entries each.
  FrequencyOptions options{.padded_cost = 1, .slot_byte_cost = 1};
  const FrequencyChoice choice = best_frequencies(meshes, options);
  EXPECT_EQ(choice.frequencies, (std::vector<std::uint32_t>{45}));
  EXPECT_EQ(choice.slots, 3u);
  EXPECT_EQ(choice.padded, 6u);
  EXPECT_EQ(choice.indices + choice.padded, 135u);
  EXPECT_NEAR(choice.padding(), 0.044, 0.0005);
}

TEST(MergeFrequency, OneClassIsAsBruteForceFindsIt) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    const std::vector<MeshSize> meshes = random_sizes(random, 1 + random.below(12), 1 + random.below(400));
    FrequencyOptions options;
    options.multiple = random.below(3) == 0 ? 12 : 3;
    options.padded_cost = static_cast<double>(random.below(30)) / 4;
    options.slot_byte_cost = static_cast<double>(random.below(5));
    const FrequencyChoice choice = best_frequencies(meshes, options);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t f = options.multiple; f < largest_of(meshes) + 2 * options.multiple; f += options.multiple) {
      least = std::min(least, cost_at(meshes, {f}, options));
    }
    ASSERT_EQ(choice.frequencies.size(), 1u);
    EXPECT_EQ(choice.frequencies[0] % options.multiple, 0u);
    EXPECT_DOUBLE_EQ(choice.cost, least) << "round " << round;
    EXPECT_TRUE(choice.proven);
  }
}

TEST(MergeFrequency, SeveralClassesAreAsBruteForceFindsThem) {
  Random random(8);
  for (int round = 0; round < 60; ++round) {
    const std::vector<MeshSize> meshes = random_sizes(random, 1 + random.below(9), 1 + random.below(40));
    FrequencyOptions options;
    options.padded_cost = static_cast<double>(1 + random.below(30));
    options.slot_byte_cost = static_cast<double>(1 + random.below(5));
    options.class_cost = round % 2 == 0 ? 0 : 40;
    const auto most = static_cast<std::uint32_t>(largest_of(meshes));
    double least = std::numeric_limits<double>::infinity(), least_of_three = least;
    for (std::uint32_t a = 3; a <= most; a += 3) {
      least = std::min(least, cost_at(meshes, {a}, options));
      for (std::uint32_t b = a + 3; b <= most; b += 3) {
        least = std::min(least, cost_at(meshes, {a, b}, options) + options.class_cost);
        for (std::uint32_t c = b + 3; round < 20 && c <= most; c += 3) {
          least_of_three = std::min(least_of_three, cost_at(meshes, {a, b, c}, options) + 2 * options.class_cost);
        }
      }
    }
    options.classes = 2;
    const FrequencyChoice two = best_frequencies(meshes, options);
    EXPECT_NEAR(two.cost, least, 1e-6 * least) << "round " << round;
    EXPECT_TRUE(two.proven);
    if (round >= 20) continue;
    options.classes = 3;
    const FrequencyChoice three = best_frequencies(meshes, options);
    EXPECT_NEAR(three.cost, std::min(least, least_of_three), 1e-6 * least) << "round " << round;
    EXPECT_TRUE(three.proven);
  }
}

/// All ways to send each mesh to one of two frequencies.
std::uint64_t fewest_by_force(const std::vector<MeshSize>& meshes, double most_padding) {
  const auto most = static_cast<std::uint32_t>(largest_of(meshes));
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t a = 3; a <= most; a += 3) {
    for (std::uint32_t b = a; b <= most; b += 3) {
      for (std::uint32_t sent = 0; sent < 1u << meshes.size(); ++sent) {
        std::uint64_t slots = 0, padded = 0, entries = 0;
        for (std::size_t m = 0; m < meshes.size(); ++m) {
          const std::uint32_t f = sent >> m & 1 ? a : b;
          const std::uint64_t own = slots_of(meshes[m].indices, f);
          slots += meshes[m].placed * own;
          padded += meshes[m].placed * (own * f - meshes[m].indices);
          entries += meshes[m].placed * meshes[m].indices;
        }
        if (static_cast<double>(padded) <= most_padding * static_cast<double>(padded + entries)) {
          fewest = std::min(fewest, slots);
        }
      }
    }
  }
  return fewest;
}

TEST(MergeFrequency, FewestSlotsUnderALimitOfPadding) {
  Random random(9);
  for (int round = 0; round < 40; ++round) {
    std::vector<MeshSize> meshes;
    for (std::uint64_t size = 3 + 3 * random.below(4); meshes.size() < 5; size += 3 * (1 + random.below(12))) {
      meshes.push_back({size, 1 + random.below(6)});
    }
    const double limit = 0.01 * static_cast<double>(1 + random.below(8));
    const auto choice = fewest_slots(meshes, limit, {.classes = 2});
    ASSERT_TRUE(choice);
    EXPECT_LE(choice->padding(), limit);
    EXPECT_EQ(choice->slots, fewest_by_force(meshes, limit)) << "round " << round;
    EXPECT_TRUE(choice->proven);
    const auto one = fewest_slots(meshes, limit);
    EXPECT_GE(one->slots, choice->slots);
    EXPECT_EQ(one->frequencies.size(), 1u);
  }
}

/// The index entries of each primitive in benchmarks/corpus/scenes, and how many primitives have as many.
TEST(MergeFrequency, TwoFrequenciesPadTheKitsLittleAndNeedFewRecords) {
  const std::vector<MeshSize> city{{132, 1},  {432, 8},  {438, 1},  {510, 1},  {528, 1}, {1524, 1},
                                   {2040, 1}, {2220, 1}, {2484, 1}, {3354, 1}, {5655, 1}};
  const std::vector<MeshSize> space{{6, 6},   {12, 6},  {18, 3},  {24, 2},  {30, 9},  {36, 1},  {42, 4},  {48, 3},
                                    {54, 1},  {60, 4},  {66, 5},  {78, 2},  {84, 2},  {90, 1},  {96, 1},  {102, 2},
                                    {108, 1}, {132, 1}, {138, 1}, {144, 1}, {153, 1}, {156, 1}, {180, 1}, {186, 1},
                                    {192, 1}, {216, 1}, {228, 2}, {234, 1}, {252, 1}, {264, 1}, {282, 1}, {288, 1},
                                    {330, 1}, {348, 1}, {372, 1}, {378, 1}, {390, 1}, {396, 1}, {402, 1}, {432, 2},
                                    {444, 1}, {504, 1}, {570, 1}, {609, 1}, {768, 1}, {888, 1}, {918, 1}};
  for (const auto& kit : {city, space}) {
    std::uint64_t placed = 0;
    for (const MeshSize& size : kit) placed += size.placed;
    const auto choice = fewest_slots(kit, 0.02, {.classes = 2});
    ASSERT_TRUE(choice);
    EXPECT_TRUE(choice->proven);
    EXPECT_LE(choice->padding(), 0.02);
    EXPECT_LE(8.0 * static_cast<double>(choice->slots) / static_cast<double>(placed), 84);
  }
  EXPECT_EQ(fewest_slots(city, 0.02)->frequencies, (std::vector<std::uint32_t>{90}));
  EXPECT_EQ(fewest_slots(space, 0.02)->frequencies, (std::vector<std::uint32_t>{12}));
}

TEST(MergeFrequency, NothingPadsLessThanTheMultipleAlone) {
  EXPECT_FALSE(fewest_slots(std::vector<MeshSize>{{3, 1}}, 0.1, {.multiple = 96}));
  EXPECT_TRUE(fewest_slots(std::vector<MeshSize>{{3, 1}}, 0.97, {.multiple = 96}));
}

TEST(MergeFrequency, TellsWhereEachMeshGoes) {
  const std::vector<MeshSize> meshes{{12, 1000}, {0, 5}, {3000, 10}, {12, 3}};
  const FrequencyChoice choice = best_frequencies(meshes, {.classes = 2});
  EXPECT_EQ(choice.frequencies, (std::vector<std::uint32_t>{12, 3000}));
  EXPECT_EQ(choice.mesh_class[0], 0);
  EXPECT_EQ(choice.mesh_class[2], 1);
  EXPECT_EQ(choice.mesh_class[3], 0);
  EXPECT_EQ(choice.padded, 0u);
  EXPECT_EQ(choice.slots, 1013u);
}

TEST(MergeFrequency, OfNothingThereIsNone) {
  EXPECT_TRUE(best_frequencies({}).frequencies.empty());
  EXPECT_TRUE(best_frequencies(std::vector<MeshSize>{{0, 4}, {9, 0}}).frequencies.empty());
  EXPECT_EQ(fewest_slots(std::vector<MeshSize>{{0, 4}}, 0.02)->slots, 0u);
}

TEST(MergeFrequency, RefusesWhatMakesNoSense) {
  const std::vector<MeshSize> meshes{{39, 1}};
  EXPECT_THROW(best_frequencies(meshes, {.multiple = 4}), std::invalid_argument);
  EXPECT_THROW(best_frequencies(meshes, {.classes = 5}), std::invalid_argument);
  EXPECT_THROW(best_frequencies(meshes, {.padded_cost = -1}), std::invalid_argument);
  EXPECT_THROW(best_frequencies(meshes, {.padded_cost = std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
  EXPECT_THROW(fewest_slots(meshes, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(best_frequencies(std::vector<MeshSize>{{std::uint64_t{1} << 32, 1}}), std::invalid_argument);
}

/// To try all frequencies of these would take days.
TEST(MergeFrequency, MeshesOfMillionsAndThousandsOfSizesAreSolved) {
  Random random(10);
  std::vector<MeshSize> large = random_sizes(random, 150, 3'333'333);
  std::vector<MeshSize> many = random_sizes(random, 5'000, 30'000);
  large.push_back({4'294'967'295, 1});
  for (const auto& meshes : {large, many}) {
    const FrequencyChoice one = best_frequencies(meshes);
    const FrequencyChoice two = best_frequencies(meshes, {.classes = 2});
    EXPECT_TRUE(one.proven);
    EXPECT_LE(two.cost, one.cost);
    EXPECT_LE(two.bound, two.cost);
    const auto limited = fewest_slots(meshes, 0.02, {.classes = 2});
    ASSERT_TRUE(limited);
    EXPECT_LE(limited->padding(), 0.02);
    EXPECT_LE(limited->bound, limited->cost);
  }
}

}  // namespace
}  // namespace foredraw::processors::merge_instances::merge_instances_frequency_test
