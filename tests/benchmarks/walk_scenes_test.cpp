// Scenes that a camera walks through, as the program writes them: what they promise, and that the camera meets nothing.
#include "building_plan.h"
#include "walk_scene.h"

#include "support/gltf_builder.h"
#include "support/meshes.h"

#include <foredraw/io/gltf/gltf.h>

#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace foredraw::bench::walk_scenes_test {
namespace {

using MakeScene = Scene (*)(const WalkOptions&);
constexpr std::pair<const char*, MakeScene> all_scenes[] = {
    {"city", city_walk}, {"field", field_walk}, {"building", building_walk}};

WalkOptions options(std::uint64_t instances, std::uint64_t seed = 1) {
  WalkOptions wanted;
  wanted.instances = instances;
  wanted.seed = seed;
  wanted.characters = 24;
  wanted.corpus = testing::project_file("benchmarks/corpus");
  return wanted;
}

std::vector<std::byte> written(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "walk.glb", diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  return files->front().bytes;
}

Scene read_again(const Scene& scene, Diagnostics& diagnostics) {
  auto read = read_gltf(written(scene), "walk.glb", {}, diagnostics);
  if (!read) throw std::runtime_error(to_text(diagnostics));
  return *read;
}

struct Counts {
  std::uint64_t placed = 0, dense = 0;  ///< primitives; those of them with 2,000 triangles or more
};
Counts counts_of(const Scene& scene) {
  Counts counts;
  for (const Node& node : scene.nodes) {
    if (!node.mesh) continue;
    const std::uint64_t times = std::max<std::size_t>(node.instances.view().size(), 1);
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      counts.placed += times;
      if (scene.draws[draw].full().stream().triangle_count() >= 2000) counts.dense += times;
    }
  }
  return counts;
}

const Animation& walk_of(const Scene& scene) {
  const auto found = std::ranges::find(scene.animations, "walk", &Animation::name);
  if (found == scene.animations.end()) throw std::runtime_error("no clip 'walk'");
  return *found;
}

const AnimationChannel& camera_channel(const Scene& scene, AnimatedPath path) {
  for (const AnimationChannel& channel : walk_of(scene).channels) {
    if (scene.nodes[channel.node].has_camera && channel.path == path) return channel;
  }
  throw std::runtime_error("the camera does not move");
}

/// Keys and three places between each and the next.
std::vector<glm::vec3> camera_places(const Scene& scene) {
  const auto values = camera_channel(scene, AnimatedPath::translation).values.view();
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i + 5 < values.size(); i += 3) {
    const glm::vec3 from(values[i], values[i + 1], values[i + 2]), to(values[i + 3], values[i + 4], values[i + 5]);
    for (const float part : {0.f, .25f, .5f, .75f}) places.push_back(from + part * (to - from));
  }
  return places;
}

struct Box {
  glm::vec3 least{1e30f}, most{-1e30f};
};
Box box_of(const Scene& scene, MeshId mesh) {
  Box box;
  for (const DrawId draw : scene.meshes[mesh].draws) {
    for (const VertexStream& stream : scene.draws[draw].full().vertices->base) {
      if (stream.semantic != "POSITION") continue;
      for (const glm::vec3& place : decode_vec3(stream)) {
        box.least = glm::min(box.least, place);
        box.most = glm::max(box.most, place);
      }
    }
  }
  return box;
}

