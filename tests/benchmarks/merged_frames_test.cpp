// Merged draws show the same as the nodes that they stand for: drawn both ways by Vulkan, the merged ones with the
// shader text that is written for engines, all pixels are equal. A pixel is a hash of what it shows: which placed
// primitive, how it looks, the triangle's first corner, and what is interpolated between all three.
#include "frame/frame.h"
#include "frame/frame_camera.h"
#include "frame/shader_compiler.h"
#include "gpu_instancing.h"
#include "layout.h"

#include "support/edit_product.h"
#include "support/meshes.h"
#include "support/on_device.h"

#include <plugins/processors/merge_instances/merge_scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <set>

namespace foredraw::bench::merged_frames_test {
namespace {

constexpr int size = 512;
constexpr std::uint32_t nothing = ~std::uint32_t{0};

Kit city_kit() { return read_kit(testing::project_file("benchmarks/corpus/scenes/kaykit_city")); }
Kit space_kit() { return read_kit(testing::project_file("benchmarks/corpus/scenes/kenney_space_kit")); }

/// A part of the models mirrored, and beside them others that are instances of nodes.
Scene city(std::uint64_t instances, double mirrored) {
  const Kit kit = city_kit();
  Scene scene = placed_scene(kit, city_layout(kit, {.instances = instances, .mirrored = mirrored}), "city");
  const auto more = city_layout(kit, {.instances = instances / 2, .seed = 2, .mirrored = mirrored});
  for (Node node : with_gpu_instancing(placed_scene(kit, more, "more")).nodes) {
    node.transform.translation = {0, 0, -3};
    node.transform.rotation = quarter_turn(1);
    scene.nodes.push_back(std::move(node));
  }
  return scene;
}

/// The plain is wide and empty; here models stand in one another, so that there is much to hide. `spread`: 1 as the
/// kit's.
Scene space(std::uint64_t instances, double mirrored, float spread = 0.1f) {
  const Kit kit = space_kit();
  auto placements = space_layout(kit, {.instances = instances, .mirrored = mirrored});
  for (Placement& placement : placements) placement.transform.translation *= glm::vec3(spread, 1, spread);
  return placed_scene(kit, placements, "space");
}

Scene merged(Scene scene, const MergeSceneOptions& options = {}) {
  std::vector<DrawId> draws(scene.draws.size());
  std::iota(draws.begin(), draws.end(), DrawId{0});
  for (const MergedSet& set : merge_scene(scene, draws, options, Executor(2)).merged) {
    testing::edit<MergedDraws>(scene)->sets.push_back(merged_instances(scene, set));
  }
  return scene;
}

/// Everything, from two sides.
std::vector<glm::mat4> overviews(const Scene& scene) {
  const SceneBounds bounds = bounds_of(scene);
  return {overview(bounds, {-0.3f, -0.5f}), overview(bounds, {0.7f, 0.4f})};
}

/// As one who stands in the scene sees it, with much behind him and much that is cut off.
std::vector<glm::mat4> inner_views(const Scene& scene) {
  const SceneBounds bounds = bounds_of(scene);
  const glm::vec3 middle = (bounds.least + bounds.most) * 0.5f;
  return {seen_from(middle, bounds.most, 0.1f, 300), seen_from(bounds.most, middle, 0.1f, 300)};
}

std::size_t covered(const std::vector<std::uint32_t>& pixels) {
  return pixels.size() - static_cast<std::size_t>(std::ranges::count(pixels, nothing));
}

std::size_t different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

TEST(FrameContent, every_way_draws_everything_once_with_its_own_calls) {
  const Scene scene = merged(city(500, 0.3));
  const std::vector<PlacedDraw> placed = placed_draws(scene);
  std::set<std::pair<bool, DrawId>> different;
  for (const PlacedDraw& one : placed) different.insert({one.is_mirrored, one.draw});
  std::map<DrawWay, FrameContent> of;
  for (const DrawWay way : all_draw_ways) {
    of[way] = frame_content(scene, way);
    std::vector<MergedPlace> sequence = of[way].sequence;
    std::ranges::sort(sequence);
    EXPECT_TRUE(std::ranges::equal(sequence, placed, {}, {}, &PlacedDraw::place)) << to_text(way);
    EXPECT_GT(of[way].bytes.vertices, 0u);
  }
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_EQ(of[DrawWay::each].calls(), placed.size());
  EXPECT_EQ(of[DrawWay::instanced].calls(), different.size());
  EXPECT_GT(of[DrawWay::group_instanced].calls(), of[DrawWay::merged].calls());
  EXPECT_EQ(of[DrawWay::indirect].calls(), 2u);  // as they wind
  EXPECT_EQ(of[DrawWay::indirect].bytes.commands, 20 * different.size());
  EXPECT_EQ(of[DrawWay::indirect_each].bytes.commands, 20 * placed.size());
  EXPECT_EQ(of[DrawWay::duplicated].calls(), merged_sets(scene)[0].groups.size());
  EXPECT_EQ(of[DrawWay::merged].calls(), merged_sets(scene)[0].draws.size());
  EXPECT_EQ(of[DrawWay::merged].bytes.slots, merged_sets(scene)[0].slots.view().size_bytes());
  EXPECT_EQ(of[DrawWay::merged].bytes.vertices, of[DrawWay::each].bytes.vertices);
  EXPECT_EQ(of[DrawWay::each].bytes.transforms, 48 * placed.size());

  const FrameContent counted = frame_content(scene, DrawWay::duplicated, 0);
  EXPECT_FALSE(counted.is_complete);
  EXPECT_EQ(counted.bytes.all(), of[DrawWay::duplicated].bytes.all());
  EXPECT_EQ(counted.calls(), of[DrawWay::duplicated].calls());
}

/// On the device that is the processor: others may round the arithmetic of two shaders differently, and every bit
/// counts here.
class MergedFrames : public testing::OnDevice {
 protected:
  MergedFrames() : OnDevice("llvmpipe") {}

