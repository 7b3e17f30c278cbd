#include "plugins/processors/merge_instances/merge_scene.h"

#include "support/placements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>

#include <foredraw/runtime/merge_instances.h>

namespace foredraw::merge_instances_test {
namespace {

using testing::all_draws;
using testing::Placements;
using testing::random_placements;
using testing::random_transform;
using testing::scene_with;

MergedScene merge(const Scene& scene, const MergeSceneOptions& options = {}) {
  return merge_scene(scene, all_draws(scene), options, Executor(2));
}

/// A triangle of an instance: the node, and its corners' positions bit by bit. Corners begin with the mesh's first, and
/// run as the mesh's do.
using Corner = std::array<std::uint32_t, 3>;
using Drawn = std::tuple<NodeId, DrawId, std::array<Corner, 3>>;

Corner bits_of(const VertexStreams& vertices, std::uint32_t vertex) {
  Corner corner;
  std::memcpy(corner.data(), vertices.find("POSITION")->bytes.view().data() + 12 * vertex, 12);
  return corner;
}

std::vector<Drawn> unpacked(const MergedSet& set) {
  std::vector<Drawn> drawn;
  const auto* slots = reinterpret_cast<const foredraw_merged_slot*>(set.packed.slots.data());
  for (const MergedDraw& packed : set.packed.draws) {
    const foredraw_merged_draw draw{packed.frequency, packed.first_slot, packed.slot_count, slots,
                                    set.packed.indices.data()};
    for (std::uint32_t t = 0; t < foredraw_merged_vertex_count(&draw) / 3; ++t) {
      if (foredraw_merged_is_padding(&draw, t)) continue;
      std::array<foredraw_merged_vertex, 3> at;
      for (std::uint32_t c = 0; c < 3; ++c) at[c] = foredraw_merged_vertex_at(&draw, 3 * t + c);
      EXPECT_EQ(at[0].instance, at[1].instance);
      EXPECT_EQ(at[0].instance, at[2].instance);
      const float* transform = set.packed.transforms[at[0].instance].data();
      if (foredraw_merged_is_mirrored(transform)) std::swap(at[1], at[2]);
      const processors::merge_instances::MergeablePlacement& placement =
          set.set.placements[set.packed.placed[at[0].instance]];
      std::array<Corner, 3> corners;
      for (std::size_t c = 0; c < 3; ++c) corners[c] = bits_of(*set.vertices, at[c].vertex);
      drawn.push_back({placement.place.node, set.set.meshes[placement.mesh].draw, corners});
      // The transform is the node's, bit by bit.
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) EXPECT_EQ(transform[4 * row + column], placement.world[column][row]);
      }
    }
  }
  std::ranges::sort(drawn);
  return drawn;
}

std::vector<Drawn> original(const Scene& scene) {
  std::vector<Drawn> drawn;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    for (const DrawId id : scene.meshes[*scene.nodes[n].mesh].draws) {
      const Level& level = scene.draws[id].levels[0];
      const auto indices = level.orders[0].indices.view();
      for (std::size_t i = 0; i < indices.size(); i += 3) {
        drawn.push_back({n,
                         id,
                         {bits_of(*level.vertices, indices[i]), bits_of(*level.vertices, indices[i + 1]),
                          bits_of(*level.vertices, indices[i + 2])}});
      }
    }
  }
  std::ranges::sort(drawn);
  return drawn;
}

TEST(MergeInstances, UnpackingGivesEveryInstancesTriangles) {
  for (const int frequencies : {1, 2, 3}) {
    for (const bool cut_well : {false, true}) {
      const Scene scene = scene_with(random_placements(11, 9, 40));
      MergeSceneOptions options;
      options.frequencies = frequencies;
      options.cut_well = cut_well;
      options.draw_cost = 700;  // several groups
      const MergedScene merged = merge(scene, options);
      ASSERT_EQ(merged.merged.size(), 1u);
      EXPECT_GT(merged.merged[0].layout.groups.size(), 1u);
      EXPECT_GT(merged.merged[0].packed.mirrored, 0u);
      EXPECT_EQ(unpacked(merged.merged[0]), original(scene));
      EXPECT_LE(
          merged.merged[0].packed.padded_entries,
          0.02 * static_cast<double>(merged.merged[0].packed.drawn_entries + merged.merged[0].packed.padded_entries));
    }
  }
}

