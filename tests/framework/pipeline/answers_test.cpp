#include <foredraw/pipeline/answers.h>
#include <foredraw/scene/order_table.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace foredraw::pipeline_answers_test {
namespace {

/// Why the framework does not take the table with two orders for each of its draws; empty: it takes it.
std::string mistake_of(const Scene& scene, const OrderTable& table) {
  SubjectOrders answer{{}, table};
  for (const DrawId id : table.draws) {
    IndexOrder order(scene.draws[id].levels[0].orders[0].triangle_count());
    std::iota(order.begin(), order.end(), 0u);
    answer.orders.push_back({order, order});
  }
  const Subject subject{"A", {{0, {}}}};
  Analyses analyses;
  try {
    EXPECT_EQ(ordered({scene, subject, {0}}, std::move(answer), analyses).table, table);
    return "";
  } catch (const std::runtime_error& mistake) {
    return mistake.what();
  }
}

TEST(Answers, TablesThatCanNotBeLookedUpAreRefused) {
  const float never = std::numeric_limits<float>::quiet_NaN();
  Scene moves =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "A"), testing::draw_of(testing::grid(1, 1), "B")});
  moves.animations = {{.name = "Walk"}};
  const OrderTable good{{0}, {{"Walk", {0, 1}}}, 2, 1, {0, 1, 1, 0}};
  const auto changed = [&](auto change) {
    OrderTable table = good;
    change(table);
    return table;
  };
  const std::vector<std::pair<std::string, OrderTable>> tables = {
      {"", good},
      {"it returned no order", changed([](auto& table) { table.draws.clear(); })},
      {"names a draw twice", changed([](auto& table) {
         table.draws = {0, 0};
       })},
      {"draw 1, which it was not given", changed([](auto& table) { table.draws = {1}; })},
      {"clip 'Run', which the scene does not have", changed([](auto& table) { table.clips[0].name = "Run"; })},
      {"clip 'Walk' twice", changed([](auto& table) { table.clips.push_back(table.clips[0]); })},
      {"times do not rise", changed([](auto& table) { table.clips[0].times = {}; })},
      {"times do not rise", changed([](auto& table) {
         table.clips[0].times = {1, 0};
       })},
      {"times do not rise", changed([&](auto& table) {
         table.clips[0].times = {0, never};
       })},
      {"has 0 steps of theta", changed([](auto& table) { table.theta_steps = 0; })},
      {"must have 1 to 65536", changed([](auto& table) { table.phi_steps = 65537; })},
      {"has 3 cells, but must have 4", changed([](auto& table) { table.order.pop_back(); })},
      {"names order 2 of 2", changed([](auto& table) { table.order[1] = 2; })}};
  for (const auto& [expected, table] : tables) {
    const std::string mistake = mistake_of(moves, table);
    EXPECT_EQ(mistake.empty(), expected.empty()) << mistake;
    EXPECT_NE(mistake.find(expected), std::string::npos) << expected << " in " << mistake;
  }
}

TEST(Answers, SequencesMoveOnlyWhatMayMove) {
  const Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(1, 1), "A"), testing::draw_of(testing::grid(1, 1), "B"),
                         testing::draw_of(testing::grid(1, 1), "C")});
  const Subject subject{"All", {{0, {}}, {1, {}}, {2, {}}}};
  const SubjectView view{scene, subject, {0, 1, 2}, {{{0, 1, 2}}}};
  Analyses analyses;
  const auto answered = [&](std::vector<std::uint32_t> sequence) {
    return ordered(view, SubjectOrders{{}, {}, std::move(sequence)}, analyses);
  };
  const OrderedSubject turned = answered({1, 0, 2});
  EXPECT_EQ(turned.sequence, (std::vector<SubjectPart>{{1, {}}, {0, {}}, {2, {}}}));
  EXPECT_TRUE(turned.draws.empty());
  EXPECT_THROW(answered({1, 2, 0}), std::runtime_error);
  EXPECT_THROW(answered({0, 1}), std::runtime_error);
  EXPECT_THROW(answered({0, 1, 1}), std::runtime_error);
}

TEST(Answers, TablesMoveOnlyWhatMayMove) {
  const Scene scene =
      testing::scene_of({testing::draw_of(testing::grid(2, 1), "A"), testing::draw_of(testing::grid(2, 1), "B"),
                         testing::draw_of(testing::grid(2, 1), "C")});
  const Subject subject{"All", {{0, {}}, {1, {}}, {2, {}}}};
  SubjectView view{scene, subject, {0, 1, 2}};
  view.free_groups = free_groups(subject, {2, 1});  // A stays
  Analyses analyses;
  const auto answered = [&](std::vector<std::uint16_t> sequences) {
    SubjectOrders answer;
    answer.table = {{0}, {}, 1, 2, {0, 2}};
    answer.table.parts = subject.parts;
    answer.table.sequences = std::move(sequences);
    answer.orders = {{{0, 1, 2, 3}, {1, 0, 2, 3}, {3, 2, 1, 0}}};
    return ordered(view, std::move(answer), analyses).table;
  };
  const OrderTable table = answered({0, 1, 2, 0, 1, 2, 0, 2, 1});
  EXPECT_EQ(table.order, (std::vector<std::uint8_t>{0, 1})) << "an order that nothing names is left out";
  EXPECT_EQ(table.sequences, (std::vector<std::uint16_t>{0, 1, 2, 0, 2, 1})) << "and its sequence with it";
  EXPECT_THROW(answered({0, 1, 2, 0, 1, 2, 2, 1, 0}), std::runtime_error) << "A moves";
  EXPECT_THROW(answered({0, 1, 2, 0, 1, 2}), std::runtime_error);
  EXPECT_THROW(answered({0, 1, 2, 0, 1, 2, 0, 2, 2}), std::runtime_error);
  EXPECT_THROW(answered({}), std::runtime_error);
}

}  // namespace
}  // namespace foredraw::pipeline_answers_test
