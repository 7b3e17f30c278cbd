#include <foredraw/collapses/progressive_records.h>

#include "support/collapses.h"

#include <foredraw/collapses/replay.h>

#include <gtest/gtest.h>

#include <random>

namespace foredraw::progressive_records_test {
namespace {

using testing::TestMesh;

/// Takes every edge in turn whose collapse leaves a surface, as far as it is easily seen; the vertices stay.
CollapseSequence some_collapses(const TestMesh& mesh, std::size_t most) {
  CollapseSequence sequence;
  sequence.first_pair = {0};
  for (std::size_t i = 0; i + 1 < mesh.indices.size() && sequence.collapses.size() < most; i += 5) {
    CollapseSequence more = sequence;
    const std::uint32_t removed = mesh.indices[i], kept = mesh.indices[i - i % 3 + (i + 1) % 3];
    more.collapses.push_back({removed, kept, 0, 0.5f * static_cast<float>(more.collapses.size())});
    more.pairs.push_back({removed, kept});
    more.first_pair.push_back(static_cast<std::uint32_t>(more.pairs.size()));
    if (replay(more, mesh.positions, mesh.indices).mistake.empty()) sequence = more;
  }
  return sequence;
}

foredraw_progressive_mesh mesh_of(ProgressiveRecords& made) {
  return {made.splits.data(),
          made.splits.size() - 1,
          made.patches.data(),
          made.indices.data(),
          static_cast<std::uint32_t>(made.vertex.size()),
          static_cast<std::uint32_t>(made.triangle.size()),
          made.splits.size() - 1};
}

class ProgressiveRecordsTest : public ::testing::Test {
 protected:
  ProgressiveRecordsTest() : sequence_(some_collapses(mesh_, 60)) {
    made_ = progressive_records(sequence_, mesh_.positions, mesh_.indices);
  }

  /// Whether what is drawn is the mesh after so many collapses, each triangle with its corners.
  void expect_state(const foredraw_progressive_mesh& mesh, std::size_t collapses) {
    const Collapsed want = collapsed(sequence_, collapses, mesh_.positions, mesh_.indices);
    const std::uint32_t triangles = foredraw_progressive_triangles(&mesh);
    ASSERT_EQ(triangles, want.origin.size());
    std::vector<std::uint32_t> place(mesh_.indices.size() / 3);
    for (std::uint32_t i = 0; i < want.origin.size(); ++i) place[want.origin[i]] = i;
    for (std::uint32_t t = 0; t < triangles; ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = mesh.indices[3 * t + k];
        ASSERT_LT(vertex, foredraw_progressive_vertices(&mesh));
        ASSERT_EQ(made_.vertex[vertex], want.indices[3 * place[made_.triangle[t]] + k]) << t;
      }
    }
  }

  TestMesh mesh_ = testing::torus(12, 9);
  CollapseSequence sequence_;
  ProgressiveRecords made_;
};

TEST_F(ProgressiveRecordsTest, EveryStateIsTheMeshAfterSoManyCollapses) {
  ASSERT_GT(sequence_.collapses.size(), 30u);
  foredraw_progressive_mesh mesh = mesh_of(made_);
  const std::vector<std::uint32_t> full = made_.indices;
  expect_state(mesh, 0);
  for (std::size_t done = mesh.split_count; done-- > 0;) {
    foredraw_progressive_go(&mesh, done);
    expect_state(mesh, mesh.split_count - done);
  }
  std::mt19937 random(7);
  for (int jump = 0; jump < 1000; ++jump) {
    const std::size_t done = random() % (mesh.split_count + 1);
    foredraw_progressive_go(&mesh, done);
    if (jump % 20 == 0) expect_state(mesh, mesh.split_count - done);
  }
  foredraw_progressive_go(&mesh, ~std::size_t{0});
  EXPECT_EQ(mesh.done, mesh.split_count);
  EXPECT_EQ(made_.indices, full);
}

/// A hub that goes from place to place takes thousands of triangles with it each time.
TEST_F(ProgressiveRecordsTest, AHubIsSplitAsAnythingElse) {
  mesh_ = testing::spokes(10'000);
  sequence_ = {.first_pair = {0}};
  const auto add = [&](std::uint32_t removed, std::uint32_t kept) {
    sequence_.collapses.push_back({removed, kept, 0, static_cast<float>(sequence_.collapses.size())});
    sequence_.pairs.push_back({removed, kept});
    sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
  };
  for (std::uint32_t rim = 200; rim < 400; ++rim) add(rim, rim + 1);
  for (std::uint32_t hub = 0; hub < 20; ++hub) add(hub, hub + 1);
  for (std::uint32_t rim = 500; rim < 9'900; ++rim) add(rim, rim + 1);
  for (std::uint32_t hub = 20; hub < 30; ++hub) add(hub, hub + 1);
  ASSERT_EQ(replay(sequence_, mesh_.positions, mesh_.indices).mistake, "");
  made_ = progressive_records(sequence_, mesh_.positions, mesh_.indices);
  EXPECT_GT(made_.patches.size(), 190'000u);
  foredraw_progressive_mesh mesh = mesh_of(made_);
  for (const std::size_t collapses : {205, 219, 400, 9'620, 9'630, 210, 150, 0}) {
    foredraw_progressive_go(&mesh, mesh.split_count - collapses);
    expect_state(mesh, collapses);
  }
}

TEST_F(ProgressiveRecordsTest, SplitsAreFoundByErrorAndByTriangles) {
  const foredraw_progressive_mesh mesh = mesh_of(made_);
  EXPECT_EQ(foredraw_progressive_splits_for(&mesh, 0),
            mesh.split_count - 1);  // the first collapse says that it costs 0
  EXPECT_EQ(foredraw_progressive_splits_for(&mesh, 1e9f), 0u);
  EXPECT_EQ(foredraw_progressive_splits_for(&mesh, -1), mesh.split_count);
  for (const float error : {0.4f, 0.5f, 3.3f}) {
    const std::size_t splits = foredraw_progressive_splits_for(&mesh, error);
    EXPECT_LE(made_.splits[splits].error, error);
    EXPECT_GT(made_.splits[splits - 1].error, error);
  }
  EXPECT_EQ(foredraw_progressive_splits_within(&mesh, 0), 0u);
  EXPECT_EQ(foredraw_progressive_splits_within(&mesh, 1000000), mesh.split_count);
  for (std::size_t done = 0; done < mesh.split_count; ++done) {
    const std::size_t found = foredraw_progressive_splits_within(&mesh, made_.splits[done].triangles);
    EXPECT_GE(found, done);
    EXPECT_EQ(made_.splits[found].triangles, made_.splits[done].triangles);
  }
}

TEST(ProgressiveRecords, AMeshThatNothingCollapsesHasOneState) {
  const TestMesh mesh = testing::grid(2, 2);
  CollapseSequence none;
  none.first_pair = {0};
  ProgressiveRecords made = progressive_records(none, mesh.positions, mesh.indices);
  EXPECT_EQ(made.indices.size(), mesh.indices.size());
  foredraw_progressive_mesh state = mesh_of(made);
  foredraw_progressive_go(&state, 5);
  EXPECT_EQ(foredraw_progressive_triangles(&state), mesh.indices.size() / 3);
  ProgressiveRecords empty = progressive_records(none, {}, {});
  EXPECT_EQ(empty.splits.size(), 1u);
}

}  // namespace
}  // namespace foredraw::progressive_records_test
