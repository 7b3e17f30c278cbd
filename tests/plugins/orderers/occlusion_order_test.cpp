#include "plugins/orderers/occlusion_order/k_orders.h"
#include "plugins/orderers/occlusion_order/piece_order.h"

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/analysis/cluster_layers.h>
#include <foredraw/analysis/vertex_cache.h>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <numeric>

namespace foredraw {
namespace {

using testing::TestMesh;

std::vector<std::uint32_t> rising(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

bool is_permutation_of(std::vector<std::uint32_t> order, std::size_t count) {
  std::ranges::sort(order);
  return order == rising(count);
}

/// Spheres in one another, the innermost drawn first: the worst order there is.
TestMesh shells(int count) {
  TestMesh all = testing::sphere(32, 16);
  for (int i = 2; i <= count; ++i) all = testing::joined(all, testing::sphere(32, 16, static_cast<float>(i)));
  return all;
}

/// Random triangles that hide one another, no two of them equally near.
TestMesh thicket(std::uint64_t seed) {
  Random random(seed);
  TestMesh mesh;
  for (std::uint32_t corner = 0; corner < 3 * 60; ++corner) {
    mesh.indices.push_back(corner);
    const auto coordinate = [&] { return static_cast<float>(random.unit()); };
    mesh.positions.push_back(glm::vec3{coordinate(), coordinate(), coordinate()});
  }
  return mesh;
}

/// A mesh as views see it.
struct Seen {
  TestMesh mesh;
  SeenSubject subject;

  Seen(const TestMesh& shape, const Views& views, const Clusters& clusters = {}) : mesh(shape) {
    const Executor executor(2);
    const RasterPart part{mesh.positions, mesh.indices};
    const Clusters atoms = clusters.count() > 0 ? clusters : cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12});
    static_cast<Layers&>(subject.layers) =
        cluster_layers(fragment_layers({&part, 1}, views, executor).value(), atoms, executor);
    for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) subject.owners.push_back({0, 0, atom});
    for (const View& view : views.views) {
      subject.directions.push_back(view.direction);
      subject.weights.push_back(view.weight);
    }
    subject.draws.push_back({mesh.indices, mesh.positions.size(), atoms});
  }
  Seen(const Seen&) = delete;

  double excess(const std::vector<std::uint32_t>& atoms) const { return excess_of(counts_of(subject, {&atoms, 1})); }

  static double excess_of(std::span<const OverdrawCount> counts) {
    OverdrawCount sum;
    for (const OverdrawCount& count : counts) sum += count;
    return static_cast<double>(sum.shaded) / static_cast<double>(sum.visible) - 1;
  }

  std::vector<std::uint32_t> indices(const std::vector<std::uint32_t>& atoms) const {
    const Clusters& all = subject.draws[0].atoms;
    std::vector<std::uint32_t> result;
    for (const std::uint32_t atom : atoms) {
      const auto from = mesh.indices.begin();
      result.insert(result.end(), from + 3 * all.offsets[atom], from + 3 * all.offsets[atom + 1]);
    }
    return result;
  }

  double acmr(const std::vector<std::uint32_t>& atoms) const {
    const CacheCount count = count_fifo(indices(atoms), mesh.positions.size(), 16);
    return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
  }
};

TestMesh for_the_cache(const TestMesh& mesh) {
  TestMesh result = mesh;
  meshopt_optimizeVertexCacheFifo(result.indices.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.size(),
                                  16);
  return result;
}

/// A shape that hides itself from all sides: rings through one another.
TestMesh rings() {
  TestMesh all = testing::torus(60, 24);
  TestMesh turned = testing::torus(60, 24);
  for (glm::vec3& p : turned.positions) p = {p.y, p.z, p.x};
  all = testing::joined(all, turned);
  for (glm::vec3& p : turned.positions) p = {p.y, p.z, p.x};
  return for_the_cache(testing::joined(all, turned));
}

// --- atoms ------------------------------------------------------------------------------------------------------------