  void SetUp() override {
    OnDevice::SetUp();
    if (IsSkipped()) return;
    if (!has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
    device_ = std::make_unique<FrameDevice>(size, choice());
  }

  void TearDown() override {
    device_.reset();
    OnDevice::TearDown();
  }

  std::vector<std::uint32_t> pixels(const Scene& scene, const FrameContent& content, const glm::mat4& view) {
    return Frame(*device_, scene, content).pixels(view);
  }

  /// Of surfaces at the same depth the first one drawn shows, so what is drawn one by one is drawn in the sequence in
  /// which the other way draws it.
  ///
  /// Merged and duplicated triangles that are mirrored have two corners exchanged. Where such triangles are cut off at
  /// the edges of the view (`is_cut_mirrored`), what is between their corners is rounded otherwise; a few pixels may
  /// differ then.
  void expect_same_as_each(const Scene& scene, const FrameContent& content, std::span<const glm::mat4> views,
                           bool is_cut_mirrored = false) {
    const Frame frame(*device_, scene, content);
    const FrameContent each = frame_content_of_each(scene, content.sequence);
    EXPECT_EQ(each.calls(), placed_draws(scene).size());
    const Frame expected(*device_, scene, each);
    for (const glm::mat4& view : views) {
      const std::vector<std::uint32_t> shown = frame.pixels(view);
      EXPECT_LE(different(shown, expected.pixels(view)), is_cut_mirrored ? shown.size() / 10000 : 0)
          << to_text(content.way);
      EXPECT_GT(covered(shown), shown.size() / 6);
    }
  }

  void expect_merged_shows_the_same(const Scene& scene, std::span<const glm::mat4> views,
                                    bool is_cut_mirrored = false) {
    ASSERT_FALSE(merged_sets(scene).empty());
    const FrameContent content = frame_content(scene, DrawWay::merged);
    expect_same_as_each(scene, content, views, is_cut_mirrored);
    std::size_t merged_draws = 0, instances = 0;
    for (const MergedInstances& set : merged_sets(scene)) {
      merged_draws += set.draws.size();
      instances += set.places.size();
    }
    const std::size_t placed = placed_draws(scene).size();
    EXPECT_GT(instances, placed / 2);
    EXPECT_LT(content.calls(), frame_content(scene, DrawWay::gpu_instancing).calls());  // the nodes' own
    EXPECT_GE(content.calls(), merged_draws);
    EXPECT_LE(content.calls(), merged_draws + placed - instances);
  }

  std::unique_ptr<FrameDevice> device_;
};

TEST_F(MergedFrames, city_shows_the_same) {
  const Scene mirrored = merged(city(800, 0.3)), plain = merged(city(800, 0));
  expect_merged_shows_the_same(mirrored, overviews(mirrored));
  expect_merged_shows_the_same(mirrored, inner_views(mirrored), true);
  expect_merged_shows_the_same(plain, inner_views(plain));
}

TEST_F(MergedFrames, space_shows_the_same) {
  const Scene mirrored = merged(space(800, 0.3)), plain = merged(space(800, 0));
  expect_merged_shows_the_same(mirrored, overviews(mirrored));
  expect_merged_shows_the_same(mirrored, inner_views(mirrored), true);
  expect_merged_shows_the_same(plain, inner_views(plain));
}

TEST_F(MergedFrames, instances_may_have_their_own_materials) {
  const Scene scene = merged(space(800, 0.3), {{}, processors::merge_instances::SharedMaterials::kind});
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_FALSE(merged_sets(scene)[0].materials.empty());
  expect_merged_shows_the_same(scene, overviews(scene));
}

TEST_F(MergedFrames, every_way_shows_the_same) {
  const Scene scene = merged(city(500, 0.3));
  for (const DrawWay way : all_draw_ways) {
    expect_same_as_each(scene, frame_content(scene, way), overviews(scene));
  }
}

/// What the other tests rest on: that the picture tells.
TEST_F(MergedFrames, a_wrong_transform_shows) {
  Scene scene = merged(city(300, 0));
  const glm::mat4 view = overviews(scene)[0];
  const auto before = pixels(scene, frame_content(scene, DrawWay::merged), view);
  MergedInstances set = merged_sets(scene)[0];
  std::vector<MergedTransform> transforms(set.transforms.view().begin(), set.transforms.view().end());
  transforms[transforms.size() / 2][7] += 8;  // up into the air
  set.transforms = Shared(std::move(transforms));
  testing::edit<MergedDraws>(scene)->sets[0] = set;
  EXPECT_GT(different(pixels(scene, frame_content(scene, DrawWay::merged), view), before), 0u);
}

TEST_F(MergedFrames, wrong_slots_places_materials_and_corners_show) {
  const Scene scene = merged(space(300, 0.3, 0.5f), {{}, processors::merge_instances::SharedMaterials::kind});
  const glm::mat4 view = overviews(scene)[0];
  const auto before = pixels(scene, frame_content(scene, DrawWay::merged), view);
  const auto shows = [&](const auto& break_one) {
    int told = 0;
    for (std::size_t i = 0; i < 16; ++i) {
      Scene broken = scene;
      break_one(testing::edit<MergedDraws>(broken)->sets[0], i);
      told += different(pixels(broken, frame_content(broken, DrawWay::merged), view), before) > 0;
    }
    return told;
  };
  // Some of what is broken is hidden or faces away.
  EXPECT_GT(shows([](MergedInstances& set, std::size_t i) {
              std::vector<MergedSlot> slots(set.slots.view().begin(), set.slots.view().end());
              const MergedDraw& draw = set.draws[i % set.draws.size()];
              const std::size_t at = draw.first_slot + i * (draw.slot_count - 1) / 16;
              slots[at].index_offset =
                  slots[draw.first_slot + draw.slot_count - 1 - i * draw.slot_count / 32].index_offset;
              set.slots = Shared(std::move(slots));
            }),
            4);
  EXPECT_GT(shows([](MergedInstances& set, std::size_t i) {
              std::vector<MergedPlace> places(set.places.view().begin(), set.places.view().end());
              places[i * (places.size() - 1) / 16].instance += 1;
              set.places = Shared(std::move(places));
            }),
            4);
  EXPECT_GT(shows([](MergedInstances& set, std::size_t i) {
              std::vector<std::uint32_t> materials(set.materials.view().begin(), set.materials.view().end());
              std::uint32_t& material = materials[i * (materials.size() - 1) / 16];
              material = material == 0 ? 1 : 0;
              set.materials = Shared(std::move(materials));
            }),
            4);
  EXPECT_GT(shows([](MergedInstances& set, std::size_t i) {
              std::vector<std::uint32_t> indices(set.indices.view().begin(), set.indices.view().end());
              const std::size_t triangle = i * (indices.size() / 3 - 1) / 16;
              std::swap(indices[3 * triangle + 1], indices[3 * triangle + 2]);
              set.indices = Shared(std::move(indices));
            }),
            4);
}

}  // namespace
}  // namespace foredraw::bench::merged_frames_test
