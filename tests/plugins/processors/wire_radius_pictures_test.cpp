// What was found, in pictures: where a wire joins something that stays as it is.
#include "plugins/processors/wire_radius/wire_radius.h"

#include "benchmarks/wire_radius/wire_sets.h"
#include "support/thin_scenes.h"

#include <foredraw/frames/sampled_picture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::wire_radius_pictures_test {
namespace {

constexpr FrameSize size{72, 72};

/// The lamp post so large that its radius is so many pixels, a little tilted, with its head in the middle.
testing::ThinMesh lamp_post(double pixels) {
  const auto all = bench::made_meshes(201);
  const bench::KnownMesh mesh = *std::ranges::find(all, "lamp post", &bench::KnownMesh::name);
  const FoundWires found = find_wires(mesh.positions, mesh.indices);
  EXPECT_EQ(found.wires.size(), 1u);
  const double scale = pixels / found.wires[0].radius, c = std::cos(0.3), s = std::sin(0.3);
  const auto turned = [&](const glm::vec3& v) {
    const glm::dvec3 at = scale * glm::dvec3(v);
    return glm::vec3(c * at.x - s * at.y, s * at.x + c * at.y, at.z);
  };
  float top = 0;
  for (const glm::vec3& at : mesh.positions) top = std::max(top, at.y);
  testing::ThinMesh made;
  made.indices = mesh.indices;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    made.positions.push_back(turned(mesh.positions[v] - glm::vec3(0, top - 0.3f, 0)) + glm::vec3(0.3f, 0.2f, 0));
    made.wires.emplace_back(turned(found.to_centre[v]), static_cast<float>(scale) * found.half_width[v]);
    made.axes.emplace_back(turned(found.axis[v]) / static_cast<float>(scale), 0);
  }
  return made;
}

SampledPicture drawn(const testing::ThinMesh& mesh, FrameWires wires, int samples, std::span<const glm::dvec2> places) {
  const Scene scene = testing::scene_of(mesh, {0, 0, 0}, true);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const DrawnObject object{0, 0, Rendering::unlit};
  return sampled_picture(frames, frame_moment(frames, 0), testing::pixel_camera(size), size, std::span(&object, 1),
                         places,
                         {.wires = wires, .wire_samples = samples, .marks_wires = true, .shades_middles = true});
}

/// From two pixels a half width to a fiftieth: nowhere does the ground show through what is whole, and the post is
/// there in every row. What is no wire, as foot and head, may still fall between samples where it is thin.
TEST(WireRadiusPictures, ALampPostHasNoCrackAtItsHeadFromAnyDistance) {
  for (const double pixels : {2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.1, 0.05, 0.02}) {
    const testing::ThinMesh mesh = lamp_post(pixels);
    const SampledPicture truth = drawn(mesh, FrameWires::as_they_are, 1, hammersley_places(256, false));
    const glm::vec3 ground = truth.picture.colours.front(), lamp(0);
    const auto share = [&](const SampledPicture& picture, std::size_t pixel) {
      return glm::distance(picture.picture.colours[pixel], ground) / glm::distance(lamp, ground);
    };
    for (const FrameWires wires : {FrameWires::widened, FrameWires::covering}) {
      for (const int samples : {1, 4}) {
        SCOPED_TRACE(::testing::Message()
                     << pixels << " pixels, " << samples << " samples, way " << static_cast<int>(wires));
        const SampledPicture picture = drawn(mesh, wires, samples, standard_places(samples));
        int cracks = 0, gaps = 0;
        for (int y = 2; y + 2 < size.height; ++y) {
          double is = 0, wanted = 0, of_post = 0;
          for (int x = 0; x < size.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y * size.width + x);
            cracks += share(truth, pixel) > 0.999f && share(picture, pixel) < 0.9f;
            // Of the row, and of those beside it, as samples may lie in either.
            for (const int row : {-1, 0, 1}) {
              const auto near = pixel + static_cast<std::size_t>(row * size.width);
              is += static_cast<double>(share(picture, near));
              wanted += static_cast<double>(share(truth, near));
              of_post += static_cast<double>(truth.wires[near]);
            }
          }
          gaps += of_post > 0.9 * wanted && wanted > 0.03 && is < 0.5 * wanted;
        }
        EXPECT_EQ(cracks, 0);
        EXPECT_EQ(gaps, 0);
      }
    }
  }
}

}  // namespace
}  // namespace foredraw::wire_radius_pictures_test
