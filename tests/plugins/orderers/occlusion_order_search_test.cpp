#include "occlusion_order_seen.h"
#include "plugins/orderers/occlusion_order/piece_order.h"

#include <gtest/gtest.h>

namespace foredraw::occlusion_order_search_test {
namespace {

using testing::cost_of;
using testing::is_permutation_of;
using testing::rising;
using testing::Seen;
using testing::TestMesh;
using testing::thicket;
using testing::unweighted;

TEST(Occlusions, CostWhatLayersCount) {
  const Seen seen(thicket(3), testing::all_sides(48));
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  const Occlusions occlusions = occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0];
  ASSERT_GT(occlusions.pairs.size(), 0u);
  ASSERT_GT(occlusions.weights.size(), 0u);
  const auto drawn = [&](const std::vector<std::uint32_t>& order) {
    return static_cast<std::int64_t>(count_overdraw(seen.subject.layers, order).shaded);
  };
  const auto first = testing::random_order(pieces, 0);
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    const auto order = testing::random_order(pieces, seed);
    EXPECT_EQ(cost_of(occlusions, order) - cost_of(occlusions, first), drawn(order) - drawn(first));
  }
}

TEST(Occlusions, FallApartByPartsAndDraws) {
  // Two draws, one of them seen twice, with the other one between.
  const TestMesh a = thicket(4), b = thicket(5);
  TestMesh moved = a;
  for (glm::vec3& p : moved.positions) p += glm::vec3(0.1f, 0.2f, 0.1f);
  const std::vector<RasterPart> parts = {
      {a.positions, a.indices, false}, {b.positions, b.indices, false}, {moved.positions, moved.indices, false}};
  const Executor executor(2);
  const FragmentLayers layers = fragment_layers(parts, testing::all_sides(48), executor).value();
  const auto in_a = static_cast<std::uint32_t>(a.indices.size() / 3);
  const auto in_b = static_cast<std::uint32_t>(b.indices.size() / 3);
  std::vector<LayerOwner> owners;
  for (std::uint32_t t = 0; t < in_a; ++t) owners.push_back({0, 0, t});
  for (std::uint32_t t = 0; t < in_b; ++t) owners.push_back({1, 1, t});
  for (std::uint32_t t = 0; t < in_a; ++t) owners.push_back({2, 0, t});
  const std::uint32_t pieces[] = {in_a, in_b};
  const std::vector<Occlusions> occlusions = occlusions_of(unweighted(layers), owners, pieces);

  const auto drawn = [&](const std::vector<std::uint32_t>& of_a, const std::vector<std::uint32_t>& of_b) {
    std::vector<std::uint32_t> order = of_a;
    for (const std::uint32_t t : of_b) order.push_back(in_a + t);
    for (const std::uint32_t t : of_a) order.push_back(in_a + in_b + t);
    return static_cast<std::int64_t>(count_overdraw(layers, order).shaded);
  };
  const auto cost = [&](const std::vector<std::uint32_t>& of_a, const std::vector<std::uint32_t>& of_b) {
    return cost_of(occlusions[0], of_a) + cost_of(occlusions[1], of_b);
  };
  const auto first_a = rising(in_a), first_b = rising(in_b);
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const auto of_a = testing::random_order(in_a, seed), of_b = testing::random_order(in_b, seed);
    EXPECT_EQ(cost(of_a, of_b) - cost(first_a, first_b), drawn(of_a, of_b) - drawn(first_a, first_b));
  }
}

TEST(Occlusions, OfJoinedPiecesCostTheSame) {
  const Seen seen(thicket(6), testing::all_sides(48));
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  const Occlusions fine = occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0];
  std::vector<std::uint32_t> joined;
  std::vector<std::vector<std::uint32_t>> members;
  Random random(1);
  for (std::uint32_t p = 0; p < pieces; ++p) {
    if (p == 0 || random.below(3) == 0) members.emplace_back();
    members.back().push_back(p);
    joined.push_back(static_cast<std::uint32_t>(members.size() - 1));
  }
  const Occlusions coarse = with_joined_pieces(fine, joined);
  ASSERT_EQ(coarse.pieces, members.size());
  const auto of_fine = [&](const std::vector<std::uint32_t>& order) {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t p : order) result.insert(result.end(), members[p].begin(), members[p].end());
    return result;
  };
  const auto first = testing::random_order(members.size(), 0);
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    const auto order = testing::random_order(members.size(), seed);
    EXPECT_EQ(cost_of(coarse, order) - cost_of(coarse, first),
              cost_of(fine, of_fine(order)) - cost_of(fine, of_fine(first)));
  }
}

std::vector<double> as_places(const std::vector<std::uint32_t>& order) {
  std::vector<double> ranks(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
  return ranks;
}

TEST(PieceOrder, EndsWhereNoPieceMovedAloneCostsLess) {
  const Seen seen(thicket(7), testing::all_sides(48));
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  const Occlusions occlusions = occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0];
  PiecePlaces places = PiecePlaces::as_numbered(pieces);
  PieceOrder search(occlusions, places);
  search.improve(1000);
  const std::vector<std::uint32_t> order = search.order();
  ASSERT_TRUE(is_permutation_of(order, pieces));
  const std::int64_t cost = cost_of(occlusions, order);
  EXPECT_LT(cost, cost_of(occlusions, rising(pieces)));
  for (std::uint32_t from = 0; from < pieces; ++from) {
    std::vector<std::uint32_t> others = order;
    others.erase(others.begin() + from);
    for (std::uint32_t to = 0; to < pieces; ++to) {
      std::vector<std::uint32_t> moved = others;
      moved.insert(moved.begin() + to, order[from]);
      EXPECT_GE(cost_of(occlusions, moved), cost);
    }
  }
}

TEST(PieceOrder, KnowsWhatJoiningCosts) {
  const Seen seen(thicket(8), testing::all_sides(48));
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  const Occlusions occlusions = occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0];
  const std::vector<std::uint32_t> order = testing::random_order(pieces, 1);
  PiecePlaces places = PiecePlaces::as_numbered(pieces);
  places.ranks = as_places(order);
  PieceOrder search(occlusions, places);
  const auto with_moved = [&](std::uint32_t piece, std::uint32_t other, bool behind) {
    std::vector<std::uint32_t> moved = order;
    moved.erase(std::ranges::find(moved, piece));
    moved.insert(std::ranges::find(moved, other) + (behind ? 1 : 0), piece);
    return cost_of(occlusions, moved) - cost_of(occlusions, order);
  };
  for (std::uint32_t piece = 0; piece < pieces; ++piece) {
    const auto [behind_last, before_next] = search.cost_of_joining(piece);
    EXPECT_EQ(behind_last, piece == 0 ? 0 : with_moved(piece, piece - 1, true));
    EXPECT_EQ(before_next, piece + 1 == pieces ? 0 : with_moved(piece, piece + 1, false));
  }
}

}  // namespace
}  // namespace foredraw::occlusion_order_search_test
