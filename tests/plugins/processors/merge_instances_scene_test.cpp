// What the stage makes of a scene: what is drawn by whom, and with which materials.

#include "plugins/processors/merge_instances/merge_scene.h"

#include "support/merged_draws.h"
#include "support/placements.h"

#include <foredraw/runtime/merge_instances.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

namespace foredraw::merge_instances_scene_test {
namespace {

using testing::all_draws;
using testing::all_places;
using testing::random_placements;
using testing::scene_with;

/// What the stage says.
struct Said {
  std::vector<DrawId> changed;
  std::vector<std::string> notes;
  std::map<std::string, double> figures;
};

Said merge(Scene& scene, const Settings& settings = {}) {
  testing::RunFixture fixture;
  const Technique technique = merge_instances_plugin().create(settings);
  Said said;
  said.changed = std::get<std::unique_ptr<Processor>>(technique)->process(scene, all_draws(scene), fixture.run);
  mark_held_draws(scene, merge_instances_plugin().products);  // as the runner does
  for (const auto& note : fixture.findings.notes) said.notes.push_back(note.message);
  for (const Measured& figure : fixture.findings.measured) said.figures[figure.metric] = figure.numerator;
  return said;
}

using Words = std::vector<std::uint32_t>;

template <class T>
void put(Words& words, const T& value) {
  words.resize(words.size() + sizeof(T) / 4);
  std::memcpy(words.data() + words.size() - sizeof(T) / 4, &value, sizeof(T));
}

void put_position(Words& words, const VertexStreams& vertices, std::uint32_t vertex) {
  std::array<float, 3> position{};
  std::memcpy(position.data(), vertices.find("POSITION")->bytes.view().data() + 12 * std::size_t{vertex}, 12);
  put(words, position);
}

/// Each place's triangles, bit by bit and in their sequence, with its transform and its material, as its node has them.
std::vector<Words> drawn_by_nodes(const Scene& scene, const std::vector<MergedPlace>& places) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::vector<Words> all;
  for (const MergedPlace& place : places) {
    const Node& node = scene.nodes[place.node];
    const Draw& draw = scene.draws[scene.meshes[*node.mesh].draws[place.primitive]];
    const auto instances = node.instances.view();
    const glm::mat4 world =
        worlds[place.node] * (instances.empty() ? glm::mat4(1) : instances[place.instance].matrix());
    Words words;
    put(words, place);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) put(words, world[column][row]);
    }
    for (const std::uint32_t index : draw.levels[0].orders[0].indices.view())
      put_position(words, *draw.levels[0].vertices, index);
    all.push_back(std::move(words));
  }
  std::ranges::sort(all);
  return all;
}

