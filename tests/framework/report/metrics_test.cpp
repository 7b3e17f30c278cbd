#include <foredraw/report/metrics.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foredraw::metrics_test {
namespace {

TEST(Metrics, RatiosAddUpAsSumOverSum) {
  Metrics metrics;
  metrics.add("cache", "acmr", {.numerator = 30, .denominator = 10});
  metrics.add("cache", "acmr", {.numerator = 10, .denominator = 30});
  const Figure* figure = metrics.find("cache", "acmr");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->numerator, 40);
  EXPECT_EQ(figure->denominator, 40);
  EXPECT_EQ(figure->value(), 1) << "not the mean of 3 and 1/3";
}

TEST(Metrics, CountsAddUp) {
  Metrics metrics;
  metrics.add("cache", "misses", {.numerator = 5});
  metrics.add("cache", "misses", {.numerator = 7});
  EXPECT_EQ(metrics.find("cache", "misses")->value(), 12);
  EXPECT_FALSE(metrics.find("cache", "misses")->denominator);
}

TEST(Metrics, CountsHaveCommasAsInSentences) {
  EXPECT_EQ(to_text(Figure{.numerator = 999}), "999");
  EXPECT_EQ(to_text(Figure{.numerator = 1000}), "1,000");
  EXPECT_EQ(to_text(Figure{.numerator = -123456}), "-123,456");
  EXPECT_EQ(to_text(Figure{.numerator = 6734382, .error = 295218}), "6,734,382 ±295,218");
  EXPECT_EQ(to_text(Figure{.numerator = 12345, .denominator = 10}), "1234.5000") << "a ratio is no count";
}

TEST(Metrics, OfSomeTheWorstStands) {
  Metrics metrics;
  const auto add = [&](double numerator, double denominator) {
    metrics.add("overdraw", "worst-view", {.numerator = numerator, .denominator = denominator, .worst_stands = true});
  };
  add(0, 0);
  add(30, 10);
  add(100, 50);
  EXPECT_EQ(metrics.find("overdraw", "worst-view")->value(), 3);
  metrics.add("a", "kept", {.numerator = 0.9, .lower_is_better = false, .worst_stands = true});
  metrics.add("a", "kept", {.numerator = 0.8, .lower_is_better = false, .worst_stands = true});
  EXPECT_EQ(metrics.find("a", "kept")->value(), 0.8);
}

TEST(Metrics, ErrorsAreAveragedByTheirDenominators) {
  Metrics metrics;
  metrics.add("overdraw", "ratio", {.numerator = 1, .denominator = 1, .error = 0.4});
  metrics.add("overdraw", "ratio", {.numerator = 3, .denominator = 3, .error = 0});
  EXPECT_DOUBLE_EQ(metrics.find("overdraw", "ratio")->error, 0.1);
  metrics.add("overdraw", "ratio", {.numerator = 4, .denominator = 4, .error = 0.3});
  EXPECT_DOUBLE_EQ(metrics.find("overdraw", "ratio")->error, 0.2);
}

TEST(Metrics, ErrorsOfCountsAddUp) {
  Metrics metrics;
  metrics.add("overdraw", "ties", {.numerator = 10, .error = 1});
  metrics.add("overdraw", "ties", {.numerator = 20, .error = 2});
  EXPECT_EQ(metrics.find("overdraw", "ties")->error, 3);
}

TEST(Figure, IsTextWithItsError) {
  EXPECT_EQ(to_text({1, 4, 0.0123, ""}), "0.2500 ±0.0123");
  EXPECT_EQ(to_text({1234.5, std::nullopt, 56.7, ""}), "1,234 ±57");
  EXPECT_EQ(to_text({1234, std::nullopt, 0, ""}), "1,234");
}

TEST(Metrics, NothingOverNothingIsNoNumber) {
  Metrics metrics;
  metrics.add("cache", "acmr", {.numerator = 0, .denominator = 0, .error = 0.5});
  metrics.add("cache", "acmr", {.numerator = 0, .denominator = 0, .error = 0.5});
  EXPECT_TRUE(std::isnan(metrics.find("cache", "acmr")->value()));
  EXPECT_EQ(metrics.find("cache", "acmr")->error, 0.5);
  metrics.add("cache", "acmr", {.numerator = 2, .denominator = 1});
  EXPECT_EQ(metrics.find("cache", "acmr")->value(), 2);
}

TEST(Metrics, SetStandsInThePlaceOfTheSum) {
  Metrics metrics;
  metrics.add("cache", "acmr", {.numerator = 30, .denominator = 10, .error = 1, .unit = "a"});
  metrics.set("cache", "acmr", {.numerator = 4, .denominator = 2, .unit = "b"});
  EXPECT_EQ(metrics.find("cache", "acmr")->value(), 2);
  EXPECT_EQ(metrics.find("cache", "acmr")->error, 0);
  EXPECT_EQ(metrics.find("cache", "acmr")->unit, "b");
}

TEST(Metrics, FindSaysWhereThereIsNone) {
  Metrics metrics;
  EXPECT_TRUE(metrics.empty());
  metrics.add("cache", "acmr", {.numerator = 1});
  EXPECT_FALSE(metrics.empty());
  EXPECT_EQ(metrics.find("cache", "atvr"), nullptr);
  EXPECT_EQ(metrics.find("overdraw", "acmr"), nullptr);
}

class FigureOf : public ::testing::Test {
 protected:
  static Measured measured(std::string metric) { return {std::move(metric), 6, 3.0, 0.25, {}}; }

  Card card_ = [] {
    Card card;
    card.metrics = {{"acmr", "misses per triangle", "", true},
                    {"speed-up", "times", "", false},
                    {"models.amd.acmr", "misses of that model per triangle", "", true}};
    return card;
  }();
};

TEST_F(FigureOf, TakesUnitAndDirectionFromTheCard) {
  const Figure figure = figure_of(measured("speed-up"), card_);
  EXPECT_EQ(figure.unit, "times");
  EXPECT_FALSE(figure.lower_is_better);
  EXPECT_EQ(figure.value(), 2);
  EXPECT_EQ(figure.error, 0.25);
}

TEST_F(FigureOf, NamesBehindTheLastDotLendTheirUnit) {
  EXPECT_EQ(figure_of(measured("models.fifo-32.acmr"), card_).unit, "misses per triangle");
  EXPECT_FALSE(figure_of(measured("group.speed-up"), card_).lower_is_better);
}

TEST_F(FigureOf, WholeNamesGoFirstWhereverTheyStand) {
  EXPECT_EQ(figure_of(measured("models.amd.acmr"), card_).unit, "misses of that model per triangle");
  std::swap(card_.metrics.front(), card_.metrics.back());
  EXPECT_EQ(figure_of(measured("models.amd.acmr"), card_).unit, "misses of that model per triangle");
  EXPECT_EQ(figure_of(measured("acmr"), card_).unit, "misses per triangle");
}

TEST_F(FigureOf, WhatTheCardDoesNotNameHasNoUnit) {
  const Figure figure = figure_of(measured("other"), card_);
  EXPECT_EQ(figure.unit, "");
  EXPECT_TRUE(figure.lower_is_better);
}

}  // namespace
}  // namespace foredraw::metrics_test