/// The names of the models whose box (in their own space, made larger by `margin` of the world's units) the camera
/// enters. Ground is left out, and skinned meshes, which are where their joints are.
std::set<std::string> entered(const Scene& scene, float margin) {
  std::map<MeshId, Box> boxes;
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  const std::vector<glm::vec3> places = camera_places(scene);
  std::set<std::string> names;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh || node.skin || scene.meshes[*node.mesh].name.starts_with("ground")) continue;
    const auto [box, is_new] = boxes.try_emplace(*node.mesh);
    if (is_new) box->second = box_of(scene, *node.mesh);
    const glm::mat4 inwards = glm::inverse(worlds[n]);
    const float scale = glm::length(glm::vec3(inwards[0]));
    for (const glm::vec3& place : places) {
      const glm::vec3 at = glm::vec3(inwards * glm::vec4(place, 1));
      const bool is_inside = glm::all(glm::greaterThan(at, box->second.least - margin * scale)) &&
                             glm::all(glm::lessThan(at, box->second.most + margin * scale));
      if (is_inside) names.insert(scene.meshes[*node.mesh].name);
    }
  }
  return names;
}

TEST(WalkScenes, the_seed_decides_every_byte) {
  for (const auto& [name, make] : all_scenes) {
    EXPECT_EQ(written(make(options(700, 3))), written(make(options(700, 3)))) << name;
    EXPECT_NE(written(make(options(700, 3))), written(make(options(700, 4)))) << name;
  }
}

TEST(WalkScenes, are_read_without_a_word) {
  for (const auto& [name, make] : all_scenes) {
    Diagnostics diagnostics;
    const Scene scene = read_again(make(options(700)), diagnostics);
    EXPECT_TRUE(diagnostics.all().empty()) << name << ": " << to_text(diagnostics);
    EXPECT_GE(counts_of(scene).placed, 700u) << name;
  }
}

TEST(WalkScenes, the_camera_walks_smoothly_for_twelve_seconds) {
  for (const auto& [name, make] : all_scenes) {
    const Scene scene = make(options(700));
    EXPECT_EQ(std::ranges::count_if(scene.nodes, &Node::has_camera), 1) << name;
    for (const AnimatedPath path : {AnimatedPath::translation, AnimatedPath::rotation}) {
      const AnimationChannel& channel = camera_channel(scene, path);
      EXPECT_EQ(channel.interpolation, Interpolation::linear);
      EXPECT_EQ(channel.times.view().front(), 0);
      EXPECT_EQ(channel.times.view().back(), 12);
    }
    const auto places = camera_channel(scene, AnimatedPath::translation).values.view();
    const auto turns = camera_channel(scene, AnimatedPath::rotation).values.view();
    ASSERT_EQ(places.size() / 3, turns.size() / 4);
    float longest = 0, shortest = 1e30f, least_alike = 1;
    for (std::size_t i = 1; i < places.size() / 3; ++i) {
      float step = 0, alike = 0;
      for (std::size_t k = 0; k < 3; ++k)
        step += (places[3 * i + k] - places[3 * i - 3 + k]) * (places[3 * i + k] - places[3 * i - 3 + k]);
      for (std::size_t k = 0; k < 4; ++k) alike += turns[4 * i + k] * turns[4 * i - 4 + k];
      longest = std::max(longest, std::sqrt(step));
      shortest = std::min(shortest, std::sqrt(step));
      least_alike = std::min(least_alike, alike);
    }
    EXPECT_LT(longest, 1.6f * shortest) << name;
    EXPECT_GT(least_alike, std::cos(.04f)) << name << ": it turns by more than .08 from key to key";
  }
}

TEST(WalkScenes, the_camera_is_perspective_and_sixty_degrees_high) {
  for (const auto& [name, make] : all_scenes) {
    const testing::GltfJson json = testing::json_of(written(make(options(700))));
    ASSERT_EQ(json["cameras"].size(), 1u) << name;
    EXPECT_EQ(json["cameras"][0]["type"], "perspective");
    EXPECT_NEAR(json["cameras"][0]["perspective"]["yfov"].get<double>(), std::acos(-1.0) / 3, 1e-9);
  }
}

