#include <foredraw/viewing/slerp.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::slerp_test {
namespace {

glm::dquat any_rotation(Random& random) {
  const auto part = [&] { return 2 * static_cast<double>(random.unit()) - 1; };
  const double w = part(), x = part(), y = part(), z = part();
  return glm::normalize(glm::dquat(w, x, y, z));
}

/// As glTF 2.0, appendix C.4, writes it.
glm::dquat by_arcs(const glm::dquat& from, const glm::dquat& to, double t) {
  const double cosine = glm::dot(from, to);
  const double arc = std::acos(std::min(std::abs(cosine), 1.0));
  const double sign = cosine < 0 ? -1 : 1;
  return (from * std::sin(arc * (1 - t)) + to * (sign * std::sin(arc * t))) / std::sin(arc);
}

double difference(const glm::dquat& a, const glm::dquat& b) {
  return std::max({std::abs(a.w - b.w), std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST(Slerp, is_what_arcs_and_sines_give) {
  Random random(1);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dquat from = any_rotation(random);
    const glm::dquat to = any_rotation(random);
    const double t = static_cast<double>(random.unit());
    largest = std::max(largest, difference(slerp(from, to, t), by_arcs(from, to, t)));
  }
  EXPECT_LT(largest, 2e-15);
}

TEST(Slerp, small_turns_are_as_exact) {
  for (const double angle : {1e-3, 1e-6, 1e-9}) {
    const glm::dquat to(std::cos(angle), std::sin(angle), 0, 0);
    for (const double t : {0.1, 0.5, 0.9}) {
      EXPECT_NEAR(slerp({1, 0, 0, 0}, to, t).x / std::sin(angle * t), 1, 1e-6) << angle;
      EXPECT_NEAR(slerp({1, 0, 0, 0}, to, t).x, std::sin(angle * t), 1e-15);
    }
  }
}

TEST(Slerp, ends_are_the_ends_and_the_way_is_the_shorter_one) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const glm::dquat from = any_rotation(random);
    const glm::dquat to = any_rotation(random);
    EXPECT_LT(difference(slerp(from, to, 0), from), 1e-15);
    const glm::dquat end = slerp(from, to, 1);
    EXPECT_LT(std::min(difference(end, to), difference(end, -to)), 1e-15);
    EXPECT_LT(difference(slerp(from, to, 0.3), slerp(from, -to, 0.3)), 1e-15);
    EXPECT_GE(glm::dot(slerp(from, to, 0.5), from), std::sqrt(0.5) - 1e-12);
  }
}

TEST(Slerp, opposite_and_equal_ends_stay_where_they_are) {
  const glm::dquat q = glm::normalize(glm::dquat(0.3, -0.4, 0.5, 0.6));
  EXPECT_LT(difference(slerp(q, q, 0.37), q), 1e-15);
  EXPECT_LT(difference(slerp(q, -q, 0.37), q), 1e-15);
  // Half a turn away: a right angle between the quaternions.
  EXPECT_NEAR(slerp({1, 0, 0, 0}, {0, 1, 0, 0}, 0.5).x, std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace foredraw::slerp_test
