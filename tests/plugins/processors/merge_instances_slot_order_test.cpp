#include "plugins/processors/merge_instances/slot_order.h"

#include "plugins/processors/merge_instances/merge_scene.h"

#include "support/placements.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/runtime/merge_instances.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace foredraw::merge_instances_slot_order_test {
namespace {

using testing::all_draws;
using testing::random_placements;
using testing::scene_with;

MergedInstances merged_of(const Scene& scene) {
  const MergedScene merged = merge_scene(scene, all_draws(scene), {}, Executor(2));
  return merged_instances(scene, merged.merged.at(0));
}

/// Two meshes of one triangle each that face +z, at heights, in the sequence in which they are merged.
Scene two_floors(float first, float second) {
  const auto floor = [](float width) {
    testing::TestMesh mesh;
    mesh.positions = {{0, 0, 0}, {width, 0, 0}, {0, width, 0}};
    mesh.indices = {0, 1, 2};
    return mesh;
  };
  const auto at = [](float height) { return glm::translate(glm::mat4(1), {0, 0, height}); };
  return scene_with({{floor(1), {at(first)}}, {floor(1.5f), {at(second)}}});
}

std::vector<MergedSlot> sorted_by_place(std::span<const MergedSlot> slots) {
  std::vector<MergedSlot> sorted(slots.begin(), slots.end());
  std::ranges::sort(sorted, {}, [](const MergedSlot& slot) { return std::pair(slot.instance, slot.index_offset); });
  return sorted;
}

TEST(MergeSlotOrder, WhatFacesOutwardsComesFirst) {
  for (const auto& [first, second] : {std::pair(0.f, 1.f), std::pair(1.f, 0.f)}) {
    const MergedInstances merged = merged_of(two_floors(first, second));
    const std::vector<MergedSlot> slots = processors::merge_instances::outward_slots(merged, Executor(1));
    ASSERT_EQ(slots.size(), 2u);
    // The upper one faces away from the middle between both.
    EXPECT_EQ(merged.transforms.view()[slots[0].instance][11], 1);
    EXPECT_EQ(merged.transforms.view()[slots[1].instance][11], 0);
  }
}

TEST(MergeSlotOrder, EveryDrawKeepsItsSlots) {
  const MergedInstances merged = merged_of(scene_with(random_placements(7, 8, 40)));
  const std::vector<MergedSlot> slots = processors::merge_instances::outward_slots(merged, Executor(2));
  EXPECT_EQ(slots, processors::merge_instances::outward_slots(merged, Executor(1)));
  ASSERT_EQ(slots.size(), merged.slots.size());
  EXPECT_FALSE(std::ranges::equal(slots, merged.slots.view()));
  for (const MergedDraw& draw : merged.draws) {
    const auto of = [&](std::span<const MergedSlot> all) {
      return sorted_by_place(all.subspan(draw.first_slot, draw.slot_count));
    };
    EXPECT_EQ(of(slots), of(merged.slots.view()));
  }
}

TEST(MergeSlotOrder, AGroupByItselfIsWhatItsDrawsFetch) {
  const Scene scene = scene_with(random_placements(8, 5, 30));
  const MergedInstances merged = merged_of(scene);
  const std::vector<glm::vec3> positions = decode_vec3(*merged.vertices->find("POSITION"));
  const auto* slots = reinterpret_cast<const foredraw_merged_slot*>(merged.slots.view().data());
  for (std::uint32_t g = 0; g < merged.groups.size(); ++g) {
    const Scene alone = processors::merge_instances::group_scene(scene, merged, g);
    std::size_t number = 0;
    for (const MergedDraw& one : merged.draws) {
      if (one.group != g) continue;
      const foredraw_merged_draw draw{one.frequency, one.first_slot, one.slot_count, slots,
                                      merged.indices.view().data()};
      const std::vector<glm::vec3> world = decode_vec3(*alone.draws.at(number++).levels[0].vertices->find("POSITION"));
      ASSERT_EQ(world.size(), foredraw_merged_vertex_count(&draw));
      for (std::uint32_t v = 0; v < world.size(); ++v) {
        const foredraw_merged_vertex at = foredraw_merged_vertex_at(&draw, v);
        glm::vec3 expected;
        foredraw_merged_to_world(merged.transforms.view()[at.instance].data(), &positions[at.vertex].x, &expected.x);
        ASSERT_EQ(world[v], expected);
      }
    }
    EXPECT_EQ(number, alone.draws.size());
  }
}

/// Finds more or less overdraw where the first triangle lies high.
class HeightService final : public OverdrawService {
 public:
  explicit HeightService(bool likes_high) : likes_high_(likes_high) {}

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views&, Run&) const override {
    const bool is_high = parts[0].positions[parts[0].indices[0]].z > 0;
    OverdrawCounts counts(parts.size());
    for (auto& part : counts) part.push_back({.shaded = is_high == likes_high_ ? 10u : 20u, .visible = 10});
    return counts;
  }

 private:
  bool likes_high_;
};

/// The height of what is drawn first once the stage has sorted, or not.
float first_drawn(Scene scene, OverdrawService& service, std::string& note) {
  testing::RunFixture fixture;
  fixture.run.overdraw = &service;
  const Technique technique = merge_instances_plugin().create({{"overdraw-order", true}});
  std::get<std::unique_ptr<Processor>>(technique)->process(scene, all_draws(scene), fixture.run);
  for (const auto& one : fixture.findings.notes) note += one.message;
  const MergedInstances& merged = merged_sets(scene)[0];
  return merged.transforms.view()[merged.slots.view()[0].instance][11];
}

TEST(MergeSlotOrder, TheStageSortsWhereMeasuredOverdrawFalls) {
  const Scene scene = two_floors(0, 1);
  HeightService likes_high(true), likes_low(false);
  std::string sorted, kept;
  EXPECT_EQ(first_drawn(scene, likes_high, sorted), 1);
  EXPECT_NE(sorted.find("overdraw went from 2.0000 to 1.0000"), std::string::npos) << sorted;
  EXPECT_EQ(first_drawn(scene, likes_low, kept), 0);
  EXPECT_NE(kept.find("overdraw went from 1.0000 to 1.0000"), std::string::npos) << kept;
}

}  // namespace
}  // namespace foredraw::merge_instances_slot_order_test
