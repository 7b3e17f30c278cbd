// Real models without what is hidden look the same: pictures from views, and in poses, that decided nothing.

#include "corpus_run.h"

#include "support/meshes.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_directions.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace foredraw::hidden_pictures_test {
namespace {

struct Case {
  const char* name;
  const char* model;
  const char* stage;
  SubjectUnit subjects;
  std::size_t fewest_hidden;  ///< triangles: or the test would ask nothing
};

std::vector<std::uint32_t> nearest_depths(const SubjectGeometry& drawn, const View& view, int size) {
  std::vector<std::uint32_t> nearest(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                                     ~std::uint32_t{0});
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

struct Changed {
  std::size_t shown = 0, changed = 0;
};

/// Every key of every clip may be drawn, by a seed.
Changed changed_pixels(const Scene& before, const Scene& after, SubjectUnit unit, int pictures, int size) {
  Changed sum;
  Analyses analyses(image_decoder({}));
  const Poses poses = make_poses(before, {.poses = "all"});
  Random random(20261124);
  const std::vector<Subject> subjects = subjects_of(before, unit);
  for (const Subject& subject : subjects) {
    for (const glm::dvec3& direction : random_directions(static_cast<std::size_t>(pictures), random.next())) {
      const View view{direction, random.below(3) == 0 ? 1.3 + 2 * random.unit() : 0};
      const Pose pose = poses.poses[random.below(poses.poses.size())];
      const auto of = [&](const Scene& scene) {
        const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene, pose) : PosedNodes();
        return nearest_depths(subject_geometry(scene, subject, Faces::material, nodes, analyses), view, size);
      };
      const auto whole = of(before), cut = of(after);
      for (std::size_t pixel = 0; pixel < whole.size(); ++pixel) {
        sum.shown += whole[pixel] != ~std::uint32_t{0};
        sum.changed += whole[pixel] != cut[pixel];
      }
    }
  }
  return sum;
}

std::size_t triangles(const Scene& scene) {
  std::size_t sum = 0;
  for (const Draw& draw : scene.draws) sum += draw.full().stream().triangle_count();
  return sum;
}

Scene without_hidden(const Scene& scene, const std::string& stage, SubjectUnit subjects) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  auto pipeline = parse_line(stage, diagnostics);
  pipeline->subjects.subject = subjects;
  pipeline->measure = *parse_stages("vertex-cache", "measure", diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, scene, diagnostics);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(2);
  Analyses analyses(image_decoder({}));
  return foredraw::optimize(*plan, scene, {executor, analyses}).scene;
}

void expect_no_pixel_changes(const Case& one, int pictures, int size) {
  const Scene before = testing::read_model(testing::project_file(std::string("benchmarks/corpus/") + one.model));
  const Scene after = without_hidden(before, one.stage, one.subjects);
  const std::size_t gone = triangles(before) - triangles(after);
  const Changed found = changed_pixels(before, after, one.subjects, pictures, size);
  std::printf("%s: %zu of %zu triangles hidden; of %zu pixels %zu changed\n", one.name, gone, triangles(before),
              found.shown, found.changed);
  EXPECT_EQ(found.changed, 0u);
  EXPECT_GE(gone, one.fewest_hidden);
}

class HiddenPictures : public ::testing::TestWithParam<Case> {};

TEST_P(HiddenPictures, ShowTheSame) { expect_no_pixel_changes(GetParam(), 300, 512); }

constexpr const char* by_triangles = "hidden(seen-from=outside, unit=triangle)";
constexpr const char* in_clips = "hidden(seen-from=outside, moving=clips)";
constexpr const char* by_triangles_in_clips = "hidden(seen-from=outside, moving=clips, unit=triangle)";

INSTANTIATE_TEST_SUITE_P(
    LargeModels, HiddenPictures,
    ::testing::Values(Case{"helmet", "static/flight_helmet_notex.glb", by_triangles, SubjectUnit::character, 100},
                      Case{"helmet_whole", "static/flight_helmet_notex.glb", by_triangles, SubjectUnit::scene, 1000},
                      Case{"ship", "static/dutch_ship_medium_notex.glb", by_triangles, SubjectUnit::character, 0},
                      Case{"house", "scenes/house.glb", by_triangles, SubjectUnit::character, 0},
                      Case{"head", "static/head.glb", by_triangles, SubjectUnit::character, 100},
                      Case{"knight", "animated/kaykit_knight.glb", in_clips, SubjectUnit::character, 1},
                      Case{"knight_by_triangles", "animated/kaykit_knight.glb", by_triangles_in_clips,
                           SubjectUnit::character, 1}),
    [](const auto& one) { return one.param.name; });

/// Prints how many pixels change as samples grow: docs/guides/hidden.md has the table.
class HiddenBySamples : public ::testing::TestWithParam<Case> {};

TEST_P(HiddenBySamples, FewerPixelsChange) {
  const Scene before = testing::read_model(testing::project_file(std::string("benchmarks/corpus/") + GetParam().model));
  std::size_t changed = 0;
  for (const char* samples :
       {"views=42, rays=0, checks=1", "views=162, rays=0, checks=1", "views=642, rays=0, checks=1",
        "views=642, rays=1024, checks=1", "views=642, rays=1024, checks=300"}) {
    const std::string stage = std::string("hidden(seen-from=outside, unit=triangle, ") + samples + ")";
    const Scene after = without_hidden(before, stage, GetParam().subjects);
    const Changed found = changed_pixels(before, after, GetParam().subjects, 200, 512);
    std::printf("%s, %s: %zu triangles hidden; of %zu pixels %zu changed\n", GetParam().name, samples,
                triangles(before) - triangles(after), found.shown, found.changed);
    changed = found.changed;
  }
  EXPECT_EQ(changed, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    LargeModels, HiddenBySamples,
    ::testing::Values(Case{"head", "static/head.glb", "", SubjectUnit::character, 0},
                      Case{"ship", "static/dutch_ship_medium_notex.glb", "", SubjectUnit::character, 0},
                      Case{"helmet_whole", "static/flight_helmet_notex.glb", "", SubjectUnit::scene, 0}),
    [](const auto& one) { return one.param.name; });

TEST(HiddenPicturesOfOne, ShowTheSame) {
  expect_no_pixel_changes({"head", "static/head.glb", "hidden(seen-from=outside, unit=triangle, views=162, size=256)",
                           SubjectUnit::character, 100},
                          30, 256);
}

}  // namespace
}  // namespace foredraw::hidden_pictures_test
