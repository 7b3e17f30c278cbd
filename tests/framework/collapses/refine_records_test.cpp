#include <foredraw/collapses/refine_records.h>

#include "support/collapses.h"

#include <foredraw/collapses/collapse_recorder.h>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <numeric>

namespace foredraw {
namespace {

using testing::TestMesh;

/// Random edges, whose ends are in no other one of the same round, until no edge may go: so that splits hang together
/// in few steps, as they do where a simplifier made them.
CollapseSequence collapses_of(const TestMesh& mesh, std::uint64_t seed) {
  CollapseRecorder recorder(mesh.positions, mesh.indices);
  Random random(seed);
  double error = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    std::vector<bool> is_touched(mesh.positions.size(), false);
    std::vector<std::uint32_t> corners(3 * recorder.points().size());
    std::iota(corners.begin(), corners.end(), 0u);
    for (std::size_t i = corners.size(); i > 1; --i) std::swap(corners[i - 1], corners[random.below(i)]);
    for (const std::uint32_t corner : corners) {
      const CollapseRecorder::Corners& points = recorder.points()[corner / 3];
      const std::uint32_t p = points[corner % 3], q = points[(corner + 1) % 3];
      if (p == q || is_touched[p] || is_touched[q] || recorder.triangles_of_edge(p, q) == 0) continue;
      if (!recorder.keeps_topology(p, q) || !recorder.pairs_up(p, q)) continue;
      recorder.collapse(p, q, {.blend = 0, .error = error += 1, .place = {}});
      is_touched[p] = is_touched[q] = has_changed = true;
    }
  }
  return recorder.take();
}

std::vector<TestMesh> surfaces() {
  return {testing::closed_torus(14, 9), testing::flat_ring(20, 4), testing::moebius_strip(30),
          testing::box_of_sides(4),     testing::sphere(16, 10),   testing::grid(9, 7)};
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A mesh with a state, and what should be drawn.
struct Refined {
  explicit Refined(const TestMesh& of, std::uint64_t seed = 1)
      : mesh(of),
        sequence(collapses_of(of, seed)),
        records(refine_records(sequence, mesh.positions, mesh.indices)),
        arrays(records.mesh()),
        memory(foredraw_refine_words(&arrays)) {
    begin();
  }

  void begin() { foredraw_refine_begin(&state, &arrays, memory.data()); }
  std::uint32_t splits() const { return arrays.split_count; }
  bool is_done(std::uint32_t split) const { return foredraw_refine_is_done(&state, split) != 0; }

  /// Runs frames until nothing changes.
  template <class Wants>
  void settle(Wants wants, std::uint32_t most = ~0u) {
    const auto call = [](const void* context, const foredraw_refine_mesh*, std::uint32_t split) -> int {
      return (*static_cast<const Wants*>(context))(split);
    };
    int frames = 0;
    while (foredraw_refine(&state, call, &wants, most) > 0) ASSERT_LT(++frames, 10000);
  }

  Triangles drawn() const {
    Triangles triangles;
    for (std::uint32_t i = 0; i < 3 * state.triangles; i += 3) {
      triangles.push_back({state.indices[i], state.indices[i + 1], state.indices[i + 2]});
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  /// Full detail, each corner at the vertex that stands for it. By the sequence alone.
  Triangles expected() const {
    const auto collapses = static_cast<std::uint32_t>(sequence.collapses.size());
    std::vector<std::uint32_t> stands(mesh.positions.size()), point = records.point, full = records.progressive.indices;
    std::iota(stands.begin(), stands.end(), 0u);
    for (std::uint32_t c = collapses; c-- > 0;) {
      if (is_done(collapses - 1 - c)) continue;
      for (std::uint32_t i = sequence.first_pair[c]; i < sequence.first_pair[c + 1]; ++i) {
        stands[sequence.pairs[i].removed] = stands[sequence.pairs[i].kept];
      }
    }
    std::vector<std::uint32_t> number(mesh.positions.size());
    for (std::uint32_t v = 0; v < point.size(); ++v) number[records.progressive.vertex[v]] = v;
    Triangles triangles;
    for (std::size_t i = 0; i < full.size(); i += 3) {
      std::array<std::uint32_t, 3> three{};
      for (std::size_t k = 0; k < 3; ++k) three[k] = number[stands[records.progressive.vertex[full[i + k]]]];
      const bool has_area = point[three[0]] != point[three[1]] && point[three[1]] != point[three[2]] &&
                            point[three[2]] != point[three[0]];
      if (has_area) triangles.push_back(three);
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  TestMesh surface() const {
    TestMesh left;
    for (const std::uint32_t v : records.progressive.vertex) left.positions.push_back(mesh.positions[v]);
    left.indices.assign(state.indices, state.indices + std::size_t{3} * state.triangles);
    return left;
  }

  TestMesh mesh;
  CollapseSequence sequence;
  RefineRecords records;
  foredraw_refine_mesh arrays;
  std::vector<std::uint32_t> memory;
  foredraw_refinement state{};
};

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

const char* mistake(const RefineRecords& records) {
  const foredraw_refine_mesh mesh = records.mesh();
  const foredraw_refine_arrays arrays = records.arrays();
  std::vector<std::uint32_t> memory(foredraw_refine_check_words(&mesh, &arrays));
  return foredraw_refine_check(&mesh, &arrays, memory.data());
}

TEST(RefineCheck, WhatIsMadeHereIsSound) {
  std::vector<TestMesh> meshes = testing::odd_meshes();
  for (const TestMesh& mesh : surfaces()) meshes.push_back(mesh);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      EXPECT_STREQ(mistake(Refined(meshes[i], seed).records), nullptr) << i;
    }
  }
}

/// Damages a sound mesh somewhere, and expects it to be refused.
class RefineDamage : public ::testing::Test {
 protected:
  void refuse(const RefineRecords& damaged, const std::string& why) {
    const char* told = mistake(damaged);
    ASSERT_NE(told, nullptr) << why;
    EXPECT_NE(std::string(told).find(why), std::string::npos) << told;
  }
  std::uint32_t splits() const { return one_.splits(); }

  Refined one_{testing::closed_torus(14, 9)};
  RefineRecords damaged_ = one_.records;
};

TEST_F(RefineDamage, Parents) {
  damaged_.nodes[4].point = 4;
  refuse(damaged_, "parent does not come before");
  damaged_.nodes[4].point = 9;
  refuse(damaged_, "parent does not come before");
  damaged_.nodes[4].point = damaged_.points;
  refuse(damaged_, "no point");
  damaged_.nodes[4].point = ~0u;
  refuse(damaged_, "no point");
}

TEST_F(RefineDamage, Children) {
  for (std::uint32_t s = 0; s <= splits(); ++s) {
    for (const std::uint32_t to : {0u, splits() / 2, splits() - 1, splits() + 1, ~0u}) {
      RefineRecords damaged = one_.records;
      if (damaged.nodes[s].first_child != to) {
        damaged.nodes[s].first_child = to;
        refuse(damaged, "list of their parent");
      }
      damaged = one_.records;
      if (s < splits() && damaged.nodes[s].next_sibling != to) {
        damaged.nodes[s].next_sibling = to;
        refuse(damaged, "list of their parent");
      }
    }
  }
}

TEST_F(RefineDamage, Needs) {
  for (std::uint32_t s = 0; s < splits(); ++s) {
    const foredraw_refine_node* node = &one_.records.nodes[s];
    for (std::uint32_t i = node[0].first_need; i < node[1].first_need; ++i) {
      RefineRecords damaged = one_.records;
      damaged.needs[i] = s;
      refuse(damaged, "come before");
      damaged = one_.records;
      damaged.needs.erase(damaged.needs.begin() + i);
      for (std::uint32_t later = s + 1; later <= splits(); ++later) --damaged.nodes[later].first_need;
      refuse(damaged, "does not need");
      if (i + 1 == node[1].first_need) continue;
      damaged = one_.records;
      std::swap(damaged.needs[i], damaged.needs[i + 1]);
      refuse(damaged, "rise");
    }
  }
}

TEST_F(RefineDamage, Counts) {
  damaged_.progressive.splits[3].first_patch = ~0u;
  refuse(damaged_, "fall");
  damaged_ = one_.records;
  damaged_.progressive.splits[3].triangles = ~0u;
  refuse(damaged_, "fall");
  damaged_ = one_.records;
  damaged_.nodes[3].first_need = ~0u;
  refuse(damaged_, "fall");
  damaged_ = one_.records;
  damaged_.nodes[splits()].first_need += 1;
  refuse(damaged_, "do not end");
  damaged_ = one_.records;
  damaged_.progressive.splits[splits()].first_patch += 1;
  refuse(damaged_, "do not end");
  damaged_ = one_.records;
  damaged_.points = splits() - 1;
  refuse(damaged_, "fewer points");
  damaged_ = one_.records;
  damaged_.progressive.splits[0].first_patch = 1;
  refuse(damaged_, "begin at 0");
}

TEST_F(RefineDamage, Patches) {
  foredraw_patch& patch = damaged_.progressive.patches[5];
  const foredraw_patch sound = patch;
  patch.corner = ~0u;
  refuse(damaged_, "triangle that is not there");
  patch.corner = static_cast<std::uint32_t>(damaged_.corners.size()) - 1;
  refuse(damaged_, "triangle that is not there");
  patch = sound;
  patch.fine = ~0u;
  refuse(damaged_, "vertex that is not there");
  patch = sound;
  patch.coarse = patch.coarse == 0 ? 1 : 0;
  refuse(damaged_, "vertex that is not there");
  patch = sound;
  patch.fine = patch.fine == 0 ? 1 : 0;
  refuse(damaged_, "another point");
}

TEST_F(RefineDamage, Vertices) {
  damaged_.point[2] = damaged_.points;
  refuse(damaged_, "of no point");
  damaged_ = one_.records;
  damaged_.corners[7] = static_cast<std::uint32_t>(damaged_.point.size());
  refuse(damaged_, "no vertex");
  damaged_ = one_.records;
  damaged_.corners[0] = static_cast<std::uint32_t>(damaged_.point.size()) - 1;
  refuse(damaged_, "base has a point");
}

/// Every wing, in the place of which stands a point of the base that is elsewhere.
TEST_F(RefineDamage, Wings) {
  const std::vector<std::uint32_t>& point = one_.records.point;
  std::vector<std::uint32_t> base;  // its vertices
  for (std::uint32_t v = 0; v < point.size(); ++v) {
    if (point[v] >= splits()) base.push_back(v);
  }
  ASSERT_GT(base.size(), 4u);
  int refused = 0, tried = 0;
  for (std::uint32_t s = 0; s < splits(); ++s) {
    for (std::uint32_t t = one_.records.progressive.splits[s].triangles;
         t < one_.records.progressive.splits[s + 1].triangles; ++t) {
      for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
        const std::uint32_t was = point[one_.records.corners[corner]];
        if (was == s) {
          RefineRecords damaged = one_.records;
          damaged.corners[corner] = base.front();
          refuse(damaged, "does not lie at the split edge");
        }
        if (was == s || was == one_.records.nodes[s].point) continue;
        RefineRecords damaged = one_.records;
        damaged.corners[corner] = static_cast<std::uint32_t>(point.size()) - 1;
        if (point[damaged.corners[corner]] > s) refuse(damaged, "does not need its wing");
        for (const std::uint32_t vertex : base) {
          damaged.corners[corner] = vertex;
          ++tried;
          const char* told = mistake(damaged);
          refused += told != nullptr && std::string(told).find("wing is not beside") != std::string::npos;
        }
      }
    }
  }
  EXPECT_GT(refused, tried / 3) << tried;  // the others may be beside it
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

/// One number of some array is another one: it is refused, or does no harm.
TEST(RefineCheck, WhatItLetsThroughStaysWithinItsArrays) {
  const Refined sound(testing::closed_torus(8, 6));
  Random random(3);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    RefineRecords damaged = sound.records;
    const auto damage = [&](auto& values) {
      using Value = std::decay_t<decltype(values[0])>;
      auto* bytes = reinterpret_cast<std::byte*>(values.data());
      const std::size_t words = values.size() * sizeof(Value) / 4, at = random.below(words);
      std::uint32_t word = 0;
      std::memcpy(&word, bytes + 4 * at, 4);
      word = random.below(4) == 0 ? static_cast<std::uint32_t>(random.next()) : word + 2 - random.below(5);
      std::memcpy(bytes + 4 * at, &word, 4);
    };
    switch (round % 6) {
      case 0: damage(damaged.progressive.splits); break;
      case 1: damage(damaged.progressive.patches); break;
      case 2: damage(damaged.corners); break;
      case 3: damage(damaged.needs); break;
      case 4: damage(damaged.nodes); break;
      case 5: damage(damaged.point); break;
    }
    if (mistake(damaged) != nullptr) {
      ++refused;
      continue;
    }
    const foredraw_refine_mesh mesh = damaged.mesh();
    std::vector<std::uint32_t> memory(foredraw_refine_words(&mesh));
    foredraw_refinement state;
    foredraw_refine_begin(&state, &mesh, memory.data());
    for (int step = 0; step < 200; ++step) {
      const auto split = static_cast<std::uint32_t>(random.below(mesh.split_count));
      if (random.below(3) == 0) {
        foredraw_refine_split(&state, split, 5);
      } else {
        foredraw_refine_collapse(&state, split);
      }
      for (std::uint32_t i = 0; i < 3 * state.triangles; ++i) ASSERT_LT(state.indices[i], damaged.point.size());
    }
  }
  EXPECT_GT(refused, 1000);
}

/// A ball seen from the right.
class RefineView : public ::testing::Test {
 protected:
  RefineView() {
    view_.eye[0] = 4;
    view_.pixels = 1000;
    for (auto& split : one_.records.progressive.splits) split.error = 1e-4f * (split.triangles < 400 ? 40.0f : 1.0f);
  }

  void look() {
    one_.settle([&](std::uint32_t split) { return foredraw_refine_view_wants(&view_, &one_.arrays, split) != 0; });
  }
  /// Triangles whose middle is in a slice of the ball across the line of sight.
  int in_slice(float from, float to) const {
    const TestMesh left = one_.surface();
    int count = 0;
    for (std::size_t i = 0; i < left.indices.size(); i += 3) {
      const float x = (left.positions[left.indices[i]].x + left.positions[left.indices[i + 1]].x +
                       left.positions[left.indices[i + 2]].x) /
                      3;
      count += x >= from && x < to;
    }
    return count;
  }

  Refined one_{testing::sphere(64, 48)};
  foredraw_refine_view view_{};
};

TEST_F(RefineView, BackSidesStayCoarse) {
  view_.surface = view_.silhouette = 1e-6f;
  look();
  const int front = in_slice(0.3f, 1), back = in_slice(-1, -0.4f);
  EXPECT_GT(front, 10 * back);
  view_.back_sides = 1;
  look();
  EXPECT_EQ(one_.state.done, one_.splits());
}

TEST_F(RefineView, OutlinesAreFiner) {
  view_.surface = 1.0f;
  view_.silhouette = 0.005f;
  look();
  const int outline = in_slice(0.1f, 0.4f), middle = in_slice(0.7f, 1);
  EXPECT_GT(outline, 2 * middle) << middle;
  view_.silhouette = view_.surface;
  look();
  EXPECT_LT(in_slice(0.1f, 0.4f), outline);
}

TEST_F(RefineView, WhatIsOutsideOfTheFrustumStaysCoarse) {
  view_.surface = view_.silhouette = 1e-6f;
  view_.back_sides = 1;
  view_.planes[2][0] = 1;  // x >= 0.5
  view_.planes[2][3] = -0.5f;
  look();
  EXPECT_GT(in_slice(0.5f, 1), 8 * in_slice(-1, -0.5f));
  EXPECT_LT(one_.state.done, one_.splits());
}

TEST_F(RefineView, FartherAwayIsCoarser) {
  view_.surface = view_.silhouette = 0.05f;
  view_.back_sides = 1;
  std::uint32_t before = ~0u;
  for (const float away : {2.0f, 8.0f, 60.0f, 200.0f}) {
    view_.eye[0] = away;
    look();
    EXPECT_LE(one_.state.triangles, before);
    before = one_.state.triangles;
  }
  EXPECT_EQ(one_.state.done, 0u);
}

}  // namespace
}  // namespace foredraw