/// Vertices that are in the cache on both sides of a cut and used behind it, as the definition says.
std::uint64_t parted(const TestMesh& mesh, std::uint32_t cut) {
  std::uint64_t count = 0;
  FifoCache cache(mesh.positions.size(), 16);
  std::vector<bool> entered_before(mesh.positions.size(), false), is_counted(mesh.positions.size(), false);
  for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t vertex = mesh.indices[i];
    const bool missed = cache.misses(vertex);
    if (i / 3 < cut) {
      entered_before[vertex] = true;
    } else if (missed) {
      is_counted[vertex] = true;  // it entered again, behind the cut
    } else if (entered_before[vertex] && !is_counted[vertex]) {
      is_counted[vertex] = true;
      ++count;
    }
  }
  return count;
}

TEST(Atoms, PartFewestVerticesOfAllWaysToCut) {
  const TestMesh mesh = for_the_cache(testing::torus(6, 5));
  const auto triangles = static_cast<std::uint32_t>(mesh.indices.size() / 3);
  const AtomSize size{5, 11};
  std::vector<std::uint64_t> cost(triangles);
  for (std::uint32_t t = 1; t < triangles; ++t) cost[t] = parted(mesh, t);
  std::vector<std::uint64_t> least(triangles + 1, ~std::uint64_t{0} / 2);
  least[0] = 0;
  for (std::uint32_t t = 1; t <= triangles; ++t) {
    for (std::uint32_t n = size.least; n <= std::min(size.most, t); ++n) {
      least[t] = std::min(least[t], least[t - n] + (t < triangles ? cost[t] : 0));
    }
  }
  const Clusters atoms = cut_atoms(mesh.indices, mesh.positions.size(), 16, size);
  ASSERT_TRUE(is_partition(atoms, triangles));
  std::uint64_t found = 0;
  for (std::size_t i = 1; i < atoms.count(); ++i) {
    found += cost[atoms.offsets[i]];
    EXPECT_GE(atoms.offsets[i + 1] - atoms.offsets[i], size.least);
    EXPECT_LE(atoms.offsets[i + 1] - atoms.offsets[i], size.most);
  }
  EXPECT_EQ(found, least[triangles]);
}

TEST(Atoms, AreCutWhereverItCostsNothing) {
  const TestMesh mesh = testing::soup(40, 1);
  EXPECT_EQ(cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12}).count(), 40u);
}

TEST(Atoms, OfFewTrianglesAreOne) {
  const TestMesh mesh = testing::grid(1, 2);
  EXPECT_EQ(cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12}).offsets, (std::vector<std::uint32_t>{0, 4}));
  EXPECT_EQ(cut_atoms({}, 0, 16, {4, 12}).offsets, (std::vector<std::uint32_t>{0}));
}

TEST(Atoms, KnowWhatCuttingThemOffCosts) {
  // Two strips of a grid: drawn one behind the other the second finds the middle row in the cache.
  const TestMesh mesh = testing::grid(4, 2);
  const Clusters rows{{0, 8, 16}};
  EXPECT_EQ(misses_of_cuts(mesh.indices, mesh.positions.size(), 16, rows), (std::vector<std::uint32_t>{0, 5}));
}

// --- occlusions -------------------------------------------------------------------------------------------------------

/// What drawing the pieces in this order costs, but for what it costs in any order; straight from the definition.
std::int64_t cost_of(const Occlusions& occlusions, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::int64_t cost = 0;
  for (std::uint32_t p = 0; p < occlusions.pieces; ++p) {
    for (std::uint32_t i = occlusions.first_pair[p]; i < occlusions.first_pair[p + 1]; ++i) {
      const auto& [other, net] = occlusions.pairs[i];
      if (p < other && place[other] < place[p]) cost += net;  // each pair stands in two rows
    }
  }
  for (std::size_t l = 0; l < occlusions.weights.size(); ++l) {
    std::uint32_t earliest = ~std::uint32_t{0};
    for (std::uint32_t i = occlusions.first_layer[l]; i < occlusions.first_layer[l + 1]; ++i) {
      const std::uint32_t at = place[occlusions.layers[i]];
      if (at > earliest) continue;
      earliest = at;
      cost += occlusions.weights[l];
    }
  }
  return cost;
}