/// An engine has meshes, transforms and boxes, and no scene.
TEST(MergeInstances, AnEnginesMeshesComeToTheSame) {
  const Scene scene = scene_with(random_placements(21, 9, 40));
  const MergedScene merged = merge(scene);
  ASSERT_EQ(merged.merged.size(), 1u);
  const MergedSet& set = merged.merged[0];
  std::vector<processors::merge_instances::PackedMesh> meshes;
  for (std::size_t m = 0; m < set.set.meshes.size(); ++m) {
    const Level& level = scene.draws[set.set.meshes[m].draw].levels[0];
    meshes.push_back({"mesh", level.orders[0].indices.view(), set.first_vertex[m], level.vertices->count});
  }
  std::vector<processors::merge_instances::PlacedMesh> placed;
  for (const auto& at : set.set.placements) placed.push_back({at.mesh, at.world, at.box});
  const processors::merge_instances::PackedInstances packed = merge_instances(meshes, placed, {}, Executor(2));
  EXPECT_EQ(packed.slots, set.packed.slots);
  EXPECT_EQ(packed.indices, set.packed.indices);
  EXPECT_EQ(packed.transforms, set.packed.transforms);
  EXPECT_EQ(packed.groups, set.packed.groups);
  EXPECT_EQ(packed.draws, set.packed.draws);
  placed[0].mesh = 99;
  EXPECT_THROW(merge_instances(meshes, placed, {}, Executor(1)), std::invalid_argument);
  EXPECT_TRUE(merge_instances({}, {}, {}, Executor(1)).draws.empty());
}

/// What faces the camera must face it still: the sign of the area of each drawn triangle in the world is the mesh's
/// own.
TEST(MergeInstances, TrianglesFaceAsTheyDid) {
  Placements placed{testing::grid(3, 2), {}};
  placed.at.push_back(glm::mat4(1));
  placed.at.push_back(glm::scale(glm::mat4(1), {-1, 1, 1}));  // to face +z as before, corners run the other way
  placed.at.push_back(glm::scale(glm::translate(glm::mat4(1), {4, 0, 0}), {1, -2, 1}));
  const Scene scene = scene_with({placed, {testing::grid(1, 1), {glm::mat4(1)}}});
  const MergedScene merged = merge(scene);
  ASSERT_EQ(merged.merged.size(), 1u);
  const MergedSet& set = merged.merged[0];
  const std::vector<glm::vec3> positions = decode_vec3(*set.vertices->find("POSITION"));
  for (const MergedDraw& draw : set.packed.draws) {
    for (std::uint32_t s = 0; s < draw.slot_count; ++s) {
      const MergedSlot slot = set.packed.slots[draw.first_slot + s];
      for (std::uint32_t i = 0; i < draw.frequency; i += 3) {
        std::array<glm::vec3, 3> world;
        for (std::uint32_t c = 0; c < 3; ++c) {
          const glm::vec3& at = positions[set.packed.indices[slot.index_offset + i + c]];
          foredraw_merged_to_world(set.packed.transforms[slot.instance].data(), &at.x, &world[c].x);
        }
        EXPECT_GE(glm::cross(world[1] - world[0], world[2] - world[0]).z, 0);
      }
    }
  }
}

TEST(MergeInstances, NothingIsLostOfWhatIsNotMerged) {
  std::vector<Placements> placements = random_placements(12, 4, 10);
  glm::mat4 flat = glm::scale(glm::mat4(1), {1, 0, 1});
  glm::mat4 infinite(1);
  infinite[3][0] = std::numeric_limits<float>::infinity();
  glm::mat4 skewed(1);
  skewed[0][3] = 1;
  placements[0].at.insert(placements[0].at.end(), {flat, infinite, skewed});
  Scene scene = scene_with(placements);
  scene.nodes[15].children = {};  // some other node moves
  Animation turning;
  turning.channels.push_back({.node = 20});
  scene.animations.push_back(turning);
  const MergedScene merged = merge(scene);
  ASSERT_EQ(merged.merged.size(), 1u);
  std::vector<std::string> reasons;
  for (const processors::merge_instances::LeftAlone& left : merged.left_alone) reasons.push_back(left.why);
  std::ranges::sort(reasons);
  EXPECT_EQ(reasons,
            (std::vector<std::string>{"an animation moves it, or its parent is a joint", "its transform is not affine",
                                      "its transform is not finite", "its transform is singular"}));
  EXPECT_EQ(merged.merged[0].packed.placed.size() + merged.left_alone.size(), scene.nodes.size());
}

