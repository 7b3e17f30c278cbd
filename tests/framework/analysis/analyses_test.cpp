#include <foredraw/analysis/analyses.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace foredraw::analyses_test {
namespace {

struct Sum {
  static constexpr std::string_view name = "sum";
  int value = 0;
};
struct Product {
  static constexpr std::string_view name = "product";
  int value = 0;
};
/// The same analysis as it stands in another module.
struct OthersSum {
  static constexpr std::string_view name = "sum";
  int value = 0;
};
struct Table {
  static constexpr std::string_view name = "table";
  std::vector<int> values;
  std::size_t bytes() const { return 1000; }
};

constexpr Stamp some_content = {1, 2};

TEST(Analyses, MadeOnceForEachContentAndName) {
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
  EXPECT_EQ(analyses.get<OthersSum>(some_content, [] { return OthersSum{5}; })->value, 1);
}

TEST(Analyses, TheLeastRecentlyUsedIsForgottenWhereTheyAreTooMany) {
  Analyses analyses({}, 3500);
  std::vector<int> made(5, 0);
  const auto ask = [&](std::size_t i) {
    return analyses.get<Table>({0, i}, [&] {
      ++made[i];
      return Table{{static_cast<int>(i)}};
    });
  };
  for (const std::size_t i : {0, 1, 2, 0, 3, 0, 2, 3}) EXPECT_EQ(ask(i)->values[0], static_cast<int>(i));
  EXPECT_EQ(analyses.size(), 3u);
  EXPECT_EQ(made, (std::vector<int>{1, 1, 1, 1, 0})) << "of 0, 1 and 2 the second was asked for longest ago";
  EXPECT_EQ(ask(1)->values[0], 1);
  EXPECT_EQ(made[1], 2);
}

TEST(Analyses, WhatSomebodyHoldsIsNotForgotten) {
  Analyses analyses({}, 1500);
  int made = 0;
  const auto make = [&] { return Table{{++made}}; };
  const auto held = analyses.get<Table>({0, 0}, make);
  for (std::size_t i = 1; i < 10; ++i) analyses.get<Table>({0, i}, make);
  EXPECT_EQ(analyses.get<Table>({0, 0}, make), held);
  EXPECT_EQ(made, 10);
  EXPECT_EQ(analyses.size(), 2u) << "what is held, and what came last";
}

TEST(Analyses, ManyMayAskWhereThereIsHardlyRoom) {
  Analyses analyses({}, 2500);
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (std::size_t asker = 0; asker < 4; ++asker) {
    threads.emplace_back([&, asker] {
      for (std::size_t i = 0; i < 500; ++i) {
        const std::size_t content = (i * (asker + 1)) % 7;
        const auto table = analyses.get<Table>({0, content}, [&] { return Table{{static_cast<int>(content)}}; });
        if (table->values[0] != static_cast<int>(content)) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_LE(analyses.size(), 7u);
}

TEST(Analyses, EmptiedHasTheSameDecoderAndNoAnalyses) {
  Analyses analyses([](const Image&) { return std::string("broken"); });
  analyses.get<Sum>(some_content, [] { return Sum{1}; });
  const Analyses emptied = analyses.emptied();
  EXPECT_EQ(emptied.size(), 0u);
  EXPECT_EQ(std::get<std::string>(emptied.decode(Image())), "broken");
  EXPECT_EQ(analyses.size(), 1u);
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
        got[asker][content] = analyses
                                  .get<Sum>({0, content},
                                            [&] {
                                              ++made[content];
                                              std::this_thread::sleep_for(std::chrono::milliseconds(2));
                                              return Sum{static_cast<int>(100 + content)};
                                            })
                                  ->value;
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
  const auto product = analyses.get<Product>(
      some_content, [&] { return Product{2 * analyses.get<Sum>(some_content, [] { return Sum{21}; })->value}; });
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
}  // namespace foredraw::analyses_test
