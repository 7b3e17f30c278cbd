// Real models drawn with fewer sides look the same: pictures from views, and at times, that decided nothing.

#include "corpus_run.h"

#include "support/meshes.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_directions.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw {
namespace {

constexpr std::uint32_t nothing = ~std::uint32_t{0};

std::vector<std::uint32_t> depths(const SubjectGeometry& drawn, const View& view, int size) {
  std::vector<std::uint32_t> nearest(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), nothing);
  Rasteriser rasteriser;
  for (const PreparedPart& part : prepared(drawn.parts)) {
    rasteriser.draw(part, Camera(view, size), [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        nearest[some.pixels[i]] = std::min(nearest[some.pixels[i]], some.depths[i]);
      }
    });
  }
  return nearest;
}

struct Difference {
  std::size_t shown = 0, lost = 0, moved = 0;
};

/// A moment of any clip, anywhere in it.
Pose any_pose(const Scene& scene, Random& random) {
  if (scene.animations.empty()) return {};
  const auto clip = static_cast<AnimationId>(random.below(scene.animations.size()));
  double end = 0;
  for (const AnimationChannel& channel : scene.animations[clip].channels) {
    if (!channel.times.empty()) end = std::max(end, static_cast<double>(channel.times.view().back()));
  }
  return {clip, end * random.unit()};
}

Difference difference(const Scene& before, const Scene& after, int pictures, int size) {
  Difference sum;
  Random random(20261123);
  Analyses analyses;
  const std::vector<Subject> was = subjects_of(before), is = subjects_of(after);
  EXPECT_EQ(was.size(), is.size());
  const Directions directions = random_directions(static_cast<std::size_t>(pictures), 77);
  for (std::size_t s = 0; s < was.size(); ++s) {
    for (const glm::dvec3& direction : directions) {
      const Pose pose = any_pose(before, random);
      const auto of = [&](const Scene& scene, const Subject& subject) {
        const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene, pose) : PosedNodes();
        const SubjectGeometry drawn = subject_geometry(scene, subject, Faces::material, nodes, analyses);
        return depths(drawn, {direction}, size);
      };
      const auto whole = of(before, was[s]), kept = of(after, is[s]);
      for (std::size_t pixel = 0; pixel < whole.size(); ++pixel) {
        if (whole[pixel] == nothing) continue;
        ++sum.shown;
        sum.lost += kept[pixel] == nothing;
        sum.moved += kept[pixel] != nothing && kept[pixel] - whole[pixel] > 64;
      }
      if (!was[s].is_placed() && !before.animations.empty()) break;
    }
  }
  return sum;
}

struct Case {
  const char* model;
  double most;  ///< pixels lost or moved, of a million that show something
};

void expect_the_same_look(const Case& one, int pictures, int size, const std::string& options = "") {
  const Scene before = testing::read_model(testing::project_file(std::string("benchmarks/corpus/") + one.model));
  const Scene after = testing::run_pipeline("sides" + options, before, 2).scene;
  const Difference found = difference(before, after, pictures, size);
  std::printf("%s: of %zu pixels %zu lost, %zu moved\n", one.model, found.shown, found.lost, found.moved);
  EXPECT_LE(static_cast<double>(found.lost + found.moved), one.most * 1e-6 * static_cast<double>(found.shown));
}

class SidesPictures : public ::testing::TestWithParam<Case> {};

TEST_P(SidesPictures, ShowTheSame) { expect_the_same_look(GetParam(), 300, 512); }

INSTANTIATE_TEST_SUITE_P(LargeModels, SidesPictures,
                         ::testing::Values(Case{"static/flight_helmet_notex.glb", 10},
                                           Case{"static/dutch_ship_medium_notex.glb", 30},
                                           Case{"static/chess_board_notex.glb", 30},
                                           Case{"animated/kaykit_knight.glb", 3}, Case{"animated/mannequiny.glb", 3}));

TEST(SidesPicturesOfFew, ShowTheSame) { expect_the_same_look({"animated/mannequiny.glb", 1}, 30, 256, "(checks=60)"); }

}  // namespace
}  // namespace foredraw