/// Pictures in full, without normal maps and unlit differ only where materials have something to leave out.
TEST(WalkScenes, there_are_materials_with_normal_maps_with_textures_and_plain_ones) {
  for (const auto& [name, make] : all_scenes) {
    const testing::GltfJson json = testing::json_of(written(make(options(700))));
    int full = 0, textured = 0, plain = 0;
    for (const auto& material : json["materials"]) {
      const bool has_texture = material["pbrMetallicRoughness"].contains("baseColorTexture");
      full += has_texture && material.contains("normalTexture");
      textured += has_texture && !material.contains("normalTexture");
      plain += !has_texture && !material.contains("normalTexture");
    }
    EXPECT_GE(full, 3) << name;
    EXPECT_GE(textured, 1) << name;
    EXPECT_GE(plain, name == std::string("field") ? 0 : 2) << name;
    for (const auto& mesh : json["meshes"]) {
      for (const auto& primitive : mesh["primitives"]) {
        const bool has_map = json["materials"][primitive["material"].get<std::size_t>()].contains("normalTexture");
        EXPECT_EQ(primitive["attributes"].contains("TANGENT"), has_map) << mesh["name"];
      }
    }
  }
}

TEST(WalkScenes, the_city_is_large_and_two_thirds_of_it_are_dense) {
  const Scene scene = city_walk(options(0));
  const Counts counts = counts_of(scene);
  EXPECT_GE(counts.placed, 100'000u);
  EXPECT_GE(3 * counts.dense, 2 * counts.placed);
  EXPECT_GE(scene.meshes.size(), 100u);
}

TEST(WalkScenes, the_city_camera_stays_above_streets) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Scene scene = city_walk(options(8000, seed));
    EXPECT_EQ(entered(scene, .02f), std::set<std::string>()) << seed;
    for (const glm::vec3& place : camera_places(scene)) {
      const float x = std::abs(place.x - 10 * std::round(place.x / 10)),
                  z = std::abs(place.z - 10 * std::round(place.z / 10));
      ASSERT_LT(std::min(x, z), .5f);
      ASSERT_GT(place.y, .5f);
    }
  }
}

TEST(WalkScenes, each_character_has_a_skeleton_and_moves_at_its_own_time) {
  WalkOptions wanted = options(300);
  wanted.characters = 60;
  const Scene scene = field_walk(wanted);
  ASSERT_EQ(scene.skins.size(), 60u);
  std::set<NodeId> joints;
  std::size_t count = 0;
  for (const Skin& skin : scene.skins) {
    joints.insert(skin.joints.begin(), skin.joints.end());
    count += skin.joints.size();
  }
  EXPECT_EQ(joints.size(), count) << "skins share joints";
  std::map<NodeId, const AnimationChannel*> turns;  // of joints
  for (const AnimationChannel& channel : walk_of(scene).channels) {
    if (channel.path == AnimatedPath::rotation && joints.contains(channel.node)) turns[channel.node] = &channel;
  }
  std::set<std::vector<std::vector<float>>> motions;
  for (const Skin& skin : scene.skins) {
    std::vector<std::vector<float>> motion;
    std::size_t moving = 0;
    for (const NodeId joint : skin.joints) {
      if (!turns.contains(joint)) continue;
      const auto values = turns.at(joint)->values.view();
      motion.emplace_back(values.begin(), values.end());
      moving += values.size() > 4;
    }
    EXPECT_GE(moving, 5u);
    motions.insert(motion);
  }
  EXPECT_GE(motions.size(), 25u) << "of 12 clips at four times each";
}

