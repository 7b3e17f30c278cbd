// Directions and rotations as few small numbers: the nearest is found, and what was found is found again.
#include <foredraw/scene/coded_values.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace foredraw::coded_values_test {
namespace {

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double dot = a.x * b.x + a.y * b.y + a.z * b.z;
  const double lengths = std::sqrt((a.x * a.x + a.y * a.y + a.z * a.z) * (b.x * b.x + b.y * b.y + b.z * b.z));
  return std::acos(std::clamp(dot / lengths, -1.0, 1.0)) * 180 / 3.14159265358979;
}

glm::dvec3 some_direction(int seed) {
  const double z = std::fmod(seed * .618033988, 2) - 1;
  const double angle = seed * 2.39996323;
  return glm::dvec3(std::cos(angle) * std::sqrt(1 - z * z), std::sin(angle) * std::sqrt(1 - z * z), z) * 3.7;
}

template <class T>
double worst_of(int bits) {
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto near = direction_of<T>(nearest_point<T>(some_direction(i), bits));
    worst = std::max(worst, degrees_between(some_direction(i), glm::dvec3(near[0], near[1], near[2])));
  }
  return worst;
}

TEST(CodedValues, directions_are_as_near_as_their_bits_allow) {
  EXPECT_LT(worst_of<std::int8_t>(8), .85);
  EXPECT_LT(worst_of<std::int8_t>(6), 2.8);
  EXPECT_LT(worst_of<std::int16_t>(8), .65);
  EXPECT_LT(worst_of<std::int16_t>(12), .04);
  EXPECT_LT(worst_of<std::int16_t>(16), .0035);
}

TEST(CodedValues, no_other_point_is_nearer) {
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 wanted = some_direction(i);
    const auto near = direction_of<std::int8_t>(nearest_point<std::int8_t>(wanted, 5));
    const double found = degrees_between(wanted, glm::dvec3(near[0], near[1], near[2]));
    for (int x = -15; x <= 15; ++x) {
      for (int y = -15; y <= 15; ++y) {
        const auto other = direction_of<std::int8_t>({x, y, 15});
        EXPECT_LE(found, degrees_between(wanted, glm::dvec3(other[0], other[1], other[2])) + 1e-6) << i;
      }
    }
  }
}

TEST(CodedValues, a_direction_that_is_none_points_up) {
  for (const double odd : {0.0, std::nan(""), HUGE_VAL}) {
    const auto near = direction_of<std::int8_t>(nearest_point<std::int8_t>(glm::dvec3(odd), 8));
    EXPECT_EQ(near, (std::array<std::int8_t, 3>{0, 0, 127})) << odd;
  }
}

RC_GTEST_PROP(CodedValues, a_point_is_found_again, (int x, int y)) {
  for (const int bits : {2, 5, 8}) {
    const std::int32_t one = (1 << (bits - 1)) - 1;
    const auto direction = direction_of<std::int8_t>({x % (one + 1), y % (one + 1), one});
    const auto point = point_of(direction, bits);
    RC_ASSERT(point.has_value());
    RC_ASSERT(direction_of<std::int8_t>(*point) == direction);
  }
  for (const int bits : {9, 12, 16}) {
    const std::int32_t one = (1 << (bits - 1)) - 1;
    const auto direction = direction_of<std::int16_t>({(x * 7919) % (one + 1), (y * 104729) % (one + 1), one});
    const auto point = point_of(direction, bits);
    RC_ASSERT(point.has_value());
    RC_ASSERT(direction_of<std::int16_t>(*point) == direction);
  }
}

RC_GTEST_PROP(CodedValues, a_rotation_is_found_again, (std::array<int, 4> parts)) {
  for (const int bits : {4, 8, 12, 16}) {
    const std::array<double, 4> wanted{parts[0] % 1000 + .1, parts[1] % 1000 / 1.0, parts[2] % 1000 / 1.0,
                                       parts[3] % 1000 / 1.0};
    const auto rotation = rotation_of(nearest_rotation(wanted, bits));
    const auto coded = coded_rotation(rotation, bits);
    RC_ASSERT(coded.has_value());
    RC_ASSERT(rotation_of(*coded) == rotation);
    double dot = 0, length = 0, own = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      dot += wanted[i] * rotation[i];
      length += wanted[i] * wanted[i];
      own += double(rotation[i]) * rotation[i];
    }
    const double half_angle = std::acos(std::min(std::abs(dot) / std::sqrt(length * own), 1.0));
    RC_ASSERT(half_angle < 1.5 / ((1 << (bits - 1)) - 1) + 1e-4);
  }
}

TEST(CodedValues, a_float_is_a_multiple_of_a_power_of_two) {
  EXPECT_EQ(lattice_of(0), std::nullopt);
  EXPECT_EQ(lattice_of(HUGE_VALF), std::nullopt);
  EXPECT_EQ(lattice_of(1), 0);
  EXPECT_EQ(lattice_of(-.75f), -2);
  EXPECT_EQ(lattice_of(96), 5);
  EXPECT_EQ(lattice_of(std::ldexp(1.f, -149)), -149);
  EXPECT_EQ(lattice_of(std::ldexp(3.f, -140)), -140);
}

}  // namespace
}  // namespace foredraw::coded_values_test
