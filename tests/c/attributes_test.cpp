// What vertices of a level carry, by the functions for C: what the program writes, and what is wrong refused.

#include <foredraw/analysis/diagonal.h>
#include <foredraw/c/functions.h>
#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/io/scene_file.h>

#include "bumpy_sheet.h"
#include "support/meshes.h"
#include "support/program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw::attributes_test {
namespace {

using testing::BumpySheet;

constexpr double any_error = std::numeric_limits<double>::infinity();

/// The caller's arrays.
struct Sequence {
  explicit Sequence(std::size_t vertices, std::uint32_t solves = 1)
      : collapses(vertices), pairs(vertices), first_pair(vertices + 1), places(3 * vertices) {
    arrays = {collapses.data(), pairs.data(), first_pair.data(), places.data(), 0, solves};
  }
  std::vector<foredraw_collapse> collapses;
  std::vector<foredraw_vertex_pair> pairs;
  std::vector<std::uint32_t> first_pair;
  std::vector<float> places;
  foredraw_collapses arrays;
};

#ifdef FOREDRAW_PROGRAM
/// A draw of floats.
struct Model {
  explicit Model(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    const auto file = read_scene(path.string(), diagnostics);
    if (!file) return;
    Analyses analyses;
    const std::vector<DrawId> one{0};
    mesh = *joined_mesh(file->scene, one, analyses);
    for (const auto& [name, to, width] : {std::tuple("NORMAL", &normals, 3), std::tuple("TEXCOORD_0", &uvs, 2)}) {
      const VertexStream& stream = *mesh.streams[0]->find(name);
      for (std::size_t v = 0; v < stream.count(); ++v) {
        for (int c = 0; c < width; ++c) to->push_back(decode_component(stream, v, c));
      }
    }
  }

  /// How long a unit of the texture is on the surface, in the mean.
  double texture_scale() const {
    double surface = 0, texture = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
      const glm::dvec3 p(mesh.positions[a]), q = glm::dvec3(mesh.positions[b]) - p,
                                             r = glm::dvec3(mesh.positions[c]) - p;
      const double x = q.y * r.z - q.z * r.y, y = q.z * r.x - q.x * r.z, z = q.x * r.y - q.y * r.x;
      surface += std::sqrt(x * x + y * y + z * z);
      const auto uv = [&](std::uint32_t v, int k) { return double{uvs[2 * v + k]} - uvs[2 * a + k]; };
      texture += std::abs(uv(b, 0) * uv(c, 1) - uv(c, 0) * uv(b, 1));
    }
    return std::sqrt(surface / texture);
  }

  JoinedMesh mesh;
  std::vector<float> normals, uvs;
};

class SolvedAttributes : public testing::InFolder {};

/// Corner for corner, to the bit. Weights are the plugin's, as lengths.
TEST_F(SolvedAttributes, AreWhatTheProgramWrites) {
  const std::filesystem::path head = testing::project_file("benchmarks/corpus/static/head.glb");
  const testing::Ended ended =
      testing::run_program(folder_, "optimize '" + head.string() +
                                        "' -o few.glb -p 'quadric-collapse, simplify(ratio=0.25)' --with vertex-cache");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Model before(head), after(folder_ / "few.glb");
  const auto vertices = static_cast<std::uint32_t>(before.mesh.positions.size());
  const foredraw_triangles triangles{before.mesh.indices.data(), before.mesh.indices.size(), 4, vertices};
  const foredraw_positions positions{before.mesh.positions.data(), 0};
  const AttributeWeights weights;
  const foredraw_weighted_attribute attributes[] = {
      {before.normals.data(), 0, 3 + FOREDRAW_DIRECTION, weights.normals * diagonal_of(before.mesh.positions)},
      {before.uvs.data(), 0, 2, weights.texcoords * before.texture_scale()}};

  Sequence sequence(vertices);
  const auto all = static_cast<std::uint32_t>(before.mesh.indices.size() / 3);
  ASSERT_EQ(foredraw_quadric_collapse(&sequence.arrays, &triangles, &positions, attributes, 2, all / 100),
            FOREDRAW_DONE);
  EXPECT_EQ(sequence.arrays.solves, 1u);
  std::vector<std::uint32_t> indices(before.mesh.indices.size());
  std::vector<float> places(3 * vertices), carried(5 * vertices);
  foredraw_simplified level;
  ASSERT_EQ(foredraw_simplify(indices.data(), places.data(), &level, &triangles, &positions, &sequence.arrays,
                              (all + 3) / 4, any_error),
            FOREDRAW_DONE);
  ASSERT_EQ(foredraw_level_attributes(carried.data(), &triangles, &positions, &sequence.arrays, level.collapses,
                                      attributes, 2),
            FOREDRAW_DONE);

  ASSERT_EQ(level.index_count, after.mesh.indices.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < level.index_count; ++i) {
    const std::uint32_t ours = indices[i], theirs = after.mesh.indices[i];
    ASSERT_EQ(std::memcmp(&places[3 * ours], &after.mesh.positions[theirs], 12), 0) << "corner " << i;
    ASSERT_EQ(std::memcmp(&carried[5 * ours], &after.normals[3 * theirs], 12), 0) << "corner " << i;
    ASSERT_EQ(std::memcmp(&carried[5 * ours + 3], &after.uvs[2 * theirs], 8), 0) << "corner " << i;
    moved += std::memcmp(&carried[5 * ours + 3], &before.uvs[2 * ours], 8) != 0;
  }
  EXPECT_GT(moved, level.index_count / 2);
}
#endif

