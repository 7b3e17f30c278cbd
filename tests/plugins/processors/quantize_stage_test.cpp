// The stage: what hangs together keeps together, and what others may make of it.
#include "support/meshes.h"
#include "support/staged.h"

#include <foredraw/scene/coded_values.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <set>

namespace foredraw::quantize_stage_test {
namespace {

using ::testing::HasSubstr;
using testing::TestMesh;

std::set<std::array<float, 3>> positions(const Scene& scene, DrawId draw, const glm::vec3& moved = glm::vec3(0)) {
  std::set<std::array<float, 3>> all;
  for (const glm::vec3& p : decode_vec3(*scene.draws[draw].full().vertices->find("POSITION"))) {
    all.insert({p.x + moved.x, p.y + moved.y, p.z + moved.z});
  }
  return all;
}

/// A grid from 0 to 1 in x and y, of which the right column is at x = 1, and a larger and finer one on its right side.
Scene two_sheets(float apart) {
  TestMesh left = testing::grid(10, 10), right = testing::grid(30, 10);
  for (glm::vec3& p : left.positions) p = {p.x * .1f, p.y * .1f * .977f, 0};
  for (glm::vec3& p : right.positions) p = {p.x * .1f, p.y * .1f * .977f, 0};
  Scene scene = testing::scene_of({testing::draw_of(left, "left"), testing::draw_of(right, "right")});
  scene.nodes[1].transform.translation = {apart, 0, 0};
  return scene;
}

TEST(QuantizeStage, SheetsThatTouchAreRoundedAlike) {
  const Scene scene = two_sheets(1);
  const Result result = testing::run("quantize(position-error=.01, integers=false)", scene);
  ASSERT_FALSE(result.failed);
  const auto left = positions(result.scene, 0), right = positions(result.scene, 1, {1, 0, 0});
  std::size_t met = 0;
  for (const auto& p : left) met += right.contains(p);
  EXPECT_EQ(met, 11u) << "the border of eleven vertices";
}

TEST(QuantizeStage, SheetsApartHaveLatticesOfTheirOwn) {
  const Result result = testing::run("quantize(position-error=.01, integers=false)", two_sheets(7));
  int least[2] = {99, 99};
  for (const DrawId draw : {0u, 1u}) {
    for (const auto& p : positions(result.scene, draw)) {
      for (const float one : p) least[draw] = std::min(least[draw], lattice_of(one).value_or(99));
    }
  }
  EXPECT_LT(least[0], least[1]);
}

TEST(QuantizeStage, BitsStandForTheErrorOfTheirGrid) {
  const Scene scene = two_sheets(7);
  for (const int bits : {6, 10, 14}) {
    const Result result =
        testing::run("quantize(position-error=.1, position-bits=" + std::to_string(bits) + ")", scene);
    const auto was = decode_vec3(*scene.draws[1].full().vertices->find("POSITION"));
    auto is = decode_vec3(*result.scene.draws[1].full().vertices->find("POSITION"));
    for (glm::vec3& p : is) p = position_in({}, result.scene.draws[1].space, p);
    double farthest = 0;
    for (std::size_t v = 0; v < was.size(); ++v) {
      farthest = std::max(farthest, double{glm::distance(glm::dvec3(was[v]), glm::dvec3(is[v]))});
    }
    const double middle = std::sqrt(3.0) / 2 * 3 / ((1 << bits) - 1);
    EXPECT_LE(farthest, middle) << bits;
    EXPECT_GT(farthest, middle / 4) << bits;
  }
}

TEST(QuantizeStage, WhatWasNearBecomesEqualAndIsWelded) {
  TestMesh mesh = testing::soup(2, 3);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1e-6f, 0}, {1, 1, 0}, {0, 1 + 1e-6f, 0}};
  mesh.indices = {0, 1, 2, 3, 4, 5};
  const Result result = testing::run("quantize, weld", testing::scene_of(mesh));
  EXPECT_EQ(result.scene.draws[0].full().vertices->count, 4u);
}

TEST(QuantizeStage, LevelsTellTheErrorOfBoth) {
  const Scene scene = testing::scene_of(testing::sphere(32, 32));
  const Result plain = testing::run("quadric-collapse, levels", scene);
  const Result rounded = testing::run("quadric-collapse, levels, quantize(position-error=.01)", scene);
  ASSERT_GT(plain.scene.draws[0].levels.size(), 1u);
  for (std::size_t l = 1; l < plain.scene.draws[0].levels.size(); ++l) {
    EXPECT_GT(rounded.scene.draws[0].levels[l].error, plain.scene.draws[0].levels[l].error);
  }
}

TEST(QuantizeStage, ASecondTimeNothingIsToDo) {
  const Result once = testing::run("quantize", testing::scene_of(testing::sphere(16, 16)));
  const Result twice = testing::run("quantize", once.scene);
  EXPECT_THAT(to_text(twice.report), HasSubstr("as coarse as the errors allow"));
}

}  // namespace
}  // namespace foredraw::quantize_stage_test
