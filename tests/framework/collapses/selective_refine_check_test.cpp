#include <foredraw/runtime/selective_refine_check.h>

#include "support/refined.h"

#include <cstring>

namespace foredraw::selective_refine_check_test {
namespace {

using testing::Refined;
using testing::surfaces;
using testing::TestMesh;

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
      EXPECT_STREQ(mistake(Refined(meshes[i], seed, false).records), nullptr) << i;
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
  refuse(damaged_, "to no point");
  damaged_ = one_.records;
  damaged_.corners[7] = static_cast<std::uint32_t>(damaged_.point.size());
  refuse(damaged_, "no vertex");
  damaged_ = one_.records;
  damaged_.corners[0] = static_cast<std::uint32_t>(damaged_.point.size()) - 1;
  refuse(damaged_, "base has a point");
}

/// Every wing, in the place of which stands another point that is there.
TEST_F(RefineDamage, Wings) {
  const std::vector<std::uint32_t>& point = one_.records.point;
  std::vector<std::uint32_t> base;  // its vertices
  for (std::uint32_t v = 0; v < point.size(); ++v) {
    if (point[v] >= splits()) base.push_back(v);
  }
  ASSERT_GT(base.size(), 4u);
  for (std::uint32_t s = 0; s < splits(); ++s) {
    for (std::uint32_t t = one_.records.progressive.splits[s].triangles;
         t < one_.records.progressive.splits[s + 1].triangles; ++t) {
      for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
        const std::uint32_t was = point[one_.records.corners[corner]];
        RefineRecords damaged = one_.records;
        if (was == s) {
          damaged.corners[corner] = base.front();
          refuse(damaged, "does not lie at the split edge");
        }
        if (was == s || was == one_.records.nodes[s].point) continue;
        damaged.corners[corner] = static_cast<std::uint32_t>(point.size()) - 1;
        if (point[damaged.corners[corner]] > s) refuse(damaged, "does not need its wing");
        for (const std::uint32_t vertex : base) {
          if (vertex == one_.records.corners[corner]) continue;
          damaged.corners[corner] = vertex;
          EXPECT_NE(mistake(damaged), nullptr) << "split " << s << ", vertex " << vertex;
        }
      }
    }
  }
}

TEST_F(RefineDamage, Borders) {
  EXPECT_EQ(damaged_.borders, 0u);
  EXPECT_EQ(Refined(testing::grid(3, 2)).records.borders, 10u);
  damaged_.borders = 2;
  refuse(damaged_, "borders");
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

}  // namespace
}  // namespace foredraw::selective_refine_check_test