TEST(WalkScenes, the_field_camera_stays_over_the_ground_and_meets_nobody) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    WalkOptions wanted = options(3000, seed);
    wanted.characters = 100;
    const Scene scene = field_walk(wanted);
    EXPECT_EQ(entered(scene, 0), std::set<std::string>()) << seed;
    const std::vector<glm::vec3> places = camera_places(scene);
    const std::vector<glm::mat4> worlds = world_transforms(scene);
    float nearest = 1e30f, lowest = 1e30f;
    for (const Skin& skin : scene.skins) {
      const glm::vec3 hip(worlds[skin.joints.front()][3]);
      for (const glm::vec3& place : places) {
        nearest = std::min(nearest, glm::length(glm::vec2(place.x - hip.x, place.z - hip.z)));
      }
    }
    EXPECT_GT(nearest, 1.2f);
    for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) {
      if (!scene.meshes[mesh].name.starts_with("ground")) continue;
      for (const VertexStream& stream : scene.draws[scene.meshes[mesh].draws[0]].full().vertices->base) {
        if (stream.semantic != "POSITION") continue;
        for (const glm::vec3& ground : decode_vec3(stream)) {
          for (std::size_t i = 0; i < places.size(); i += 16) {
            if (glm::length(glm::vec2(places[i].x - ground.x, places[i].z - ground.z)) < .5f) {
              lowest = std::min(lowest, places[i].y - ground.y);
            }
          }
        }
      }
    }
    EXPECT_GT(lowest, 1.0f);
    EXPECT_LT(lowest, 1.7f);
  }
}

TEST(WalkScenes, the_building_camera_meets_no_wall_and_no_furniture) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const Scene scene = building_walk(options(700, seed));
    EXPECT_EQ(entered(scene, .15f), std::set<std::string>()) << seed;
  }
}

TEST(WalkScenes, the_building_is_furnished_densely) {
  const Scene scene = building_walk(options(0));
  const Counts counts = counts_of(scene);
  EXPECT_GE(counts.placed, 4000u);
  std::uint64_t furniture = 0, dense = 0;
  for (const Mesh& mesh : scene.meshes) {
    std::uint64_t triangles = 0;
    for (const DrawId draw : mesh.draws) triangles += scene.draws[draw].full().stream().triangle_count();
    if (triangles == 12) continue;  // walls, floors and ceilings
    ++furniture;
    dense += triangles >= 2000 && triangles <= 50'000;
  }
  EXPECT_EQ(dense, furniture);
  EXPECT_GE(furniture, 30u);
}

TEST(WalkScenes, the_walk_goes_through_doors_to_other_rooms) {
  for (const std::uint64_t side : {2, 3, 9}) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const BuildingPlan plan(side, seed);
      const auto& walk = plan.walk();
      ASSERT_GE(walk.size(), std::min<std::uint64_t>(side + 1, 7));
      for (std::size_t k = 1; k < walk.size(); ++k) {
        const auto [i, j] = walk[k - 1];
        const auto [u, v] = walk[k];
        ASSERT_LT(u, side);
        ASSERT_LT(v, side);
        const bool is_across = i != u;
        ASSERT_EQ((i > u ? i - u : u - i) + (j > v ? j - v : v - j), 1u);
        EXPECT_TRUE(is_across ? plan.has_door_left(std::max(i, u), j) : plan.has_door_front(i, std::max(j, v)));
      }
      for (std::uint64_t k = 0; k < side; ++k) {
        EXPECT_FALSE(plan.has_door_left(0, k) || plan.has_door_left(side, k));
        EXPECT_FALSE(plan.has_door_front(k, 0) || plan.has_door_front(k, side));
      }
    }
  }
}

TEST(WalkScenes, gpu_instancing_places_the_same_and_leaves_the_camera) {
  for (const auto& [name, make] : all_scenes) {
    WalkOptions wanted = options(700);
    const Scene plain = make(wanted);
    wanted.gpu_instancing = true;
    Diagnostics diagnostics;
    const Scene instanced = read_again(make(wanted), diagnostics);
    EXPECT_EQ(counts_of(instanced).placed, counts_of(plain).placed) << name;
    EXPECT_LT(instanced.nodes.size(), plain.nodes.size()) << name;
    EXPECT_EQ(camera_places(instanced), camera_places(plain)) << name;
    EXPECT_EQ(instanced.skins.size(), plain.skins.size()) << name;
  }
}

}  // namespace
}  // namespace foredraw::bench::walk_scenes_test
