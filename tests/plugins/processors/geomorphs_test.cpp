#include "plugins/processors/geomorphs/geomorphs.h"

#include "plugins/processors/geomorphs/geomorph_product.h"
#include "plugins/processors/levels/levels.h"
#include "plugins/processors/quadric_collapse/quadric_collapse.h"
#include "support/meshes.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/runtime/geomorph.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>

namespace foredraw::geomorphs_test {
namespace {

using ::testing::HasSubstr;

Scene collapsing(const testing::TestMesh& mesh, CollapsePlacement placement) {
  Scene scene = testing::scene_of(mesh);
  Analyses analyses;
  const JoinedMesh joined = *joined_mesh(scene, std::vector<DrawId>{0}, analyses);
  auto sequence = std::make_shared<const CollapseSequence>(
      quadric_collapse(joined.positions, joined.indices, {.placement = placement}));
  scene.draws[0].full().made.add(traits::progressive);
  scene.products.set(CollapseSequences{{{{0}, std::move(sequence)}}});
  return scene;
}

/// A torus of two sides: a seam all around, with a vertex at each side of it.
testing::TestMesh seamed() {
  testing::TestMesh torus = testing::torus(48, 24);
  std::vector<std::uint32_t> twin(torus.positions.size(), no_vertex);
  for (std::size_t i = torus.indices.size() / 6 * 3; i < torus.indices.size(); ++i) {
    std::uint32_t& v = torus.indices[i];
    if (twin[v] == no_vertex) {
      twin[v] = static_cast<std::uint32_t>(torus.positions.size());
      torus.positions.push_back(glm::vec3(torus.positions[v]));
    }
    v = twin[v];
  }
  return torus;
}

/// A torus in small patches, each of its own vertices.
testing::TestMesh patched() {
  testing::TestMesh torus = testing::torus(48, 24), apart = torus;
  apart.positions.clear();
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> vertex;  // of a patch and a vertex before
  for (std::uint32_t i = 0; i < torus.indices.size(); ++i) {
    const auto [found, is_new] = vertex.try_emplace({i / 36, torus.indices[i]}, apart.positions.size());
    if (is_new) apart.positions.push_back(torus.positions[torus.indices[i]]);
    apart.indices[i] = found->second;
  }
  return apart;
}

class GeomorphsTest : public ::testing::TestWithParam<CollapsePlacement> {
 protected:
  bool run(const Plugin& plugin, Scene& scene, const Settings& settings = {}) {
    fixture_ = std::make_unique<testing::RunFixture>();
    const Technique technique = plugin.create(settings);
    std::get<std::unique_ptr<Processor>>(technique)->process(scene, {0}, fixture_->run);
    return !fixture_->run.keeps();
  }

  Scene morphing(const testing::TestMesh& mesh) {
    Scene scene = collapsing(mesh, GetParam());
    EXPECT_TRUE(run(levels_plugin(), scene, {{"keep-sequences", true}, {"ratios", "0.5, 0.2, 0.05"}}));
    EXPECT_TRUE(run(geomorphs_plugin(), scene));
    return scene;
  }

  std::unique_ptr<testing::RunFixture> fixture_;
};

/// As sets of corners: two triangles are equal that lie at the same places, to the bit, begun anywhere.
using Places = std::array<std::array<float, 3>, 3>;
std::multiset<Places> drawn(const std::vector<float>& positions, std::span<const std::uint32_t> indices) {
  std::multiset<Places> all;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Places places;
    for (std::size_t k = 0; k < 3; ++k) std::memcpy(&places[k], &positions[3 * indices[i + k]], sizeof places[k]);
    if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) continue;
    std::ranges::rotate(places, std::ranges::min_element(places));
    all.insert(places);
  }
  return all;
}

std::vector<float> floats(const Level& level) {
  Analyses analyses;
  std::vector<float> values;
  for (const glm::vec3& p : positions_of(analyses, *level.vertices)->values) {
    values.insert(values.end(), {p.x, p.y, p.z});
  }
  return values;
}

