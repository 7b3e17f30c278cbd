#include <foredraw/viewing/view_set.h>

#include <foredraw/base/content_hash.h>
#include <foredraw/viewing/view_directions.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>

namespace foredraw::view_set_test {
namespace {

ViewSet view_set(std::string views, std::optional<int> count = {}) {
  ViewSet set;
  set.views = std::move(views);
  set.count = count;
  return set;
}

double least_angle(const Views& views) {
  double most_cosine = -1;
  for (std::size_t i = 0; i < views.views.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      most_cosine = std::max(most_cosine, glm::dot(views.views[i].direction, views.views[j].direction));
    }
  }
  return std::acos(most_cosine);
}

TEST(ViewSphere, counts) {
  for (const int count : {12, 42, 162, 642, 2562}) {
    EXPECT_EQ(make_views(view_set("icosphere", count)).views.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(make_views(view_set(std::to_string(count))).views.size(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(make_views(view_set("icosphere")).views.size(), 162u);
  EXPECT_EQ(make_views(view_set("fibonacci")).views.size(), 100u);
  EXPECT_EQ(make_views(view_set("random", 7)).views.size(), 7u);
  EXPECT_EQ(make_views(view_set("axes")).views.size(), 6u);
}

TEST(ViewSphere, directions_have_unit_length_and_balance) {
  for (const ViewSet& set : {view_set("icosphere", 642), view_set("fibonacci", 500), view_set("axes")}) {
    glm::dvec3 sum(0);
    for (const View& view : make_views(set).views) {
      EXPECT_NEAR(glm::length(view.direction), 1, 1e-15);
      EXPECT_EQ(view.weight, 1);
      sum += view.direction;
    }
    EXPECT_LT(glm::length(sum), 0.1) << set.views;
  }
}

TEST(ViewSphere, directions_are_spread) {
  // The angle between neighbours of an ideal spread of n points is about sqrt(4 pi / n * 2 / sqrt(3)).
  const auto ideal = [](double n) { return std::sqrt(4 * 3.141592653589793 / n * 1.1547); };
  EXPECT_GT(least_angle(make_views(view_set("icosphere", 642))), 0.7 * ideal(642));
  EXPECT_GT(least_angle(make_views(view_set("fibonacci", 1000))), 0.7 * ideal(1000));
  EXPECT_LT(least_angle(make_views(view_set("random", 1000))), 0.3 * ideal(1000));
}

TEST(ViewSphere, the_spiral_turns_by_the_golden_angle) {
  const auto views = make_views(view_set("fibonacci", 1000)).views;
  const double golden_angle = 3.141592653589793 * (3 - std::sqrt(5.0));
  for (const std::size_t i : {1u, 500u, 999u}) {
    const double y = 1 - (2.0 * static_cast<double>(i) + 1) / 1000;
    const double r = std::sqrt(1 - y * y);
    const double angle = golden_angle * static_cast<double>(i);
    EXPECT_NEAR(glm::distance(views[i].direction, {r * std::cos(angle), y, r * std::sin(angle)}), 0, 1e-12);
  }
}

TEST(ViewSphere, coarse_icospheres_begin_finer_ones) {
  const auto coarse = make_views(view_set("42")).views;
  const auto fine = make_views(view_set("642")).views;
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(coarse[i].direction, fine[i].direction);
}

TEST(ViewSphere, the_seed_decides_random_views) {
  ViewSet set = view_set("random", 20);
  set.seed = 7;
  const auto first = make_views(set).views;
  EXPECT_EQ(make_views(set).views[19].direction, first[19].direction);
  set.seed = 8;
  EXPECT_NE(make_views(set).views[19].direction, first[19].direction);
}

TEST(ViewSphere, the_same_bits_everywhere) {
  const auto stamp = [](const ViewSet& set) {
    std::vector<glm::dvec3> directions;
    for (const View& view : make_views(set).views) directions.push_back(view.direction);
    return to_text(content_hash(std::span<const glm::dvec3>(directions)));
  };
  EXPECT_EQ(stamp(view_set("icosphere", 2562)), "0a5524589c8e6e0c11ee3a7eb060601f");
  EXPECT_EQ(stamp(view_set("fibonacci", 1000)), "dfd7fbe0099258f51da5460fd5a3c2c7");
  EXPECT_EQ(stamp(view_set("random", 1000)), "2cd049ae03ca4ce5f271740f915ec7d7");
  ViewSet cone = view_set("cone", 1000);
  cone.angle = 35;
  cone.rotation = 1;
  EXPECT_EQ(stamp(cone), "7608077c4fe9a1a403f8518718bc9f6d");
}

TEST(ViewSphere, a_cone_holds_views_within_its_angle_evenly) {
  ViewSet set = view_set("cone", 400);
  set.axis = "1 -2 2";
  set.angle = 40;
  const glm::dvec3 axis = glm::dvec3(1, -2, 2) / 3.0;
  const double least = std::cos(40 * 3.141592653589793 / 180);
  double sum = 0;
  double nearest_to_edge = 1;
  for (const View& view : make_views(set).views) {
    const double cosine = glm::dot(view.direction, axis);
    EXPECT_GT(cosine, least);
    nearest_to_edge = std::min(nearest_to_edge, cosine);
    sum += cosine;
  }
  EXPECT_NEAR(nearest_to_edge, least, 0.001);
  EXPECT_NEAR(sum / 400, (1 + least) / 2, 1e-6);  // even by area: cosines are spread evenly
}

TEST(ViewSphere, the_usual_cone_looks_down) {
  for (const View& view : make_views(view_set("cone")).views) EXPECT_GT(view.direction.y, 0);
}

TEST(ViewSphere, a_cone_of_180_degrees_is_the_whole_sphere) {
  ViewSet set = view_set("cone", 50);
  set.angle = 180;
  const auto whole = make_views(view_set("fibonacci", 50)).views;
  const auto cone = make_views(set).views;
  for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(glm::distance(cone[i].direction, whole[i].direction), 0, 1e-15);
}

TEST(ViewSphere, a_rotation_turns_the_whole_set_alike) {
  ViewSet set = view_set("162");
  const auto before = make_views(set).views;
  set.rotation = 5;
  const auto after = make_views(set).views;
  set.rotation = 6;
  EXPECT_NE(make_views(set).views[0].direction, after[0].direction);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_GT(glm::distance(before[i].direction, after[i].direction), 1e-3);
    EXPECT_NEAR(glm::length(after[i].direction), 1, 1e-15);
    const std::size_t j = (i + 7) % before.size();
    EXPECT_NEAR(glm::dot(before[i].direction, before[j].direction), glm::dot(after[i].direction, after[j].direction),
                1e-14);
  }
  // A rotation and no mirroring.
  const auto volume = [](const std::vector<View>& v) {
    return glm::dot(glm::cross(v[0].direction, v[1].direction), v[20].direction);
  };
  EXPECT_NEAR(volume(before), volume(after), 1e-14);
}

TEST(ViewSphere, rotations_are_uniform) {
  glm::dvec3 sum(0);
  double squares = 0;
  const Directions up = {{0, 1, 0}};
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const glm::dvec3 turned = turned_at_random(up, seed)[0];
    sum += turned / 3000.0;
    squares += turned.z * turned.z / 3000;
  }
  EXPECT_LT(glm::length(sum), 0.05);
  EXPECT_NEAR(squares, 1.0 / 3, 0.02);
}

TEST(ViewSphere, camera_and_picture_are_taken_over) {
  ViewSet set = view_set("axes");
  EXPECT_EQ(make_views(set).views[0].distance, 0);
  set.distance = 3;
  set.size = 64;
  EXPECT_EQ(make_views(set).views[0].distance, 3);
  EXPECT_EQ(make_views(set).size, 64);
}

TEST(ViewSphere, mistakes_are_told) {
  EXPECT_EQ(mistake_in(view_set("icosphere")), std::nullopt);
  EXPECT_EQ(mistake_in(view_set("162", 162)), std::nullopt);
  EXPECT_EQ(mistake_in(view_set("icosphere", 100)), "an icosphere has 12, 42, 162, 642 or 2562 views, not 100");
  EXPECT_EQ(mistake_in(view_set("100")), "an icosphere has 12, 42, 162, 642 or 2562 views, not 100");
  EXPECT_EQ(mistake_in(view_set("162", 42)), "views is 162, but count is 42; leave one of them out");
  EXPECT_EQ(mistake_in(view_set("axes", 7)), "there are 6 views along the axes, not 7");
  EXPECT_EQ(mistake_in(view_set("fibonaci")), "there is no view set 'fibonaci'; did you mean 'fibonacci'?");
  EXPECT_EQ(mistake_in(view_set("everywhere")),
            "there is no view set 'everywhere'; expected icosphere, fibonacci, axes, random, cone, a number or a file "
            "(with a dot or a slash in its path)");
  EXPECT_TRUE(mistake_in(view_set("random", 0)));
  ViewSet cone = view_set("cone");
  cone.axis = "0 0 0";
  EXPECT_EQ(mistake_in(cone), "axis is '0 0 0', but must be a direction such as '0 1 0'");
  cone.axis = "0 1";
  EXPECT_TRUE(mistake_in(cone));
  cone.axis = "0 1 0 1";
  EXPECT_TRUE(mistake_in(cone));
  EXPECT_THROW(make_views(cone), std::invalid_argument);
  ViewSet near = view_set("axes");
  near.distance = 1;
  EXPECT_TRUE(mistake_in(near));
}

}  // namespace
}  // namespace foredraw::view_set_test
