#include <foredraw/scene/part_groups.h>

#include <gtest/gtest.h>

namespace foredraw::part_groups_test {
namespace {

using Sequence = std::vector<std::uint32_t>;
using Groups = std::vector<PartGroup>;

constexpr auto any = [](DrawId) { return true; };

/// Node 0 is the root of a character. It shows mesh 0 (draws 0, 1, 2) and has children 1 and 2; 1 shows mesh 1 (draw 3)
/// and has child 3 with mesh 2 (draws 4, 5); 2 shows mesh 3 (draw 6).
Scene character() {
  Scene scene;
  scene.draws.resize(7);
  scene.meshes.resize(4);
  scene.meshes[0].draws = {0, 1, 2};
  scene.meshes[1].draws = {3};
  scene.meshes[2].draws = {4, 5};
  scene.meshes[3].draws = {6};
  scene.nodes.resize(4);
  scene.nodes[0].mesh = 0;
  scene.nodes[1].mesh = 1;
  scene.nodes[2].mesh = 3;
  scene.nodes[3].mesh = 2;
  scene.nodes[0].children = {1, 2};
  scene.nodes[1].children = {3};
  scene.skins.push_back({"Hero", {0}, {}});
  return scene;
}

Groups groups_of(const Scene& scene, const std::function<bool(DrawId)>& may_move = any, std::size_t subject = 0) {
  const std::vector<Subject> subjects = subjects_of(scene);
  return PartGroups(scene, subjects, may_move).of(subject);
}

std::vector<DrawId> drawn(const Scene& scene) {
  std::vector<DrawId> draws;
  const std::vector<Subject> subjects = subjects_of(scene);
  for (const SubjectPart& part : subjects[0].parts) draws.push_back(part.draw);
  return draws;
}

TEST(PartGroups, are_the_draws_of_meshes_and_what_hangs_below_nodes) {
  EXPECT_EQ(drawn(character()), (std::vector<DrawId>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(groups_of(character()), (Groups{{{4, 5, 6}}, {{0, 1, 2, 3}}, {{3, 6, 7}}}));
}

TEST(PartGroups, may_be_below_the_roots_that_the_scene_names) {
  Scene scene;
  scene.draws.resize(4);
  scene.meshes.resize(4);
  scene.nodes.resize(4);
  for (std::uint32_t i = 0; i < 4; ++i) {
    scene.meshes[i].draws = {i};
    scene.nodes[i].mesh = i;
  }
  scene.roots = {2, 0, 1};
  const std::vector<Subject> subjects = subjects_of(scene, SubjectUnit::scene);
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_EQ(subjects[0].parts, (std::vector<SubjectPart>{{2, 2}, {0, 0}, {1, 1}, {3, 3}})) << "3 is named nowhere";
  EXPECT_EQ(PartGroups(scene, subjects, any).of(0), (Groups{{{0, 1, 2, 3}}}));
  const std::vector<std::vector<SubjectPart>> wanted{{{1, 1}, {2, 2}, {0, 0}, {3, 3}}};
  put_in_sequence(scene, wanted);
  EXPECT_EQ(scene.roots, (std::vector<NodeId>{1, 2, 0}));
  EXPECT_EQ(subjects_of(scene, SubjectUnit::scene)[0].parts, wanted[0]);
}

TEST(PartGroups, of_a_mesh_in_its_own_space_are_its_draws) {
  Scene scene = character();
  scene.skins.clear();
  EXPECT_EQ(groups_of(scene), (Groups{{{0, 1, 2, 3}}}));
  EXPECT_EQ(groups_of(scene, any, 1), Groups()) << "a single draw";
  scene.nodes[0].keeps_mesh = true;
  EXPECT_EQ(groups_of(scene), Groups());
}

TEST(PartGroups, let_nothing_pass_what_may_not_move) {
  const auto all_but = [](DrawId fixed) { return [fixed](DrawId draw) { return draw != fixed; }; };
  EXPECT_EQ(groups_of(character(), all_but(1)), (Groups{{{4, 5, 6}}, {{3, 6, 7}}}));
  EXPECT_EQ(groups_of(character(), all_but(2)), (Groups{{{4, 5, 6}}, {{0, 1, 2}}, {{3, 6, 7}}}));
  EXPECT_EQ(groups_of(character(), all_but(4)), (Groups{{{0, 1, 2, 3}}})) << "nor what is below its node's parent";
  Scene spoken_of = character();
  spoken_of.nodes[2].keeps_mesh = true;
  EXPECT_EQ(groups_of(spoken_of), (Groups{{{4, 5, 6}}, {{0, 1, 2, 3}}}));
}

TEST(PartGroups, leave_what_belongs_to_two) {
  Scene twice = character();
  twice.nodes[2].mesh = 2;  // draws 4 and 5 again
  EXPECT_EQ(groups_of(twice), (Groups{{{0, 1, 2, 3}}, {{3, 6, 8}}}));
  Scene two = character();
  two.skins[0].joints = {1};
  two.nodes[0].skin = 0;
  two.nodes[2].skin = 0;
  two.nodes.resize(6);
  two.nodes[2].children = {4};
  two.nodes[4].mesh = 3;
  two.nodes[4].skin = 1;
  two.skins.push_back({"Other", {5}, {}});
  ASSERT_EQ(subjects_of(two).size(), 2u);
  EXPECT_EQ(groups_of(two), (Groups{{{4, 5, 6}}, {{0, 1, 2, 3}}}));
}

TEST(PartGroups, allow_what_moves_whole_runs) {
  const Groups groups = groups_of(character());
  EXPECT_TRUE(is_allowed(Sequence{0, 1, 2, 3, 4, 5, 6}, groups));
  EXPECT_TRUE(is_allowed(Sequence{2, 0, 1, 6, 3, 5, 4}, groups));
  EXPECT_FALSE(is_allowed(Sequence{0, 1, 2, 3, 6, 4, 5}, groups)) << "a run is torn";
  EXPECT_FALSE(is_allowed(Sequence{3, 4, 5, 0, 1, 2, 6}, groups)) << "children before their parent";
  EXPECT_FALSE(is_allowed(Sequence{0, 1, 2, 4, 3, 5, 6}, groups));
  EXPECT_TRUE(is_allowed(Sequence{0, 1}, {}));
  EXPECT_FALSE(is_allowed(Sequence{1, 0}, {}));
}

TEST(PartGroups, are_put_into_sequence_without_a_new_number) {
  Scene scene = character();
  const Subject subject = subjects_of(scene)[0];
  std::vector<SubjectPart> parts;
  for (const std::uint32_t part : {2, 0, 1, 6, 3, 5, 4}) parts.push_back(subject.parts[part]);
  put_in_sequence(scene, {&parts, 1});
  EXPECT_EQ(subjects_of(scene)[0].parts, parts);
  EXPECT_EQ(scene.meshes[0].draws, (std::vector<DrawId>{2, 0, 1}));
  EXPECT_EQ(scene.nodes[0].children, (std::vector<NodeId>{2, 1}));
  EXPECT_EQ(scene.nodes[1].children, (std::vector<NodeId>{3}));
}

}  // namespace
}  // namespace foredraw::part_groups_test