/// With a height that rises evenly and a weight of a joint.
class LevelAttributes : public ::testing::Test {
 protected:
  LevelAttributes() {
    for (const glm::vec3& p : sheet_.places()) {
      ramp_.push_back(p.x + 2 * p.z);
      weights_.push_back(p.x < 10 ? 1.0f : 0.0f);
      const float length = std::sqrt(p.x * p.x + 1);
      tangents_.insert(tangents_.end(), {p.x / length, 1 / length, 0, p.z < 10 ? 1.0f : -1.0f});
    }
  }

  int find(std::span<const foredraw_weighted_attribute> attributes) {
    return foredraw_quadric_collapse(&sequence_.arrays, &triangles_, &positions_, attributes.data(),
                                     static_cast<std::uint32_t>(attributes.size()), 0);
  }
  int tell(float* values, std::uint32_t collapses, std::span<const foredraw_weighted_attribute> attributes) const {
    return foredraw_level_attributes(values, &triangles_, &positions_, &sequence_.arrays, collapses, attributes.data(),
                                     static_cast<std::uint32_t>(attributes.size()));
  }

  const BumpySheet sheet_{20};
  const foredraw_triangles triangles_ = sheet_.triangles();
  const foredraw_positions positions_ = sheet_.positions();
  const std::size_t vertices_ = sheet_.vertices.size();
  std::vector<float> ramp_, weights_, tangents_;
  Sequence sequence_{vertices_};
};

TEST_F(LevelAttributes, AreOfUnitLengthOrBetweenWhatThereWas) {
  const foredraw_weighted_attribute all[] = {{weights_.data(), 0, 1 + FOREDRAW_BLENDED, 0.5},
                                             {tangents_.data(), 0, 4 + FOREDRAW_DIRECTION, 0.1},
                                             {ramp_.data(), 0, 1, 0.2}};
  ASSERT_EQ(find(all), FOREDRAW_DONE);
  std::vector<float> values(6 * vertices_), blended(6 * vertices_);
  for (const std::uint32_t collapses : {0u, 100u, sequence_.arrays.count}) {
    ASSERT_EQ(tell(values.data(), collapses, all), FOREDRAW_DONE);
    for (std::size_t v = 0; v < vertices_; ++v) {
      const float* one = &values[6 * v];
      EXPECT_TRUE(one[0] >= 0 && one[0] <= 1);
      EXPECT_NEAR(std::hypot(one[1], one[2], one[3]), 1, 1e-5);
      EXPECT_TRUE(one[4] == 1 || one[4] == -1);
      EXPECT_TRUE(one[5] >= 0 && one[5] <= 60);
      if (collapses > 0) continue;
      EXPECT_EQ(one[0], weights_[v]);
      EXPECT_EQ(std::memcmp(one + 1, &tangents_[4 * v], 16), 0);
      EXPECT_EQ(one[5], ramp_[v]);
    }
  }
  // Weights are blended whoever asks; the others are solved for.
  sequence_.arrays.solves = 0;
  ASSERT_EQ(tell(values.data(), 200, all), FOREDRAW_DONE);
  sequence_.arrays.solves = 1;
  ASSERT_EQ(tell(blended.data(), 200, all), FOREDRAW_DONE);
  std::size_t others = 0;
  for (std::size_t v = 0; v < vertices_; ++v) {
    EXPECT_EQ(values[6 * v], blended[6 * v]);
    others += values[6 * v + 5] != blended[6 * v + 5];
  }
  EXPECT_GT(others, 20u);
}

