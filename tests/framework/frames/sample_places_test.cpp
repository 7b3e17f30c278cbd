#include <foredraw/frames/sample_places.h>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace foredraw::sample_places_test {
namespace {

/// In each row and each column of as many cells there is one.
void expect_even(const SamplePlaces& places) {
  std::set<int> columns, rows;
  const auto n = static_cast<double>(places.size());
  for (const glm::dvec2& place : places) {
    EXPECT_LT(std::abs(place.x), 0.5);
    EXPECT_LT(std::abs(place.y), 0.5);
    columns.insert(static_cast<int>((place.x + 0.5) * n));
    rows.insert(static_cast<int>((place.y + 0.5) * n));
  }
  EXPECT_EQ(columns.size(), places.size());
  EXPECT_EQ(rows.size(), places.size());
}

TEST(SamplePlaces, AreEven) {
  for (const int samples : {1, 2, 4, 8}) expect_even(standard_places(samples));
  for (const int samples : {1, 2, 64, 256}) {
    expect_even(hammersley_places(samples));
    expect_even(hammersley_places(samples, true));
  }
}

TEST(SamplePlaces, TwoTruthsShareFew) {
  const SamplePlaces one = hammersley_places(256), other = hammersley_places(256, true);
  int common = 0;
  for (const glm::dvec2& a : one) {
    for (const glm::dvec2& b : other) common += a == b ? 1 : 0;
  }
  EXPECT_LT(common, 16);
}

TEST(SamplePlaces, OtherNumbersAreRefused) {
  EXPECT_THROW(standard_places(3), std::invalid_argument);
  EXPECT_THROW(hammersley_places(100), std::invalid_argument);
  EXPECT_THROW(hammersley_places(0), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::sample_places_test
