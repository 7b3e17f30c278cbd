#include <foredraw/overdraw/k_sequences.h>

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/overdraw/judging_looks.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw::k_sequences_test {
namespace {

using testing::TestMesh;

constexpr std::uint32_t balls = 6;

Views all_round() { return make_views({.views = "fibonacci", .count = 60, .size = 48}); }

/// Meshes as parts of a subject, in one pose.
struct SeenParts {
  std::vector<TestMesh> meshes;
  std::vector<RasterPart> parts;
  SubjectLayers subject;

  SeenParts(std::vector<TestMesh> shapes, const Views& views) : meshes(std::move(shapes)) {
    Clusters each{{0}};
    for (const TestMesh& mesh : meshes) {
      parts.push_back(testing::part_of(mesh, false));
      each.offsets.push_back(each.offsets.back() + static_cast<std::uint32_t>(mesh.indices.size() / 3));
      const auto part = static_cast<std::uint32_t>(subject.owners.size());
      subject.owners.push_back({part, part, 0});
      subject.draws.push_back(
          {mesh.indices, mesh.positions.size(), {{0, static_cast<std::uint32_t>(mesh.indices.size() / 3)}}});
    }
    const Executor executor(2);
    static_cast<Layers&>(subject.layers) =
        cluster_layers(fragment_layers(parts, views, executor).value(), each, executor);
    for (const View& view : views.views) {
      subject.directions.push_back(view.direction);
      subject.weights.push_back(1);
      subject.poses.push_back(0);
    }
  }
  SeenParts(const SeenParts&) = delete;

  std::uint32_t count() const { return static_cast<std::uint32_t>(parts.size()); }

  PartGroup all_free() const {
    PartGroup group{std::vector<std::uint32_t>(parts.size() + 1)};
    std::iota(group.offsets.begin(), group.offsets.end(), 0u);
    return group;
  }

  /// Of the looks that decide and that this sequence serves.
  PartLists lists_served(const KSequences& found, std::size_t sequence) const {
    std::vector<std::uint32_t> part_of(parts.size());
    std::iota(part_of.begin(), part_of.end(), 0u);
    std::vector<std::int64_t> weights;
    for (std::size_t look = 0; look < found.serving.size(); ++look) {
      weights.push_back(!judges(look) && found.serving[look] == sequence ? 1 : 0);
    }
    return part_lists(subject.layers, part_of, count(), weights);
  }
};

std::vector<TestMesh> scattered_balls(std::uint64_t seed) {
  Random random(seed);
  std::vector<TestMesh> meshes;
  for (std::uint32_t ball = 0; ball < balls; ++ball) {
    TestMesh one = testing::sphere(12, 6, 0.5f);
    const glm::vec3 at{random.unit(), random.unit(), random.unit()};
    for (glm::vec3& p : one.positions) p += 1.5f * at;
    meshes.push_back(std::move(one));
  }
  return meshes;
}

KSequences found_in(const SeenParts& seen, int k, int threads = 2) {
  const std::vector<PartGroup> groups = {seen.all_free()};
  return k_sequences(seen.subject, seen.count(), groups, {.k = k}, Executor(threads));
}

std::int64_t least_of_all(const PartLists& lists) {
  std::vector<std::uint32_t> sequence(lists.parts);
  std::iota(sequence.begin(), sequence.end(), 0u);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  do {
    least = std::min(least, fragments_shaded(lists, sequence));
  } while (std::ranges::next_permutation(sequence).found);
  return least;
}

TEST(KSequences, ServeBothSidesOfWhatStandsBehindOneAnother) {
  Views both{{}, 32};
  for (int i = 0; i < 10; ++i) both.views.push_back({{0, 0, i % 2 == 0 ? 1 : -1}});
  const SeenParts seen({testing::quad(1), testing::quad(0)}, both);
  const KSequences found = found_in(seen, 2);
  for (std::size_t look = 0; look < 10; ++look) EXPECT_EQ(found.sequences[found.serving[look]][0], look % 2);
  EXPECT_GT(found.before.shaded, found.before.visible);
  EXPECT_EQ(found.after.shaded, found.after.visible);
}

TEST(KSequences, AreEachTheBestOfAllForTheLooksThatTheyServe) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const SeenParts seen(scattered_balls(seed), all_round());
    for (const int k : {2, 3, 5}) {
      const KSequences found = found_in(seen, k);
      for (std::size_t j = 0; j < found.sequences.size(); ++j) {
        const PartLists lists = seen.lists_served(found, j);
        EXPECT_EQ(fragments_shaded(lists, found.sequences[j]), least_of_all(lists)) << seed << ' ' << k << ' ' << j;
      }
    }
  }
}

TEST(KSequences, LeaveLessTheMoreThereAre) {
  const SeenParts seen(scattered_balls(3), all_round());
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
  for (const int k : {1, 2, 4, 8}) {
    const KSequences found = found_in(seen, k);
    std::int64_t shaded = 0;
    for (std::size_t j = 0; j < found.sequences.size(); ++j) {
      shaded += fragments_shaded(seen.lists_served(found, j), found.sequences[j]);
    }
    EXPECT_LT(shaded, last) << k;
    last = shaded;
  }
}

TEST(KSequences, MoveOnlyWhatGroupsAllow) {
  const SeenParts seen(scattered_balls(1), all_round());
  const std::vector<PartGroup> groups = {{{0, 1, 2}}, {{3, 4, 5, 6}}};
  const KSequences found = k_sequences(seen.subject, balls, groups, {.k = 4}, Executor(2));
  std::size_t moved = 0;
  for (const auto& sequence : found.sequences) {
    EXPECT_TRUE(is_allowed(sequence, groups));
    moved += std::ranges::is_sorted(sequence) ? 0 : 1;
  }
  EXPECT_GE(moved, 2u);
}

TEST(KSequences, AreTheSameAtAnyNumberOfThreads) {
  const SeenParts seen(scattered_balls(2), all_round());
  const KSequences one = found_in(seen, 4, 1), three = found_in(seen, 4, 3);
  EXPECT_EQ(one.sequences, three.sequences);
  EXPECT_EQ(one.serving, three.serving);
}

TEST(KSequences, MayBeMoreThanThereAreLooks) {
  const SeenParts seen(scattered_balls(2), {{{{0, 0, 1}}, {{0, 0, -1}}}, 48});
  const KSequences found = found_in(seen, 5);
  EXPECT_EQ(found.sequences.size(), 5u);
  EXPECT_EQ(found.serving.size(), 2u);
}

/// The layers that orderers judge by count what drawing the parts in the sequence counts.
TEST(SubjectLayersInSequence, CountWhatDrawingCounts) {
  const Views views = all_round();
  const SeenParts seen(scattered_balls(4), views);
  const auto atoms = as_it_came(seen.subject);
  std::vector<std::uint32_t> sequence = {3, 1, 5, 0, 2, 4};
  for (int turn = 0; turn < 3; ++turn) {
    std::ranges::rotate(sequence, sequence.begin() + 1);
    std::vector<RasterPart> drawn;
    std::size_t triangles = 0;
    for (const std::uint32_t part : sequence) {
      drawn.push_back(seen.parts[part]);
      triangles += drawn.back().indices.size() / 3;
    }
    const auto counts = counts_of(seen.subject, atoms, sequence);
    const auto painted = testing::painted(drawn, views, testing::rising_order(triangles));
    for (std::size_t view = 0; view < views.views.size(); ++view) {
      EXPECT_EQ(counts[view].shaded, painted[view].shaded) << view;
    }
  }
}

}  // namespace
}  // namespace foredraw::k_sequences_test
