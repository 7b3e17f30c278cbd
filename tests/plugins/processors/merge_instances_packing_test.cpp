#include "plugins/processors/merge_instances/packing.h"

#include "plugins/processors/merge_instances/slot_cuts.h"
#include "support/meshes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace foredraw::processors::merge_instances::merge_instances_packing_test {
namespace {

std::uint64_t different(std::span<const std::uint32_t> indices, const std::vector<std::uint32_t>& first) {
  std::uint64_t sum = 0;
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    sum += std::set<std::uint32_t>(indices.begin() + first[s], indices.begin() + first[s + 1]).size();
  }
  return sum;
}

/// All ways to cut the triangles into a number of slots.
std::uint64_t fewest_by_force(std::span<const std::uint32_t> indices, std::uint32_t frequency, std::size_t slots,
                              std::vector<std::uint32_t>& first) {
  const auto begin = first.back();
  if (slots == 0) {
    return begin == indices.size() ? different(indices, first) : std::numeric_limits<std::uint64_t>::max();
  }
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t end = begin + 3; end <= std::min<std::size_t>(indices.size(), begin + frequency); end += 3) {
    first.push_back(end);
    fewest = std::min(fewest, fewest_by_force(indices, frequency, slots - 1, first));
    first.pop_back();
  }
  return fewest;
}

TEST(MergeSlotCuts, AreTheBestThatThePaddingAllows) {
  Random random(31);
  std::size_t better = 0;
  for (int round = 0; round < 60; ++round) {
    testing::TestMesh mesh;
    for (int part = 0; part < 3; ++part) {
      mesh = testing::joined(mesh, testing::grid(1 + static_cast<std::uint32_t>(random.below(3)), 1));
    }
    const auto frequency = static_cast<std::uint32_t>(3 * (4 + random.below(4)));
    const SlotCuts cuts = cut_slots(mesh.indices, mesh.positions.size(), frequency);
    ASSERT_EQ(cuts.slots(), (mesh.indices.size() + frequency - 1) / frequency);
    EXPECT_EQ(cuts.fetched, different(mesh.indices, cuts.first));
    std::vector<std::uint32_t> first{0};
    EXPECT_EQ(cuts.fetched, fewest_by_force(mesh.indices, frequency, cuts.slots(), first));
    EXPECT_LE(cuts.fetched, cuts.fetched_plain);
    better += cuts.fetched < cuts.fetched_plain;
    EXPECT_EQ(cut_evenly(mesh.indices, mesh.positions.size(), frequency).fetched, cuts.fetched_plain);
    for (std::size_t s = 0; s < cuts.slots(); ++s) {
      EXPECT_GT(cuts.first[s + 1], cuts.first[s]);
      EXPECT_LE(cuts.first[s + 1] - cuts.first[s], frequency);
    }
  }
  EXPECT_GT(better, 0u);
}

TEST(MergeSlotCuts, OfNothingAndOfManyTriangles) {
  EXPECT_EQ(cut_slots({}, 0, 3).slots(), 0u);
  const testing::TestMesh large = testing::grid(1500, 1000);  // 9 million entries
  EXPECT_EQ(cut_slots(large.indices, large.positions.size(), 96).slots(), 93750u);
}

/// The paper's example: meshes of 39 and 90 entries at a frequency of 45.
class MergePacking : public ::testing::Test {
 protected:
  MergePacking() {
    for (std::uint32_t i = 0; i < 39; ++i) small.push_back(i);
    for (std::uint32_t i = 0; i < 90; ++i) large.push_back(89 - i);
    meshes = {{"small", small, 0, 39}, {"large", large, 39, 90}};
    frequencies.frequencies = {45};
    frequencies.mesh_class = {0, 0};
  }

  PackedInstances pack(const PackOptions& options = {}) const {
    SpatialGroups groups;  // one
    for (std::uint32_t i = 0; i < placed.size(); ++i) groups.instances.push_back(i);
    groups.first.push_back(static_cast<std::uint32_t>(placed.size()));
    groups.bounds.emplace_back();
    return pack_instances(meshes, placed, groups, frequencies, options, Executor(2));
  }