/// What an engine does: at 0 the level is drawn, at 1 the next one, and between the two no vertex leaves its way.
TEST_P(GeomorphsTest, BeginAsTheLevelAndEndAsTheNextOne) {
  for (const testing::TestMesh& mesh : {testing::torus(48, 24), seamed(), testing::sphere(48, 24)}) {
    const Scene scene = morphing(mesh);
    const Draw& draw = scene.draws[0];
    ASSERT_EQ(draw.levels.size(), 4u);
    const auto& ancestors = scene.products.find<Geomorphs>()->draws[0].ancestors;
    ASSERT_EQ(ancestors.size(), 3u);
    for (std::size_t l = 0; l < 3; ++l) {
      const std::vector<float> fine = floats(draw.levels[l]), coarse = floats(draw.levels[l + 1]);
      const auto blended = [&](float alpha) {
        std::vector<float> positions(fine.size());
        for (std::size_t v = 0; v < fine.size() / 3; ++v) {
          foredraw_geomorph(&fine[3 * v], &coarse[3 * ancestors[l].view()[v]], alpha, 3, &positions[3 * v]);
        }
        return positions;
      };
      const auto indices = draw.levels[l].stream().indices.view();
      EXPECT_EQ(drawn(blended(0), indices), drawn(fine, indices));
      EXPECT_EQ(drawn(blended(1), indices), drawn(coarse, draw.levels[l + 1].stream().indices.view()));
    }
  }
}

/// Ancestors of ancestors: from full detail to a level that is not the next one, all at once.
TEST_P(GeomorphsTest, GoToAnyCoarserLevel) {
  for (const testing::TestMesh& mesh : {testing::torus(48, 24), seamed()}) {
    const Scene scene = morphing(mesh);
    const Draw& draw = scene.draws[0];
    const auto& ancestors = scene.products.find<Geomorphs>()->draws[0].ancestors;
    std::vector<std::uint32_t> chain(ancestors[0].view().begin(), ancestors[0].view().end());
    for (std::size_t coarse = 2; coarse < draw.levels.size(); ++coarse) {
      foredraw_geomorph_chain(chain.data(), ancestors[coarse - 1].view().data(),
                              static_cast<std::uint32_t>(chain.size()), chain.data());
      const std::vector<float> from = floats(draw.levels[0]), to = floats(draw.levels[coarse]);
      std::vector<float> end(from.size());
      for (std::size_t v = 0; v < chain.size(); ++v) {
        float half[3];
        foredraw_geomorph(&from[3 * v], &to[3 * chain[v]], 1, 3, &end[3 * v]);
        foredraw_geomorph(&from[3 * v], &to[3 * chain[v]], 0.5f, 3, half);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(half[k], (from[3 * v + k] + end[3 * v + k]) / 2, 1e-6);
      }
      EXPECT_EQ(drawn(end, draw.levels[0].stream().indices.view()),
                drawn(to, draw.levels[coarse].stream().indices.view()));
    }
  }
}

/// Else a seam would open on the way, though it is closed at both ends.
TEST_P(GeomorphsTest, VerticesAtOnePlaceGoToOnePlace) {
  for (const testing::TestMesh& mesh : {seamed(), patched()}) {
    const Scene scene = morphing(mesh);
    const Draw& draw = scene.draws[0];
    for (std::size_t l = 0; l + 1 < draw.levels.size(); ++l) {
      Analyses analyses;
      const auto fine = positions_of(analyses, *draw.levels[l].vertices)->values;
      const auto coarse = positions_of(analyses, *draw.levels[l + 1].vertices)->values;
      const auto ancestors = ancestors_of(scene, {0, l});
      const std::vector<std::uint32_t> point = welded(fine);
      std::size_t apart = 0;
      for (const std::uint32_t v : draw.levels[l].stream().indices.view()) {
        apart += coarse[ancestors[v]] == coarse[ancestors[point[v]]] ? 0 : 1;
      }
      EXPECT_EQ(apart, 0u) << "level " << l;
    }
  }
}

