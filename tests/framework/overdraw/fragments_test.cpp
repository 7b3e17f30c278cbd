#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/mask.h>

#include "support/exact_fragments.h"
#include "support/painter.h"
#include "support/vector_widths.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace foredraw::fragments_test {
namespace {

using testing::part_of;
using testing::TestMesh;

struct Fragment {
  std::uint32_t triangle, pixel, depth;

  friend auto operator<=>(const Fragment&, const Fragment&) = default;
};

std::vector<Fragment> drawn_in_turn(std::span<const PreparedPart> parts, const View& view, int size) {
  Rasteriser rasteriser;
  std::vector<Fragment> fragments;
  for (const PreparedPart& part : parts) {
    rasteriser.draw(part, Camera(view, size), [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        EXPECT_TRUE(!some.is_row || some.pixels[i] == some.pixels[0] + i);
        fragments.push_back({some.triangles[i], some.pixels[i], some.depths[i]});
      }
    });
  }
  return fragments;
}

/// Sorted inside of each triangle, whose fragments come in any order; fails where triangles do not come in theirs.
std::vector<Fragment> drawn(std::span<const RasterPart> parts, const View& view, int size) {
  std::vector<Fragment> fragments = drawn_in_turn(prepared(parts), view, size);
  EXPECT_TRUE(std::ranges::is_sorted(fragments, {}, &Fragment::triangle));
  std::ranges::sort(fragments);
  return fragments;
}

/// As coverage.h and camera.h say it.
std::vector<Fragment> defined(const RasterPart& part, const View& view, int size) {
  const Camera camera(view, size);
  std::vector<Fragment> fragments;
  const PreparedPart ready = prepared({&part, 1})[0];
  for (std::size_t t = 0; t < ready.triangle_count(); ++t) {
    std::array<Corner, 3> c;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = ready.corners[i][t];
      c[i] = camera.project({ready.positions[0][vertex], ready.positions[1][vertex], ready.positions[2][vertex]});
    }
    const std::int64_t area = doubled_area(c[0], c[1], c[2]);
    if (area == 0 || (area < 0 && part.culls_back_faces)) continue;
    normalise(c);
    const auto put = [&](const auto& depth) {
      for_each_covered(c[0], c[1], c[2], PixelBox(c[0], c[1], c[2]), [&](int x, int y, const auto& weights) {
        fragments.push_back({ready.numbers[t], static_cast<std::uint32_t>(y * size + x), depth.at(weights)});
      });
    };
    camera.is_perspective() ? put(PerspectiveDepth(camera, c[0], c[1], c[2], std::abs(area)))
                            : put(OrthographicDepth(camera, c[0], c[1], c[2], std::abs(area)));
  }
  std::ranges::sort(fragments);
  return fragments;
}

glm::vec3 random_place() {
  const auto coordinate = [] { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 1000; };
  return glm::vec3{coordinate(), coordinate(), coordinate()};
}