TEST(MergeInstances, TellsWhatCanNotBeMerged) {
  Scene scene = scene_with(random_placements(13, 6, 3));
  scene.draws[0].traits.add(traits::skinned);
  scene.draws[1].traits.add(traits::blended);
  scene.draws[2].traits.add(traits::extended);
  scene.draws[3].levels[0].orders[0].indices = Shared<std::uint32_t>(std::vector<std::uint32_t>());
  scene.draws[4].material = 77;  // no such material
  const MergedScene merged = merge(scene);
  std::vector<std::string> reasons;
  for (const processors::merge_instances::LeftAlone& left : merged.left_alone) reasons.push_back(left.why);
  EXPECT_EQ(reasons, (std::vector<std::string>{"it is skinned", "it is blended, so the order of draws is visible",
                                               "an extension refers to its triangles or vertices",
                                               "it has no triangles", "its material is missing"}));
  ASSERT_EQ(merged.not_merged.size(), 1u);
  EXPECT_EQ(merged.not_merged[0].why_not, "1 mesh, 3 instances: instancing does the same");
}

TEST(MergeInstances, OneMeshIsForInstancing) {
  const Scene scene = scene_with({random_placements(14, 1, 3)[0]});
  const MergedScene merged = merge(scene);
  EXPECT_TRUE(merged.merged.empty());
  ASSERT_EQ(merged.not_merged.size(), 1u);
  EXPECT_EQ(merged.not_merged[0].why_not, "1 mesh, 3 instances: instancing does the same");
}

TEST(MergeInstances, VertexBoundMeshesAreLeftAloneWithTheFigure) {
  std::vector<Placements> placements = random_placements(15, 3, 8);
  placements.push_back({testing::grid(60, 60), {glm::mat4(1), glm::mat4(2)}});
  const MergedScene merged = merge(scene_with(placements));
  ASSERT_FALSE(merged.left_alone.empty());
  EXPECT_TRUE(
      merged.left_alone[0].why.starts_with("vertex-bound: merged, it would shade 3 vertices a triangle instead of "))
      << merged.left_alone[0].why;
}

TEST(MergeInstances, MaterialsAndLayoutsAreKeptApart) {
  Scene scene = scene_with(random_placements(16, 6, 5));
  scene.materials.resize(2);
  for (DrawId id = 0; id < 6; ++id) scene.draws[id].material = id % 2;
  const MergedScene merged = merge(scene);
  ASSERT_EQ(merged.merged.size(), 2u);
  EXPECT_EQ(merged.merged[0].set.meshes.size(), 3u);
  EXPECT_EQ(merged.merged[1].set.material, MaterialId{1});
}

TEST(MergeInstances, NoVertexIsStoredTwice) {
  Scene scene = scene_with(random_placements(17, 3, 5));
  scene.draws[1].levels[0].vertices = scene.draws[2].levels[0].vertices;
  scene.draws[1].levels[0].orders = scene.draws[2].levels[0].orders;
  const MergedScene merged = merge(scene);
  ASSERT_EQ(merged.merged.size(), 1u);
  EXPECT_EQ(merged.merged[0].vertices->count,
            scene.draws[0].levels[0].vertices->count + scene.draws[2].levels[0].vertices->count);
  EXPECT_EQ(unpacked(merged.merged[0]), original(scene));
}

TEST(MergeInstances, OfNothingThereIsNothing) {
  const MergedScene merged = merge(Scene{});
  EXPECT_TRUE(merged.merged.empty());
  EXPECT_TRUE(merged.not_merged.empty());
  EXPECT_TRUE(merged.left_alone.empty());
}

TEST(MergeInstances, AHundredThousandInstancesOf150MeshesAreOneSet) {
  std::vector<Placements> placements = random_placements(19, 150, 0);
  Random random(20);
  for (int i = 0; i < 100'000; ++i) placements[random.below(150)].at.push_back(random_transform(random));
  const Scene scene = scene_with(placements);
  const Executor executor(2);
  const MergedScene merged = merge_scene(scene, all_draws(scene), {}, executor);
  ASSERT_EQ(merged.merged.size(), 1u);
  EXPECT_TRUE(merged.not_merged.empty());
}

TEST(MergeInstances, IsTheSameAtAnyNumberOfThreads) {
  const Scene scene = scene_with(random_placements(18, 20, 500));
  MergeSceneOptions options;
  options.draw_cost = 500;
  const MergedScene one = merge_scene(scene, all_draws(scene), options, Executor(1));
  const MergedScene many = merge_scene(scene, all_draws(scene), options, Executor(0));
  ASSERT_EQ(one.merged.size(), 1u);
  EXPECT_EQ(one.merged[0].packed.slots, many.merged[0].packed.slots);
  EXPECT_EQ(one.merged[0].packed.indices, many.merged[0].packed.indices);
  EXPECT_EQ(one.merged[0].layout.groups.instances, many.merged[0].layout.groups.instances);
}

}  // namespace
}  // namespace foredraw::merge_instances_test
