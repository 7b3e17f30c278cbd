#include <foredraw/scene/subject.h>

#include <gtest/gtest.h>

namespace foredraw::subject_test {
namespace {

/// Meshes named "a", "b", ... with one draw each, and nodes to be filled in.
Scene scene_with(std::size_t meshes, std::size_t nodes) {
  Scene scene;
  for (std::size_t i = 0; i < meshes; ++i) {
    scene.draws.emplace_back();
    Mesh mesh;
    mesh.name = std::string(1, static_cast<char>('a' + i));
    mesh.draws = {static_cast<DrawId>(i)};
    scene.meshes.push_back(mesh);
  }
  scene.nodes.resize(nodes);
  return scene;
}

void add_skin(Scene& scene, std::string name, std::vector<NodeId> joints) {
  Skin skin;
  skin.name = std::move(name);
  skin.joints = std::move(joints);
  scene.skins.push_back(std::move(skin));
}

/// "name: draw@node draw@node" for each subject, "-" for no node.
std::vector<std::string> told(const Scene& scene, SubjectUnit unit = SubjectUnit::character) {
  std::vector<std::string> lines;
  for (const Subject& subject : subjects_of(scene, unit)) {
    std::string line = subject.name + ":";
    for (const SubjectPart& part : subject.parts) {
      line.append(" ").append(std::to_string(part.draw)).append("@");
      line.append(part.node ? std::to_string(*part.node) : "-");
    }
    lines.push_back(line);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Subjects, each_mesh_is_one_in_its_own_space) {
  Scene scene = scene_with(3, 3);
  scene.nodes[0].mesh = 1;
  scene.nodes[1].mesh = 1;  // twice in the scene, once here; 0 and 2 are in no node
  scene.meshes[0].draws = {0, 2};
  scene.meshes[2].name = "";
  EXPECT_EQ(told(scene), (Lines{"a: 0@- 2@-", "b: 1@-", "mesh 2: 2@-"}));
  EXPECT_EQ(told(Scene()), Lines());
}

TEST(Subjects, a_mesh_whose_shape_an_animation_changes_is_one_for_each_node_that_does) {
  Scene scene = scene_with(3, 6);
  for (const NodeId node : {1, 3, 4}) scene.nodes[node].mesh = 1;  // 4 is not animated
  scene.nodes[2].mesh = 2;
  scene.nodes[5].mesh = 0;
  scene.nodes[5].skin = 0;
  add_skin(scene, "Knight", {0});
  const auto moves = [](NodeId node, AnimatedPath path) {
    AnimationChannel channel;
    channel.node = node;
    channel.path = path;
    return channel;
  };
  const AnimatedPath weights = AnimatedPath::weights;
  scene.animations = {
      {"Wave", {moves(3, weights), moves(2, AnimatedPath::scale), moves(5, weights), moves(99, weights)}},
      {"Flow", {moves(1, weights), moves(3, weights), moves(0, weights)}}};
  EXPECT_EQ(told(scene), (Lines{"Knight: 0@5", "b: 1@1", "b: 1@3", "c: 2@-"}));
}

TEST(Subjects, a_character_is_its_skinned_meshes_and_what_its_joints_carry) {
  Scene scene = scene_with(4, 6);
  scene.nodes[0].children = {1};  // joints 0, 1
  scene.nodes[1].children = {2};  // no joint, but below one
  scene.nodes[2].mesh = 0;        // a sword
  scene.nodes[3].mesh = 2;        // body and head
  scene.nodes[3].skin = 0;
  scene.nodes[4].mesh = 1;
  scene.nodes[4].skin = 0;
  scene.nodes[5].mesh = 3;  // a house
  add_skin(scene, "Knight", {0, 1});
  EXPECT_EQ(told(scene), (Lines{"Knight: 0@2 2@3 1@4", "d: 3@-"}));
}

TEST(Subjects, may_be_single_meshes_or_all_that_the_scene_shows) {
  Scene scene = scene_with(5, 8);
  scene.nodes[0].children = {1};  // a joint, and a sword below it
  scene.nodes[1].mesh = 0;
  scene.nodes[2].mesh = 1;  // a body, twice
  scene.nodes[2].skin = 0;
  scene.nodes[3].mesh = 1;
  scene.nodes[3].skin = 0;
  scene.nodes[4].mesh = 2;  // a chair, twice
  scene.nodes[5].mesh = 2;
  scene.nodes[6].mesh = 3;  // hidden
  scene.nodes[6].is_shown = false;
  add_skin(scene, "Knight", {0});
  EXPECT_EQ(told(scene, SubjectUnit::mesh), (Lines{"a: 0@-", "b: 1@2", "b: 1@3", "c: 2@-", "d: 3@-", "e: 4@-"}));
  EXPECT_EQ(told(scene, SubjectUnit::scene), (Lines{"scene: 0@1 1@2 1@3 2@4 2@5", "d: 3@-", "e: 4@-"}));
  EXPECT_EQ(told(Scene(), SubjectUnit::scene), Lines());
}

TEST(Subjects, are_drawn_as_the_walk_has_nodes_and_meshes_have_draws) {
  Scene scene = scene_with(3, 5);
  scene.nodes[4].children = {3, 1};
  scene.nodes[3].children = {0};
  scene.nodes[0].mesh = 0;
  scene.nodes[1].mesh = 1;
  scene.nodes[4].mesh = 2;
  scene.meshes[1].draws = {2, 1};
  add_skin(scene, "Knight", {4});
  EXPECT_EQ(told(scene), (Lines{"Knight: 2@4 0@0 2@1 1@1"}));
}

TEST(Subjects, skins_that_share_a_joint_are_one_character) {
  Scene scene = scene_with(3, 5);
  for (NodeId node = 0; node < 3; ++node) {
    scene.nodes[node].mesh = node;
    scene.nodes[node].skin = node;
  }
  add_skin(scene, "", {3});
  add_skin(scene, "Other", {4});
  add_skin(scene, "Boots", {3});
  scene.nodes[3].name = "Hips";
  EXPECT_EQ(told(scene), (Lines{"Hips: 0@0 2@2", "Other: 1@1"}));
}

TEST(Subjects, a_rider_belongs_to_the_horse) {
  Scene scene = scene_with(2, 5);
  scene.nodes[0].children = {1};  // the horse's joint carries a saddle, that the rider's root
  scene.nodes[1].children = {2};
  scene.nodes[3].mesh = 0;
  scene.nodes[3].skin = 0;
  scene.nodes[4].mesh = 1;
  scene.nodes[4].skin = 1;
  add_skin(scene, "Rider", {2});
  add_skin(scene, "Horse", {0});
  EXPECT_EQ(told(scene), (Lines{"Rider: 0@3 1@4"}));
}

TEST(Subjects, a_mesh_that_a_character_shows_is_judged_there_alone) {
  Scene scene = scene_with(2, 4);
  scene.nodes[0].children = {1, 2};
  scene.nodes[1].mesh = 1;  // two wheels of the same mesh
  scene.nodes[2].mesh = 1;
  scene.nodes[3].mesh = 1;  // and a spare one
  add_skin(scene, "", {0});
  EXPECT_EQ(told(scene), (Lines{"character 0: 1@1 1@2", "a: 0@-"}));
}

TEST(Subjects, the_root_joint_names_a_character_wherever_it_is_listed) {
  Scene scene = scene_with(1, 3);
  scene.nodes[0].name = "Hand";
  scene.nodes[1].name = "Arm";
  scene.nodes[1].children = {0};
  scene.nodes[2].mesh = 0;
  scene.nodes[2].skin = 0;
  add_skin(scene, "", {0, 1});
  EXPECT_EQ(told(scene), (Lines{"Arm: 0@2"}));
}

}  // namespace
}  // namespace foredraw::subject_test