TEST_P(GeomorphsTest, AncestorsStayOnTheirSideOfASeam) {
  const testing::TestMesh mesh = seamed();
  const Scene scene = morphing(mesh);
  const Draw& draw = scene.draws[0];
  const auto sides_of = [&](std::size_t l) {
    const auto indices = draw.levels[l].stream().indices.view();
    std::vector<std::uint32_t> first(draw.levels[l].vertices->count);
    std::iota(first.begin(), first.end(), 0u);
    for (bool again = true; again;) {  // vertices that triangles join are of one side
      again = false;
      for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t least = std::min({first[indices[i]], first[indices[i + 1]], first[indices[i + 2]]});
        for (std::size_t k = i; k < i + 3; ++k) {
          again = again || first[indices[k]] != least;
          first[indices[k]] = least;
        }
      }
    }
    return first;
  };
  for (std::size_t l = 0; l < 3; ++l) {
    const std::vector<std::uint32_t> fine = sides_of(l), coarse = sides_of(l + 1);
    const auto ancestors = scene.products.find<Geomorphs>()->draws[0].ancestors[l].view();
    std::map<std::uint32_t, std::set<std::uint32_t>> ends;
    for (const std::uint32_t v : draw.levels[l].stream().indices.view()) ends[fine[v]].insert(coarse[ancestors[v]]);
    std::set<std::uint32_t> all;
    for (const auto& [from, to] : ends) {
      EXPECT_EQ(to.size(), 1u) << "a side ends on two";
      all.insert(to.begin(), to.end());
    }
    EXPECT_EQ(all.size(), ends.size());
  }
}

TEST_P(GeomorphsTest, AreProvedAndFollowTheirVertices) {
  Scene scene = morphing(testing::torus(24, 12));
  const auto row = geomorph_product();
  EXPECT_EQ(row->difference(scene), "");
  EXPECT_EQ(row->told(scene).lines.size(), 1u);
  const auto damaged = [&](auto damage) {
    Scene other = scene;
    Geomorphs geomorphs = *scene.products.find<Geomorphs>();
    damage(geomorphs.draws[0]);
    other.products.set(geomorphs);
    return row->difference(other);
  };
  EXPECT_THAT(damaged([](DrawGeomorph& draw) { draw.ancestors.pop_back(); }), HasSubstr("number of levels"));
  EXPECT_THAT(damaged([](DrawGeomorph& draw) { draw.draw = 9; }), HasSubstr("gone"));
  EXPECT_THAT(damaged([](DrawGeomorph& draw) {
                std::vector<std::uint32_t> less(draw.ancestors[0].view().begin(), draw.ancestors[0].view().end() - 1);
                draw.ancestors[0] = Shared<std::uint32_t>(less);
              }),
              HasSubstr("one ancestor for each vertex"));
  EXPECT_THAT(damaged([](DrawGeomorph& draw) {
                std::vector<std::uint32_t> other(draw.ancestors[1].view().begin(), draw.ancestors[1].view().end());
                other[0] = 1'000'000;
                draw.ancestors[1] = Shared<std::uint32_t>(other);
              }),
              HasSubstr("not there"));
  EXPECT_THAT(damaged([](DrawGeomorph& draw) {
                std::vector<std::uint32_t> other(draw.ancestors[0].view().begin(), draw.ancestors[0].view().end());
                std::ranges::rotate(other, other.begin() + 1);
                draw.ancestors[0] = Shared<std::uint32_t>(other);
              }),
              HasSubstr("does not end as the next level"));
}

TEST_P(GeomorphsTest, NeedTheSequenceThatLevelsWereCutFrom) {
  Scene used_up = collapsing(testing::torus(24, 12), GetParam());
  run(levels_plugin(), used_up);
  EXPECT_FALSE(run(geomorphs_plugin(), used_up));
  EXPECT_THAT(*fixture_->findings.nothing_to_gain, HasSubstr("keep-sequences = true"));
  Scene ordered = collapsing(testing::torus(24, 12), GetParam());
  run(levels_plugin(), ordered, {{"keep-sequences", true}});
  IndexStream& stream = ordered.draws[0].levels[1].stream();
  std::vector<std::uint32_t> turned(stream.indices.view().begin(), stream.indices.view().end());
  std::rotate(turned.begin(), turned.begin() + 3, turned.end());
  stream.indices = Shared<std::uint32_t>(turned);
  run(geomorphs_plugin(), ordered);
  EXPECT_EQ(ordered.products.find<Geomorphs>(), nullptr);
  EXPECT_EQ(ordered.products.find<CollapseSequences>(), nullptr) << "it is used up, whatever came of it";
  ASSERT_EQ(fixture_->findings.notes.size(), 1u);
  EXPECT_EQ(fixture_->findings.notes[0].code, "other-levels");
}

INSTANTIATE_TEST_SUITE_P(Placements, GeomorphsTest,
                         ::testing::Values(CollapsePlacement::optimal, CollapsePlacement::endpoint));

}  // namespace
}  // namespace foredraw::geomorphs_test