/// The same as the merged draws have them.
std::vector<Words> drawn_merged(const Scene& scene) {
  std::vector<Words> all;
  for (const MergedInstances& set : merged_sets(scene)) {
    EXPECT_EQ(mistake_in(set), std::nullopt);
    std::vector<Words> own(set.places.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      put(own[i], set.places.view()[i]);
      put(own[i], set.transforms.view()[i]);
    }
    const auto* slots = reinterpret_cast<const foredraw_merged_slot*>(set.slots.view().data());
    for (const MergedDraw& one : set.draws) {
      const foredraw_merged_draw draw{one.frequency, one.first_slot, one.slot_count, slots, set.indices.view().data()};
      for (std::uint32_t t = 0; t < foredraw_merged_vertex_count(&draw) / 3; ++t) {
        if (foredraw_merged_is_padding(&draw, t)) continue;
        std::array<foredraw_merged_vertex, 3> at;
        for (std::uint32_t c = 0; c < 3; ++c) at[c] = foredraw_merged_vertex_at(&draw, 3 * t + c);
        const std::uint32_t instance = at[0].instance;
        if (foredraw_merged_is_mirrored(set.transforms.view()[instance].data())) std::swap(at[1], at[2]);
        for (const foredraw_merged_vertex& corner : at) put_position(own[instance], *set.vertices, corner.vertex);
      }
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  std::ranges::sort(all);
  return all;
}

bool has_note(const Said& said, const std::string& part) {
  return std::ranges::any_of(said.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(MergeInstancesOfScene, NodesStayAndMergedDrawsShowTheSame) {
  const Scene before = scene_with(random_placements(41, 6, 30));
  Scene scene = before;
  const Said said = merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_EQ(said.changed, all_draws(scene));
  EXPECT_EQ(merged_places(scene), all_places(scene));
  EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, all_places(before)));
  EXPECT_EQ(scene.nodes.size(), before.nodes.size());
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    EXPECT_TRUE(scene.draws[id].traits.has(traits::extended)) << "no later stage may move its vertices";
    EXPECT_EQ(scene.draws[id].levels[0].vertices, before.draws[id].levels[0].vertices);
  }
  EXPECT_EQ(said.figures.at("draws"), static_cast<double>(merged_sets(scene)[0].draws.size()));
  EXPECT_EQ(said.figures.at("slots"), static_cast<double>(merged_sets(scene)[0].slots.size()));
  for (const MergedGroup& group : merged_sets(scene)[0].groups) EXPECT_GT(group.instance_count, 0u);
}

TEST(MergeInstancesOfScene, MergingAgainChangesNothing) {
  Scene scene = scene_with(random_placements(42, 5, 20));
  merge(scene);
  const Products once = scene.products;
  const Said said = merge(scene);
  EXPECT_TRUE(scene.products.same(MergedDraws::product, once));
  EXPECT_TRUE(said.changed.empty());
  EXPECT_TRUE(has_note(said, "an extension refers to its triangles or vertices"));
}

TEST(MergeInstancesOfScene, InstancesOfANodeArePlacedMirroredOnesTooAndSingularOnesStay) {
  Scene scene = scene_with(random_placements(43, 3, 4));
  std::vector<Transform> instances(9);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    instances[i].translation = {static_cast<float>(i), 1, -3};
    instances[i].rotation = glm::angleAxis(0.3f * static_cast<float>(i), glm::vec3(0, 1, 0));
  }
  instances[2].scale = {-1, 2, 1};
  instances[3].scale = {-1, -2, 1};
  instances[5].scale = {0, 1, 1};
  instances[7].scale = {1, 1e-30f, 1};
  scene.nodes[1].instances = Shared(instances);
  scene.nodes[1].matrix = glm::scale(glm::mat4(1), {1, 1, -2});
  const Scene before = scene;
  const Said said = merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_EQ(scene.nodes[1].instances, before.nodes[1].instances);
  std::vector<MergedPlace> places = all_places(before);
  EXPECT_EQ(std::erase(places, MergedPlace{1, 0, 5}), 1u);
  // However flat: it has an inverse.
  EXPECT_EQ(merged_places(scene), places);
  EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, places));
  EXPECT_TRUE(has_note(said, "not merged in 1 placement: its transform is singular"));
  EXPECT_EQ(said.figures.at("draws"), static_cast<double>(merged_sets(scene)[0].draws.size()) + 1)
      << "the node is drawn still";
}

TEST(MergeInstancesOfScene, PrimitivesOfAMeshAreMergedEachForItself) {
  Scene scene = scene_with(random_placements(44, 4, 3));
  scene.meshes = {{"house", {0, 1}, {}}, {"barn", {2, 3, 0}, {}}};
  for (NodeId n = 0; n < scene.nodes.size(); ++n) scene.nodes[n].mesh = n % 2;
  scene.draws[1].traits.add(traits::blended);
  const Scene before = scene;
  merge(scene);
  std::vector<MergedPlace> places = all_places(before);
  std::erase_if(places, [&](const MergedPlace& place) { return place.node % 2 == 0 && place.primitive == 1; });
  EXPECT_EQ(merged_places(scene), places);
  EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, places));
  EXPECT_FALSE(scene.draws[1].traits.has(traits::extended));
}

TEST(MergeInstancesOfScene, NodesThatTheFileDoesNotShowStay) {
  Scene scene = scene_with(random_placements(45, 3, 6));
  for (const NodeId n : {2u, 9u}) scene.nodes[n].is_shown = false;
  const Said said = merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_EQ(merged_sets(scene)[0].places.size(), 16u);
  EXPECT_TRUE(
      has_note(said, "not merged in 1 placement: it is not shown: hidden, or not in the scene that the file shows"));
  EXPECT_EQ(said.figures.at("draws"), static_cast<double>(merged_sets(scene)[0].draws.size()));
}

/// Six meshes of materials 0, 1 and 2 in turns.
Scene with_materials() {
  Scene scene = scene_with(random_placements(46, 6, 20));
  scene.materials.resize(3);
  for (DrawId id = 0; id < 6; ++id) scene.draws[id].material = id % 3;
  for (MaterialId m = 0; m < 3; ++m) {
    scene.materials[m].look = Stamp{m < 2 ? 1u : 2u, 0};
    scene.materials[m].kind = Stamp{3, 0};
  }
  return scene;
}

