// Meshes of several pieces, which collapse at once, of the worst kind: what no piece may see of another is there, too.

#include "plugins/processors/quadric_collapse/quadric_collapse.h"

#include "support/collapses.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <utility>

namespace foredraw::quadric_collapse_pieces_test {
namespace {

using testing::TestMesh;

/// Hills that are four pieces.
TestMesh hills() {
  TestMesh mesh = testing::grid(120, 75);
  Random random(1);
  for (glm::vec3& p : mesh.positions) p.z = static_cast<float>(random.unit());
  return mesh;
}

/// One of so many corners is of any vertex: edges of three triangles and more, points of several sheets, long needles.
TestMesh with_wrong_corners(TestMesh mesh, std::uint64_t one_of) {
  Random random(2);
  for (std::uint32_t& index : mesh.indices) {
    const std::uint64_t other = random.below(mesh.positions.size());
    if (random.below(one_of) == 0) index = static_cast<std::uint32_t>(other);
  }
  return mesh;
}

/// Triangles that are there already, as they are, begun elsewhere or turned over.
TestMesh with_copies(TestMesh mesh, std::size_t count) {
  Random random(3);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t t = random.below(mesh.indices.size() / 3), turn = random.below(3), step = 1 + random.below(2);
    for (std::size_t k = 0; k < 3; ++k) mesh.indices.push_back(mesh.indices[3 * t + (turn + step * k) % 3]);
  }
  return mesh;
}

/// One of so many vertices lies nowhere, or too far away, or where another one lies.
TestMesh with_wrong_places(TestMesh mesh, std::uint64_t one_of) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Random random(4);
  for (glm::vec3& p : mesh.positions) {
    const std::uint64_t how = random.below(5 * one_of), other = random.below(mesh.positions.size());
    if (how == 0) p.x = nan;
    if (how == 1) p.y = -infinity;
    if (how == 2) p = {nan, nan, nan};
    if (how == 3) p *= 1e30f;
    if (how == 4) p = glm::vec3(mesh.positions[other]);
  }
  return mesh;
}

/// The front of it, each corner a vertex of its own, so that all edges are seams.
TestMesh unwelded(const TestMesh& mesh) {
  TestMesh apart;
  for (const std::uint32_t v : std::span(mesh.indices).first(9'000)) {
    apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
    apart.positions.push_back(mesh.positions[v]);
  }
  return apart;
}

struct Bad {
  const char* name;
  TestMesh mesh;
};

std::vector<Bad> bad_meshes() {
  const TestMesh all = with_wrong_places(with_copies(with_wrong_corners(hills(), 50), 1'000), 200);
  TestMesh few = with_wrong_corners(hills(), 1);  // points of many crossing sheets come to be of more and more
  few.indices.resize(9'000);
  return {{"wrong corners", with_wrong_corners(hills(), 40)},
          {"any corners", few},
          {"copies", with_copies(hills(), 4'000)},
          {"wrong places", with_wrong_places(hills(), 20)},
          {"all of it", all},
          {"all of it, and unwelded", unwelded(all)},
          {"single triangles", testing::soup(3'000, 5)}};
}

class QuadricCollapsePieces : public ::testing::TestWithParam<CollapsePlacement> {};
INSTANTIATE_TEST_SUITE_P(Placements, QuadricCollapsePieces,
                         ::testing::Values(CollapsePlacement::optimal, CollapsePlacement::endpoint));

TEST_P(QuadricCollapsePieces, OfBadMeshesCollapseAtOnceAsOneAfterTheOther) {
  const Executor one(1), four(4);
  const Executor backwards(2, [](std::size_t count, const std::function<void(std::size_t)>& task) {
    while (count > 0) task(--count);
  });
  for (const Bad& bad : bad_meshes()) {
    SCOPED_TRACE(bad.name);
    const TestMesh& mesh = bad.mesh;
    ASSERT_GT(mesh.positions.size(), 2 * 4096u) << "it is one piece";
    QuadricCollapseOptions options{.placement = GetParam(), .executor = &one};
    const CollapseSequence want = quadric_collapse(mesh.positions, mesh.indices, options);
    const Replay run = replay(want, mesh.positions, mesh.indices);
    EXPECT_EQ(run.mistake, "");
    EXPECT_FALSE(want.collapses.empty());
    for (const Executor* other : {&four, &backwards}) {
      options.executor = other;
      EXPECT_EQ(quadric_collapse(mesh.positions, mesh.indices, options), want);
    }
  }
}

/// Hills of two pieces, whose only short edges run from one piece to the other.
TEST_P(QuadricCollapsePieces, EdgesBetweenThemTakeTheirTurn) {
  constexpr std::uint32_t columns = 80, rows = 70, last = 40;  // column of the first piece, in the first half of rows
  TestMesh mesh = testing::grid(columns, rows);
  Random random(6);
  for (glm::vec3& p : mesh.positions) p.z = static_cast<float>(random.unit());
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t y = 5; y < 30; ++y) {
    const std::uint32_t a = y * (columns + 1) + last;
    mesh.positions[a + 1] = mesh.positions[a] + glm::vec3(1e-3f, 0, 0);
    edges.insert({a, a + 1});
  }
  const std::size_t least = mesh.indices.size() / 3 - 2 * edges.size();
  const CollapseSequence sequence =
      quadric_collapse(mesh.positions, mesh.indices, {.placement = GetParam(), .least = least});
  ASSERT_EQ(sequence.collapses.size(), edges.size());
  for (const Collapse& collapse : sequence.collapses) {
    EXPECT_TRUE(edges.contains(std::minmax(collapse.removed, collapse.kept)));
  }
}

/// Halfway, too: what pieces did beyond the end of the sequence is left out.
TEST_P(QuadricCollapsePieces, OfBadMeshesStopWhereTheyAreToldTo) {
  const Executor four(4);
  const TestMesh mesh = with_wrong_corners(hills(), 50);
  const std::size_t triangles = mesh.indices.size() / 3;
  QuadricCollapseOptions options{.placement = GetParam()};
  for (const std::size_t least : {triangles - 10, triangles / 2}) {
    options.least = least;
    options.executor = nullptr;
    const CollapseSequence want = quadric_collapse(mesh.positions, mesh.indices, options);
    const Replay run = replay(want, mesh.positions, mesh.indices);
    ASSERT_EQ(run.mistake, "");
    EXPECT_LE(run.triangles.back(), least);
    EXPECT_GT(run.triangles[run.triangles.size() - 2], least) << "one more than needed";
    options.executor = &four;
    EXPECT_EQ(quadric_collapse(mesh.positions, mesh.indices, options), want);
  }
}

}  // namespace
}  // namespace foredraw::quadric_collapse_pieces_test