/// The order in which attributes come does not matter to what is blended.
TEST_F(LevelAttributes, CountAlikeInAnySequence) {
  const foredraw_weighted_attribute ramp{ramp_.data(), 0, 1, 0.2},
      weight{weights_.data(), 0, 1 + FOREDRAW_BLENDED, 0.5};
  const foredraw_weighted_attribute one[] = {ramp, weight}, other[] = {weight, ramp};
  ASSERT_EQ(find(one), FOREDRAW_DONE);
  const std::vector<foredraw_collapse> first = sequence_.collapses;
  ASSERT_EQ(find(other), FOREDRAW_DONE);
  EXPECT_EQ(std::memcmp(first.data(), sequence_.collapses.data(), first.size() * sizeof first[0]), 0);
}

TEST_F(LevelAttributes, SaysWhatIsWrong) {
  const foredraw_weighted_attribute ramp{ramp_.data(), 0, 1, 0.2};
  ASSERT_EQ(find({&ramp, 1}), FOREDRAW_DONE);
  std::vector<float> values(vertices_);
  const std::uint32_t count = sequence_.arrays.count;
  for (const std::uint32_t components : {0u, 17u, 0x400u, 2u + FOREDRAW_DIRECTION, 5u + FOREDRAW_DIRECTION,
                                         0u + FOREDRAW_BLENDED, 3u + FOREDRAW_DIRECTION + FOREDRAW_BLENDED}) {
    const foredraw_weighted_attribute wrong{ramp_.data(), 0, components, 0.2};
    EXPECT_EQ(tell(values.data(), 10, {&wrong, 1}), FOREDRAW_OPTION_RANGE) << components;
    EXPECT_EQ(find({&wrong, 1}), FOREDRAW_OPTION_RANGE) << components;
  }
  const foredraw_weighted_attribute none{nullptr, 0, 1, 0.2};
  EXPECT_EQ(tell(values.data(), 10, {&none, 1}), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(tell(nullptr, 10, {&ramp, 1}), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(tell(values.data(), count + 1, {&ramp, 1}), FOREDRAW_NO_ORDER);
  EXPECT_EQ(foredraw_level_attributes(values.data(), &triangles_, &positions_, nullptr, 0, &ramp, 1),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_level_attributes(values.data(), &triangles_, nullptr, &sequence_.arrays, 0, &ramp, 1),
            FOREDRAW_NULL_POINTER);
  EXPECT_EQ(tell(values.data(), count, {&ramp, 1}), FOREDRAW_DONE);
  sequence_.arrays.solves = 2;
  EXPECT_EQ(tell(values.data(), 10, {&ramp, 1}), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(find({&ramp, 1}), FOREDRAW_OPTION_RANGE);
  sequence_.arrays.solves = 1;
  sequence_.collapses[1].removed = sequence_.collapses[0].removed;
  EXPECT_EQ(tell(values.data(), 10, {&ramp, 1}), FOREDRAW_NO_ORDER);
}

/// Points that stay carry what one of both had.
TEST_F(LevelAttributes, AreThoseOfOneOfBothWherePointsStay) {
  sequence_.arrays.places = nullptr;
  const foredraw_weighted_attribute ramp{ramp_.data(), 0, 1, 0.2};
  ASSERT_EQ(find({&ramp, 1}), FOREDRAW_DONE);
  EXPECT_EQ(sequence_.arrays.solves, 0u);
  std::vector<float> values(vertices_);
  ASSERT_EQ(tell(values.data(), sequence_.arrays.count, {&ramp, 1}), FOREDRAW_DONE);
  EXPECT_EQ(values, ramp_);
}

}  // namespace
}  // namespace foredraw::attributes_test