std::vector<WeightedLayers> unweighted(const Layers& layers) {
  std::vector<WeightedLayers> views;
  for (const ViewLayers& view : layers.views) views.push_back({&view, 1});
  return views;
}

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

// --- the search -------------------------------------------------------------------------------------------------------

std::vector<double> as_places(const std::vector<std::uint32_t>& order) {
  std::vector<double> places(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) places[order[i]] = i;
  return places;
}

TEST(PieceOrder, EndsWhereNoPieceMovedAloneCostsLess) {
  const Seen seen(thicket(7), testing::all_sides(48));
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  const Occlusions occlusions = occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0];
  PieceOrder search(occlusions, as_places(rising(pieces)));
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
  PieceOrder search(occlusions, as_places(order));
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

// --- orders -----------------------------------------------------------------------------------------------------------

OcclusionOrderOptions with_budget(double budget) {
  OcclusionOrderOptions options;
  options.acmr_budget = budget;
  return options;
}

std::vector<std::uint32_t> ordered(const Seen& seen, const OcclusionOrderOptions& options = {}) {
  const auto pieces = static_cast<std::uint32_t>(seen.subject.draws[0].atoms.count());
  return occlusion_order(seen.subject.draws[0],
                         occlusions_of(unweighted(seen.subject.layers), seen.subject.owners, {&pieces, 1})[0], options);
}

TEST(OcclusionOrder, DrawsFirstWhatHidesAllOthers) {
  const TestMesh mesh = shells(5);
  const auto each = static_cast<std::uint32_t>(mesh.indices.size() / 3 / 5);
  const Seen seen(mesh, testing::all_sides(64), {{0, each, 2 * each, 3 * each, 4 * each, 5 * each}});
  EXPECT_NEAR(seen.excess(rising(5)), 1.2, 0.2);  // an outer shell hides what is drawn already
  EXPECT_EQ(ordered(seen)[0], 4u);  // it hides all others
  EXPECT_EQ(seen.excess(ordered(seen)), 0);
}

TEST(OcclusionOrder, KeepsItsBudget) {
  const Seen seen(rings(), testing::all_sides(64));
  const auto before = rising(seen.subject.draws[0].atoms.count());
  double last = seen.excess(before);
  for (const double budget : {1.0, 1.02, 1.05, 1.2, 3.0}) {
    const auto order = ordered(seen, with_budget(budget));
    ASSERT_TRUE(is_permutation_of(order, before.size()));
    EXPECT_LE(seen.acmr(order), budget * seen.acmr(before)) << budget;
    EXPECT_LE(seen.excess(order), last * 1.05) << budget;  // more to spend buys more
    last = seen.excess(order);
  }
}

double acmr(const TestMesh& mesh) {
  const CacheCount count = count_fifo(mesh.indices, mesh.positions.size(), 16);
  return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
}

TEST(OcclusionOrder, LeavesLessThanAGeometricGuessLeavesFromOtherSides) {
  const Seen seen(rings(), testing::all_sides(96, 0, 162));
  TestMesh guess = seen.mesh;
  meshopt_optimizeOverdraw(guess.indices.data(), seen.mesh.indices.data(), seen.mesh.indices.size(),
                           &seen.mesh.positions[0].x, seen.mesh.positions.size(), sizeof(glm::vec3), 1.05f);
  const Views others = testing::all_sides(96, 3, 100);
  const auto excess = [&](const std::vector<std::uint32_t>& indices) {
    const Seen held_out({seen.mesh.positions, indices}, others, {{0, 1, static_cast<std::uint32_t>(indices.size() / 3)}});
    return held_out.excess({0, 1});
  };
  for (const OcclusionQuality quality : {OcclusionQuality::fast, OcclusionQuality::balanced, OcclusionQuality::high}) {
    OcclusionOrderOptions options = with_budget(acmr(guess) / acmr(seen.mesh));
    options.quality = quality;
    const auto order = ordered(seen, options);
    EXPECT_LE(seen.acmr(order), acmr(guess));
    const double part = quality == OcclusionQuality::fast ? 0.75 : 0.6;
    EXPECT_LT(excess(seen.indices(order)), part * excess(guess.indices));
  }
}