TEST(MergeInstancesOfScene, MaterialsThatLookAlikeShareASet) {
  Scene scene = with_materials();
  merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 2u);
  EXPECT_EQ(merged_sets(scene)[0].material, MaterialId{0});
  EXPECT_EQ(merged_sets(scene)[0].meshes.size(), 4u);
  EXPECT_TRUE(merged_sets(scene)[0].materials.empty()) << "the first one's do for all";
  EXPECT_EQ(merged_sets(scene)[1].material, MaterialId{2});
}

TEST(MergeInstancesOfScene, SetsOfOneLayoutShareTheirVertices) {
  Scene scene = with_materials();
  const Scene before = scene;
  merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 2u);
  EXPECT_EQ(merged_sets(scene)[0].vertices, merged_sets(scene)[1].vertices);
  std::uint32_t count = 0;
  for (const Draw& draw : before.draws) count += draw.levels[0].vertices->count;
  EXPECT_EQ(merged_sets(scene)[0].vertices->count, count);
  EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, all_places(before)));
}

TEST(MergeInstancesOfScene, MaterialsOfOneKindAreTheInstances) {
  for (const bool is_known : {true, false}) {
    Scene scene = with_materials();
    for (Material& material : scene.materials) {
      if (!is_known) material.look.reset();  // of what looks like nobody knows what, nothing is alike
    }
    const Scene before = scene;
    merge(scene, {{"materials", std::string("kind")}});
    ASSERT_EQ(merged_sets(scene).size(), 1u);
    const MergedInstances& set = merged_sets(scene)[0];
    ASSERT_EQ(set.materials.size(), set.places.size());
    for (std::size_t i = 0; i < set.places.size(); ++i) {
      const MeshId mesh = *before.nodes[set.places.view()[i].node].mesh;
      EXPECT_EQ(set.materials.view()[i], before.draws[before.meshes[mesh].draws[0]].material);
    }
    EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, all_places(before)));
  }
}

TEST(MergeInstancesOfScene, WhatIsNotWorthItStaysAsItWas) {
  Scene scene = scene_with({random_placements(47, 1, 5)[0]});
  const Said said = merge(scene);
  EXPECT_TRUE(merged_sets(scene).empty());
  EXPECT_TRUE(said.changed.empty());
  EXPECT_FALSE(scene.draws[0].traits.has(traits::extended));
  EXPECT_TRUE(has_note(said, "1 mesh, 5 instances: instancing does the same"));
}

TEST(MergeInstancesOfScene, MeshesThatNoNodePlacesStay) {
  Scene scene = scene_with(random_placements(49, 3, 5));
  scene.nodes.resize(10);
  const Said said = merge(scene);
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  EXPECT_EQ(merged_sets(scene)[0].meshes.size(), 2u);
  EXPECT_EQ(said.notes, std::vector<std::string>{"not merged: no node places it"});
  EXPECT_FALSE(scene.draws[2].traits.has(traits::extended));
  Scene without = scene_with(random_placements(49, 3, 5));
  without.nodes.clear();
  EXPECT_EQ(merge(without).notes.size(), 3u);
}

TEST(MergeInstancesOfScene, DrawsAreOfAsManyEntriesAsAskedFor) {
  Scene scene = scene_with(random_placements(48, 5, 60));
  const Scene before = scene;
  merge(scene,
        {{"most-indices", std::int64_t{6000}}, {"most-instances", std::int64_t{50}}, {"frequencies", std::int64_t{4}}});
  ASSERT_EQ(merged_sets(scene).size(), 1u);
  for (const MergedGroup& group : merged_sets(scene)[0].groups) EXPECT_LE(group.instance_count, 50u);
  EXPECT_GE(merged_sets(scene)[0].groups.size(), 6u);
  EXPECT_EQ(drawn_merged(scene), drawn_by_nodes(before, all_places(before)));
}

TEST(MergeInstancesOfScene, SlotsOfNoWholeTrianglesAreRefusedInThePlan) {
  EXPECT_THROW(merge_instances_plugin().create({{"multiple", std::int64_t{4}}}), std::invalid_argument);
  EXPECT_NO_THROW(merge_instances_plugin().create({{"multiple", std::int64_t{96}}}));
}

}  // namespace
}  // namespace foredraw::merge_instances_scene_test