  std::vector<std::uint32_t> small, large;
  std::vector<PackedMesh> meshes;
  std::vector<PlacedMesh> placed{{1, glm::mat4(1), {}}, {0, glm::mat4(1), {}}};
  FrequencyChoice frequencies;
};

TEST_F(MergePacking, ThePapersExample) {
  const PackedInstances packed = pack();
  EXPECT_EQ(packed.slots, (std::vector<MergedSlot>{{0, 0}, {45, 1}, {90, 1}}));
  EXPECT_EQ(packed.indices.size(), 135u);
  EXPECT_EQ(packed.padded_entries, 6u);
  EXPECT_EQ(packed.drawn_entries, 129u);
  EXPECT_EQ(packed.placed, (std::vector<std::uint32_t>{1, 0}));  // by mesh
  for (std::size_t i = 39; i < 45; ++i) EXPECT_EQ(packed.indices[i], 38u);
  EXPECT_EQ(packed.indices[45], 39u + 89u);
  ASSERT_EQ(packed.draws.size(), 1u);
  EXPECT_EQ(packed.draws[0].slot_count, 3u);
}

TEST_F(MergePacking, IndicesThatNeedMoreThan16BitsAreKept) {
  meshes[1].first_vertex = 4'000'000'000u;
  EXPECT_EQ(pack().indices[45], 4'000'000'089u);
}

TEST_F(MergePacking, OffsetsThatDoNotFitAreRefusedByName) {
  try {
    pack({.most_entries = 134});
    FAIL() << "packed";
  } catch (const std::length_error& error) {
    EXPECT_STREQ(error.what(),
                 "large: with it the merged index buffer has 135 entries, of at most 134; merge fewer meshes together");
  }
  meshes[1].first_vertex = 4'294'967'290u;
  EXPECT_THROW(pack(), std::invalid_argument);
}

TEST_F(MergePacking, DrawsAreSplitWhereVertexNumbersEnd) {
  placed.assign(10, {1, glm::mat4(1), {}});
  placed.push_back({0, glm::mat4(1), {}});
  const PackedInstances packed = pack({.most_entries = 200});
  ASSERT_EQ(packed.draws.size(), 6u);  // 21 slots, of which 4 have 180 entries
  EXPECT_EQ(packed.draws[1].first_slot, 4u);
  EXPECT_EQ(packed.draws[5].slot_count, 1u);
}

TEST_F(MergePacking, RefusesWhatItCanNotDraw) {
  placed[0].world = glm::mat4(0);
  EXPECT_THROW(pack(), std::invalid_argument);
  placed[0].world = glm::mat4(1);
  small[7] = 39;
  EXPECT_THROW(pack(), std::invalid_argument);
}

TEST_F(MergePacking, EmptyMeshesDrawNothing) {
  small.clear();
  meshes[0].indices = {};
  const PackedInstances packed = pack();
  EXPECT_EQ(packed.slots.size(), 2u);
  EXPECT_EQ(packed.transforms.size(), 2u);
}

TEST(MergePlacing, TellsTransformsApart) {
  EXPECT_EQ(placing_of(glm::mat4(1)), Placing::plain);
  EXPECT_EQ(placing_of(glm::scale(glm::mat4(1), {1, -1, 1})), Placing::mirrored);
  EXPECT_EQ(placing_of(glm::scale(glm::mat4(1), {-1, -1, 1})), Placing::plain);
  EXPECT_EQ(placing_of(glm::scale(glm::mat4(1), {1e-12f, 1e-12f, 1e-12f})), Placing::plain);
  EXPECT_EQ(placing_of(glm::scale(glm::mat4(1), {1, 0, 1})), Placing::singular);
  EXPECT_EQ(placing_of(glm::mat4(0)), Placing::not_affine);
  glm::mat4 nothing(1);
  nothing[1][2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(placing_of(nothing), Placing::not_finite);
}

}  // namespace
}  // namespace foredraw::processors::merge_instances::merge_instances_packing_test
