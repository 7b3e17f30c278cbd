#include "occlusion_order_seen.h"

#include <gtest/gtest.h>

namespace foredraw::occlusion_order_test {
namespace {

using testing::is_permutation_of;
using testing::rings;
using testing::rising;
using testing::Seen;
using testing::shells;
using testing::TestMesh;
using testing::unweighted;

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
  EXPECT_EQ(ordered(seen)[0], 4u);                // it hides all others
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
    const Seen held_out({seen.mesh.positions, indices}, others,
                        {{0, 1, static_cast<std::uint32_t>(indices.size() / 3)}});
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

TEST(OcclusionOrder, BuysNoVerticesForMoreThanTheyAreWorth) {
  const Seen seen(rings(), testing::all_sides(64));
  OcclusionOrderOptions options = with_budget(3);
  const auto spent = ordered(seen, options);
  options.vertex_cost = 1e15;  // above all that there is to save
  const auto thrifty = ordered(seen, options);
  EXPECT_LE(seen.acmr(thrifty), seen.acmr(rising(thrifty.size())));
  options.vertex_cost = 50;
  const auto some = ordered(seen, options);
  EXPECT_LT(seen.acmr(some), 0.9 * seen.acmr(spent));
  EXPECT_LT(seen.excess(some), 0.9 * seen.excess(thrifty));
}

TEST(OcclusionOrder, LeavesLessOfAtomsOfOneTriangleWithinTheSameBudget) {
  const TestMesh mesh = rings();
  OcclusionOrderOptions fine = with_budget(1.2), coarse = with_budget(1.2);
  fine.fine_atoms = true;
  const auto left = [&](const OcclusionOrderOptions& options) {
    const AtomSize size = atom_size(options, mesh.indices.size() / 3);
    const Seen seen(mesh, testing::all_sides(64), cut_atoms(mesh.indices, mesh.positions.size(), 16, size));
    const auto order = ordered(seen, options);
    EXPECT_LE(seen.acmr(order), 1.2 * acmr(mesh));
    return seen.excess(order);
  };
  EXPECT_EQ(atom_size(fine, 4000).most, 1u);
  EXPECT_EQ(atom_size(coarse, 4000).most, 12u);
  EXPECT_LT(left(fine), 0.85 * left(coarse));
}

TEST(OcclusionOrder, OfNothingIsNothing) { EXPECT_TRUE(occlusion_order({{}, 0, {{0}}}, {}).empty()); }

}  // namespace
}  // namespace foredraw::occlusion_order_test
