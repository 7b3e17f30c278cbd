#include <foredraw/collapses/refine_records.h>

#include "support/refined.h"

namespace foredraw::refine_records_test {
namespace {

using testing::Refined;
using testing::surfaces;
using testing::TestMesh;
using testing::Triangles;

void expect_same_topology(const TestMesh& is, const TestMesh& was) {
  EXPECT_EQ(testing::euler(is), testing::euler(was));
  const auto now = testing::edges(is), then = testing::edges(was);
  EXPECT_EQ(now.count(1), then.count(1));
  for (const auto& [faces, count] : now) EXPECT_LE(faces, 2);
}

TEST(RefineRecords, EveryStepOfAWalkDrawsWhatFullDetailIsThen) {
  std::uint64_t seed = 1;
  for (const TestMesh& mesh : surfaces()) {
    Refined one(mesh, ++seed);
    ASSERT_GT(one.splits(), 10u);
    EXPECT_EQ(one.drawn(), one.expected());
    one.settle([](std::uint32_t) { return true; });
    const TestMesh whole = one.surface();
    Random random(seed);
    for (int step = 0; step < 400; ++step) {
      const auto split = static_cast<std::uint32_t>(random.below(one.splits()));
      if (random.below(3) == 0) {
        foredraw_refine_split(&one.state, split, 1 + static_cast<std::uint32_t>(random.below(4)));
      } else {
        foredraw_refine_collapse(&one.state, split);
      }
      ASSERT_EQ(one.drawn(), one.expected()) << step;
      if (step % 10 == 0) expect_same_topology(one.surface(), whole);
    }
  }
}

/// Down to nothing, whatever becomes of holes and handles: as things of many pieces vanish.
TEST(RefineRecords, SequencesThatChangeTheTopologyAreDrawnAsTheyRun) {
  for (const TestMesh& mesh : surfaces()) {
    Refined one(mesh, 4, false);
    Random random(4);
    for (int step = 0; step < 200; ++step) {
      const auto split = static_cast<std::uint32_t>(random.below(one.splits()));
      if (random.below(3) == 0) {
        foredraw_refine_split(&one.state, split, ~0u);
      } else {
        foredraw_refine_collapse(&one.state, split);
      }
      ASSERT_EQ(one.drawn(), one.expected()) << step;
    }
  }
}

TEST(RefineRecords, NothingWantedIsTheBaseAndEverythingFullDetail) {
  for (const TestMesh& mesh : surfaces()) {
    Refined one(mesh);
    const Triangles base = one.drawn();
    EXPECT_EQ(base.size(), one.records.progressive.splits[0].triangles);
    one.settle([](std::uint32_t) { return true; });
    EXPECT_EQ(one.state.done, one.splits());
    EXPECT_EQ(one.drawn().size(), one.records.progressive.triangle.size());
    EXPECT_EQ(one.drawn(), one.expected());
    one.settle([](std::uint32_t) { return false; });
    EXPECT_EQ(one.state.done, 0u);
    EXPECT_EQ(one.drawn(), base);
  }
}

/// What is wanted, and what that needs, whichever way it was come to.
TEST(RefineRecords, TheSequenceOfSplitsIsImmaterial) {
  for (const TestMesh& mesh : surfaces()) {
    Refined one(mesh, 5);
    Random random(9);
    for (int round = 0; round < 5; ++round) {
      std::vector<bool> is_wanted(one.splits(), false), is_needed(one.splits(), false);
      for (int k = 0; k < 6; ++k) is_wanted[random.below(one.splits())] = true;
      for (std::uint32_t s = one.splits(); s-- > 0;) {
        const std::uint32_t parent = one.records.nodes[s].point;
        if (is_wanted[s] && parent < one.splits()) is_wanted[parent] = true;
        if (!is_wanted[s] && !is_needed[s]) continue;
        is_needed[s] = true;
        for (std::uint32_t i = one.records.nodes[s].first_need; i < one.records.nodes[s + 1].first_need; ++i) {
          is_needed[one.records.needs[i]] = true;
        }
      }
      const auto wants = [&](std::uint32_t split) { return is_wanted[split]; };
      const auto expect_needed = [&] {
        for (std::uint32_t s = 0; s < one.splits(); ++s) ASSERT_EQ(one.is_done(s), is_needed[s]) << s;
        EXPECT_EQ(one.drawn(), one.expected());
      };
      one.begin();
      one.settle(wants);
      expect_needed();
      one.settle([](std::uint32_t) { return true; });
      one.settle(wants);
      expect_needed();
      one.begin();
      for (std::uint32_t s = one.splits(); s-- > 0;) {
        if (is_wanted[s]) foredraw_refine_split(&one.state, s, ~0u);
      }
      expect_needed();
    }
  }
}

TEST(RefineRecords, AFrameChangesNoMoreThanItMay) {
  Refined one(testing::sphere(24, 16));
  const auto everything = [](const void*, const foredraw_refine_mesh*, std::uint32_t) -> int { return 1; };
  const auto nothing = [](const void*, const foredraw_refine_mesh*, std::uint32_t) -> int { return 0; };
  std::uint32_t done = 0;
  while (const std::uint32_t changed = foredraw_refine(&one.state, everything, nullptr, 7)) {
    EXPECT_LE(changed, 7u);
    EXPECT_EQ(one.state.done, done += changed);
    ASSERT_EQ(one.drawn(), one.expected());
  }
  EXPECT_EQ(done, one.splits());
  while (const std::uint32_t changed = foredraw_refine(&one.state, nothing, nullptr, 7)) {
    EXPECT_LE(changed, 7u);
    EXPECT_EQ(one.state.done, done -= changed);
    ASSERT_EQ(one.drawn(), one.expected());
  }
  EXPECT_EQ(done, 0u);
  EXPECT_EQ(foredraw_refine(&one.state, everything, nullptr, 0), 0u);
}

TEST(RefineRecords, AHubIsRefinedAsAnythingElse) {
  Refined one(testing::spokes(10'000));
  ASSERT_GT(one.splits(), 9'900u);
  const Triangles base = one.drawn();
  Random random(2);
  for (int step = 0; step < 2'000; ++step) {
    const auto split = static_cast<std::uint32_t>(random.below(one.splits()));
    if (random.below(3) == 0) {
      foredraw_refine_split(&one.state, split, 50);
    } else {
      foredraw_refine_collapse(&one.state, split);
    }
    if (step % 400 == 0) {
      ASSERT_EQ(one.drawn(), one.expected()) << step;
    }
  }
  one.settle([](std::uint32_t) { return true; });
  EXPECT_EQ(one.drawn().size(), 10'000u);
  EXPECT_EQ(one.drawn(), one.expected());
  one.settle([](std::uint32_t) { return false; });
  EXPECT_EQ(one.drawn(), base);
}

float distance(const float* a, const float* b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

TEST(RefineRecords, BallsAndNormalsHoldWhatIsBelow) {
  for (const TestMesh& mesh : surfaces()) {
    const Refined one(mesh);
    const std::vector<std::uint32_t>& full = one.records.progressive.indices;
    const auto place = [&](std::uint32_t vertex) { return mesh.positions[one.records.progressive.vertex[vertex]]; };
    for (std::size_t i = 0; i < full.size(); i += 3) {
      const glm::vec3 normal =
          glm::normalize(glm::cross(place(full[i + 1]) - place(full[i]), place(full[i + 2]) - place(full[i])));
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::uint32_t s = one.records.point[full[i + k]]; s < one.splits(); s = one.records.nodes[s].point) {
          const foredraw_refine_node& node = one.records.nodes[s];
          for (std::size_t other = 0; other < 3; ++other) {
            const glm::vec3 corner = place(full[i + other]);
            EXPECT_LE(distance(&corner.x, node.centre), node.radius);
          }
          EXPECT_LE(distance(&normal.x, node.axis), node.spread + 1e-6f);
        }
      }
    }
    for (std::uint32_t s = 0; s < one.splits(); ++s) {
      const foredraw_refine_node& node = one.records.nodes[s];
      if (node.point >= one.splits()) continue;
      const foredraw_refine_node& parent = one.records.nodes[node.point];
      EXPECT_LE(distance(node.centre, parent.centre) + node.radius, parent.radius * 1.000001f);
    }
  }
}

}  // namespace
}  // namespace foredraw::refine_records_test