void add(TestMesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

/// Triangles of every size from the whole picture to far below a pixel, slivers of aspect 10^6, triangles drawn again
/// with other numbers, and ones nearly in the same place.
TestMesh random_mesh(int triangles) {
  TestMesh mesh;
  add(mesh, {-1, -1, -1}, {1, -1, 1}, {1, 1, 1});  // the sphere is always about as large
  for (int i = 0; i < triangles; ++i) {
    const glm::vec3 a = random_place();
    const float size = std::exp2(static_cast<float>(-*rc::gen::inRange(0, 14)));
    const glm::vec3 b = a + size * random_place();
    const glm::vec3 c = a + size * random_place();
    switch (*rc::gen::inRange(0, 5)) {
      case 0: add(mesh, a, b, a + (b - a) * 0.5f + random_place() * size * 1e-6f); break;
      case 1: add(mesh, a, b, c), add(mesh, c, b, a); break;
      case 2: add(mesh, a, b, c), add(mesh, a + 1e-6f * random_place(), b, c); break;
      default: add(mesh, a, b, c);
    }
  }
  return mesh;
}

View random_view(double distance) {
  const glm::dvec3 towards = glm::dvec3(random_place()) + glm::dvec3(0, 0, 1e-3);
  return {towards / std::sqrt(glm::dot(towards, towards)), distance};
}

const std::vector<double> distances = {0, 1.01, 2.5, 1e6};

RC_GTEST_PROP(Rasteriser, draws_what_the_definition_says_at_every_width, ()) {
  const TestMesh mesh = random_mesh(*rc::gen::inRange(0, 60));
  const RasterPart part = part_of(mesh, *rc::gen::arbitrary<bool>());
  const int size = *rc::gen::element(1, 16, 61, 256, 700);
  const View view = random_view(*rc::gen::elementOf(distances));
  const std::vector<Fragment> expected = defined(part, view, size);
  testing::at_every_width([&] { RC_ASSERT(drawn({&part, 1}, view, size) == expected); });
}

/// One double-sided part shows what its fronts and its turned triangles show, each under a number of its own.
RC_GTEST_PROP(Rasteriser, tells_what_is_drawn_from_behind, ()) {
  constexpr std::uint32_t behind = 1000;
  const TestMesh mesh = random_mesh(*rc::gen::inRange(0, 60));
  TestMesh turned = mesh;
  for (std::size_t i = 0; i < turned.indices.size(); i += 3) std::swap(turned.indices[i + 1], turned.indices[i + 2]);
  const RasterPart fronts = part_of(mesh, true), backs = part_of(turned, true), both = part_of(mesh, false);
  const int size = *rc::gen::element(1, 16, 61, 256, 700);
  const View view = random_view(*rc::gen::elementOf(distances));
  std::vector<PreparedPart> ready = prepared({&both, 1});
  ready[0].behind = behind;
  testing::at_every_width([&] {
    std::vector<Fragment> expected = drawn({&fronts, 1}, view, size);
    for (Fragment one : drawn({&backs, 1}, view, size)) {
      one.triangle += behind;
      expected.push_back(one);
    }
    std::vector<Fragment> found = drawn_in_turn(ready, view, size);
    std::ranges::sort(found);
    RC_ASSERT(found == expected);
  });
}

TEST(Rasteriser, draws_the_largest_picture_as_defined) {
  TestMesh mesh;
  add(mesh, {-1, -1, -1}, {1, -1, 1}, {1, 1, -1});
  add(mesh, {-1, -1, -1}, {1, 0.99f, 1}, {1, 1, 1});
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 3);  // there to be a sphere around
  add(mesh, {-0.6f, -0.5f, 0.8f}, {0.3f, -0.4f, -0.5f}, {0, 0.1f, 0.6f});
  const RasterPart part = part_of(mesh, false);
  for (const double distance : {0.0, 1.5}) {
    const View view{{0.6, 0, 0.8}, distance};
    const std::vector<Fragment> expected = defined(part, view, 4096);
    EXPECT_GT(expected.size(), 100'000u);
    testing::at_every_width([&] { EXPECT_TRUE(drawn({&part, 1}, view, 4096) == expected); });
  }
}

/// A chequer of holes, laid over each triangle anyhow.
std::shared_ptr<const Mask> random_mask(const TestMesh& mesh) {
  auto mask = std::make_shared<Mask>();
  mask->image = std::make_shared<const AlphaImage>(AlphaImage{2, 2, {0, 65535, 65535, 0}});
  mask->sampling.is_nearest = true;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mask->uv.emplace_back(random_place());
  mask->alphas.assign(mesh.positions.size(), 1);
  return mask;
}

RC_GTEST_PROP(Rasteriser, a_mask_parts_the_fragments_of_each_triangle_and_loses_none, ()) {
  const TestMesh mesh = random_mesh(*rc::gen::inRange(0, 40));
  RasterPart part = part_of(mesh, false);
  const int size = *rc::gen::element(1, 16, 61);
  const View view = random_view(0);
  const std::vector<Fragment> whole = drawn({&part, 1}, view, size);
  part.mask = random_mask(mesh);
  std::vector<Fragment> parted;
  const TakeFragments take = [&](const Fragments& some) {
    for (std::size_t i = 0; i < some.count; ++i) parted.push_back({some.triangles[i], some.pixels[i], some.depths[i]});
  };
  Rasteriser().draw(prepared({&part, 1})[0], Camera(view, size), take, take);
  RC_ASSERT(std::ranges::is_sorted(parted, {}, &Fragment::triangle));
  std::ranges::sort(parted);
  RC_ASSERT(parted == whole);
}

void expect_exact(std::span<const RasterPart> parts, const View& view, int size) {
  const std::vector<testing::ExactFragment> exact = testing::exact_fragments(parts, view, size);
  testing::at_every_width([&] {
    const std::vector<Fragment> fragments = drawn(parts, view, size);
    RC_ASSERT(fragments.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      RC_ASSERT(fragments[i].triangle == exact[i].triangle);
      RC_ASSERT(fragments[i].pixel == static_cast<std::uint32_t>(exact[i].y * size + exact[i].x));
      if (view.distance == 0) {
        RC_ASSERT(fragments[i].depth == testing::rounded_down(exact[i].depth));
      } else {
        // To the nearest; from afar, the last bit of a double is worth a hundredth of a step.
        RC_ASSERT(abs(exact[i].depth - fragments[i].depth) < testing::cpp_rational(0.52));
      }
    }
  });
}

RC_GTEST_PROP(Rasteriser, covers_and_orders_as_exact_arithmetic_does, ()) {
  const TestMesh mesh = random_mesh(*rc::gen::inRange(0, 12));
  const TestMesh other = random_mesh(*rc::gen::inRange(0, 4));
  std::array parts = {part_of(mesh, *rc::gen::arbitrary<bool>()), part_of(other, *rc::gen::arbitrary<bool>())};
  parts[1].is_mirrored = *rc::gen::arbitrary<bool>();
  expect_exact(parts, random_view(*rc::gen::elementOf(distances)), *rc::gen::element(1, 7, 16, 33));
}

RC_GTEST_PROP(Rasteriser, is_exact_where_corners_lie_on_centres, ()) {
  // In 16 pixels across a sphere of radius 1, odd sixteenths are centres.
  const auto sixteenths = [] { return static_cast<float>(*rc::gen::inRange(-7, 8)) / 16; };
  TestMesh mesh;
  add(mesh, {0, 0, -1}, {0, 0, 1}, {0, 0, 0});
  for (int i = 0; i < 12; ++i) {
    const auto corner = [&] { return glm::vec3{sixteenths(), sixteenths(), sixteenths()}; };
    add(mesh, corner(), corner(), corner());
  }
  const RasterPart part = part_of(mesh, false);
  expect_exact({&part, 1}, {{0, 0, 1}}, 16);
}

RC_GTEST_PROP(Rasteriser, a_closed_mesh_has_as_many_front_as_back_fragments_in_every_pixel, (std::uint64_t seed)) {
  TestMesh mesh = testing::joined(testing::torus(9, 7), testing::sphere(7, 5, 0.3f, random_place()));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < 4; ++i) mesh.positions.push_back(random_place());
  for (const std::uint32_t i : {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}) mesh.indices.push_back(first + i);
  for (glm::vec3& position : mesh.positions) position = glm::round(position * 1024.0f) / 1024.0f;  // seams are shut
  mesh = testing::shuffled(mesh, seed);
  const RasterPart front = part_of(mesh);
  RasterPart back = front;
  back.is_mirrored = true;
  const View view = random_view(0);
  std::map<std::uint32_t, int> fronts;
  for (const Fragment& fragment : drawn({&front, 1}, view, 64)) ++fronts[fragment.pixel];
  std::map<std::uint32_t, int> backs;
  for (const Fragment& fragment : drawn({&back, 1}, view, 64)) ++backs[fragment.pixel];
  RC_ASSERT(!fronts.empty());
  RC_ASSERT(fronts == backs);
}

}  // namespace
}  // namespace foredraw::fragments_test
