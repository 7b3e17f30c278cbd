#include <foredraw/analysis/analyses.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace foredraw {
namespace {

struct Sum {
  int value = 0;
};
struct Product {
  int value = 0;
};

constexpr Stamp some_content = {1, 2};

TEST(Analyses, MadeOnceForEachContentAndType) {
  Analyses analyses;
  int made = 0;
  const auto first = analyses.get<Sum>(some_content, [&] { return Sum{++made}; });
  EXPECT_EQ(analyses.get<Sum>(some_content, [&] { return Sum{++made}; }), first);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(analyses.get<Product>(some_content, [&] { return Product{10 + ++made}; })->value, 12);
  EXPECT_EQ(analyses.get<Sum>({1, 3}, [&] { return Sum{++made}; })->value, 3);
  EXPECT_EQ(analyses.get<Sum>({2, 2}, [&] { return Sum{++made}; })->value, 4);
  EXPECT_EQ(first->value, 1);
  EXPECT_EQ(analyses.size(), 4u);
}

TEST(Analyses, OneMakesWhileTheOthersWait) {
  constexpr std::size_t contents = 16;
  constexpr std::size_t askers = 8;
  Analyses analyses;
  std::vector<std::atomic<int>> made(contents);
  std::vector<std::vector<int>> got(askers, std::vector<int>(contents));
  std::vector<std::thread> threads;
  for (std::size_t asker = 0; asker < askers; ++asker) {
    threads.emplace_back([&, asker] {
      for (std::size_t i = 0; i < contents; ++i) {
        const std::size_t content = (i + asker) % contents;
        got[asker][content] = analyses.get<Sum>({0, content}, [&] {
          ++made[content];
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
          return Sum{static_cast<int>(100 + content)};
        })->value;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t content = 0; content < contents; ++content) {
    EXPECT_EQ(made[content], 1) << "content " << content;
    for (const auto& values : got) EXPECT_EQ(values[content], static_cast<int>(100 + content));
  }
  EXPECT_EQ(analyses.size(), contents);
}

TEST(Analyses, AThrowingMakeIsAskedAgain) {
  Analyses analyses;
  const auto fail = []() -> Sum { throw std::runtime_error("no room"); };
  EXPECT_THROW(analyses.get<Sum>(some_content, fail), std::runtime_error);
  EXPECT_THROW(analyses.get<Sum>(some_content, fail), std::runtime_error);
  EXPECT_EQ(analyses.get<Sum>(some_content, [] { return Sum{5}; })->value, 5);
  EXPECT_EQ(analyses.get<Sum>(some_content, fail)->value, 5) << "made by now";
}

TEST(Analyses, OneAnalysisMayAskForAnother) {
  Analyses analyses;
  const auto product = analyses.get<Product>(some_content, [&] {
    return Product{2 * analyses.get<Sum>(some_content, [] { return Sum{21}; })->value};
  });
  EXPECT_EQ(product->value, 42);
}

TEST(Analyses, ClearForgetsButWhatIsHeldStays) {
  Analyses analyses;
  const auto held = analyses.get<Sum>(some_content, [] { return Sum{1}; });
  analyses.clear();
  EXPECT_EQ(analyses.size(), 0u);
  EXPECT_EQ(analyses.get<Sum>(some_content, [] { return Sum{2}; })->value, 2);
  EXPECT_EQ(held->value, 1);
}

TEST(PositionsOf, EqualContentIsDecodedOnce) {
  Analyses analyses;
  const std::vector<glm::vec3> values = {{1, 2, 3}, {4, 5, 6}};
  const auto positions = positions_of(analyses, *testing::vertex_streams(values));
  EXPECT_EQ(positions->values, values);
  EXPECT_EQ(positions_of(analyses, *testing::vertex_streams(values)), positions);
  EXPECT_EQ(analyses.size(), 1u);
}

TEST(PositionsOf, FormatIsPartOfTheContent) {
  Analyses analyses;
  VertexStreams streams = *testing::vertex_streams({{1, 2, 3}, {4, 5, 6}});
  const auto floats = positions_of(analyses, streams);
  streams.base[0].format = {Component::uint16, 6, false, 12};
  EXPECT_NE(positions_of(analyses, streams)->values, floats->values);
  streams.base[0].format.normalized = true;
  EXPECT_LE(positions_of(analyses, streams)->values[0].y, 1);
}

TEST(PositionsOf, NoneWithoutAStream) {
  Analyses analyses;
  EXPECT_TRUE(positions_of(analyses, VertexStreams{})->values.empty());
}

}  // namespace
}  // namespace foredraw