TEST(OcclusionOrder, OfNothingIsNothing) {
  EXPECT_TRUE(occlusion_order({{}, 0, {{0}}}, {}).empty());
}

// --- several orders ---------------------------------------------------------------------------------------------------

KOrdersOptions with_k(int k) {
  KOrdersOptions options;
  options.acmr_budget = 3;
  options.k = k;
  return options;
}

/// Two squares back to back, each cut in halves that hide one another from one side each: no order serves both sides.
TestMesh opposites() {
  TestMesh mesh;
  for (const float side : {1.0f, -1.0f}) {
    for (const float z : {0.0f, 1.0f}) {
      TestMesh one = testing::quad(z * side + 0.1f * side);
      mesh = mesh.indices.empty() ? one : testing::joined(mesh, one);
    }
  }
  return mesh;
}

TEST(KOrders, ServeWhatOneCanNot) {
  // Drawn from both sides, what is in front from one is behind from the other.
  const TestMesh mesh = opposites();
  const Executor executor(2);
  const RasterPart part{mesh.positions, mesh.indices, false};
  SeenSubject subject;
  const Views views = testing::views_of({{0, 0, 1}, {0, 0, -1}});
  static_cast<Layers&>(subject.layers) = fragment_layers({&part, 1}, views, executor).value();
  for (const View& view : views.views) subject.directions.push_back(view.direction), subject.weights.push_back(1);
  const Clusters triangles{rising(9)};
  for (std::uint32_t t = 0; t < 8; ++t) subject.owners.push_back({0, 0, t});
  subject.draws.push_back({mesh.indices, mesh.positions.size(), triangles});

  const KOrders one = k_orders(subject, with_k(1), executor);
  EXPECT_GT(Seen::excess_of(one.counts), 0.4);
  for (const int k : {2, 5}) {  // more orders than nodes too
    const KOrders several = k_orders(subject, with_k(k), executor);
    EXPECT_EQ(Seen::excess_of(several.counts), 0) << k;
    EXPECT_EQ(several.orders.size(), static_cast<std::size_t>(k));
    EXPECT_NE(several.serving[0], several.serving[1]);
  }
}

TEST(KOrders, AreTheBetterTheMoreThereAre) {
  const Seen seen(rings(), testing::all_sides(64, 0, 100));
  const Executor executor(2);
  double last = 1e9;
  for (const int k : {1, 2, 5, 12}) {
    KOrdersOptions options = with_k(k);
    options.acmr_budget = 1.05;
    const KOrders found = k_orders(seen.subject, options, executor);
    EXPECT_LT(Seen::excess_of(found.counts), last) << k;
    last = Seen::excess_of(found.counts);
    for (const std::uint8_t order : found.serving) EXPECT_LT(order, k);
    // Nodes are served as well as by the order that stands alone at least, and that is the best one alone.
    const auto alone = counts_of(seen.subject, found.orders[0]);
    for (std::size_t node = 0; node < alone.size(); ++node) EXPECT_LE(found.counts[node].shaded, alone[node].shaded);
    for (const auto& order : found.orders) {
      EXPECT_LE(seen.excess(found.orders[0][0]), seen.excess(order[0]) * 1.05);  // pictures weigh alike there, not pixels
    }
  }
}

TEST(KOrders, AreTheSameOnAnyNumberOfThreads) {
  const Seen seen(rings(), testing::all_sides(64));
  const Executor one(1), two(2);
  const KOrders a = k_orders(seen.subject, with_k(3), one);
  const KOrders b = k_orders(seen.subject, with_k(3), two);
  EXPECT_EQ(a.orders, b.orders);
  EXPECT_EQ(a.serving, b.serving);
}

TEST(KOrders, OfASubjectThatNobodySeesAreAsItCame) {
  Seen seen(testing::grid(3, 3), testing::views_of({{0, 0, -1}}));  // its back faces are culled
  const Executor executor(2);
  const KOrders found = k_orders(seen.subject, with_k(4), executor);
  for (const auto& order : found.orders) EXPECT_EQ(order[0], rising(order[0].size()));
}

}  // namespace
}  // namespace foredraw
