// What changes nothing about the overdraw that is counted, and what no order changes.

#include "../../evaluators/overdraw_raster/overdraw_raster.h"

#include "support/painter.h"

#include <foredraw/overdraw/fragment_layers.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace foredraw::overdraw_raster_properties_test {
namespace {

using testing::part_of;
using testing::TestMesh;

Views from_everywhere(double distance) {
  ViewSet set;
  set.views = "fibonacci";
  set.count = 20;
  set.size = 48;
  if (distance > 0) set.distance = distance;
  return make_views(set);
}

/// Coordinates are multiples of 2^-12 below 1, so that floats hold them moved and scaled too.
TestMesh random_tangle(std::uint64_t seed) {
  TestMesh mesh = testing::tangle(seed, false);
  for (glm::vec3& position : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) position[axis] = std::floor(position[axis] * 1024) / 4096;
  }
  return mesh;
}

RC_GTEST_PROP(OverdrawRasterProperties, numbering_vertices_anew_changes_nothing, (std::uint64_t seed)) {
  const TestMesh mesh = random_tangle(seed);
  const std::vector<std::uint32_t> number = testing::random_order(mesh.positions.size(), seed + 1);
  TestMesh other = mesh;
  for (std::size_t v = 0; v < number.size(); ++v) other.positions[number[v]] = mesh.positions[v];
  for (std::uint32_t& index : other.indices) index = number[index];
  for (const double distance : {0.0, 1.5}) {
    const RasterPart a = part_of(mesh), b = part_of(other);
    RC_ASSERT(overdraw_raster({&a, 1}, from_everywhere(distance)) ==
              overdraw_raster({&b, 1}, from_everywhere(distance)));
  }
}

RC_GTEST_PROP(OverdrawRasterProperties, draws_add_up, (std::uint64_t seed)) {
  const TestMesh mesh = random_tangle(seed);
  const RasterPart whole = part_of(mesh, false);
  std::vector<RasterPart> parts;
  for (std::span<const std::uint32_t> left = whole.indices; !left.empty();) {
    const std::size_t count = std::min<std::size_t>(left.size(), 3 * *rc::gen::inRange<std::size_t>(1, 200));
    parts.push_back({whole.positions, {}, false});
    parts.push_back({whole.positions, left.first(count), false});
    left = left.subspan(count);
  }
  for (const double distance : {0.0, 1.5}) {
    const OverdrawCounts one = overdraw_raster({&whole, 1}, from_everywhere(distance));
    const OverdrawCounts several = overdraw_raster(parts, from_everywhere(distance));
    for (std::size_t view = 0; view < one[0].size(); ++view) {
      OverdrawCount sum;
      for (const auto& part : several) sum += part[view];
      RC_ASSERT(sum == one[0][view]);
    }
  }
}

RC_GTEST_PROP(OverdrawRasterProperties, size_and_place_change_nothing, (std::uint64_t seed)) {
  const TestMesh mesh = random_tangle(seed);
  const int power = *rc::gen::inRange(-66, 67);
  const auto step = [] { return static_cast<float>(*rc::gen::inRange(-1024, 1025)) / 1024; };
  const glm::vec3 way = {step(), step(), step()};
  TestMesh other = mesh;
  for (glm::vec3& position : other.positions) {
    position += way;
    for (int axis = 0; axis < 3; ++axis) position[axis] = std::ldexp(position[axis], power);
  }
  for (const double distance : {0.0, 1.5}) {
    const RasterPart a = part_of(mesh), b = part_of(other);
    RC_ASSERT(overdraw_raster({&a, 1}, from_everywhere(distance)) ==
              overdraw_raster({&b, 1}, from_everywhere(distance)));
  }
}

RC_GTEST_PROP(OverdrawRasterProperties, no_order_beats_the_bound, (std::uint64_t seed)) {
  const TestMesh mesh = testing::tangle(seed, *rc::gen::arbitrary<bool>());
  const RasterPart part = part_of(mesh);
  const auto layers = fragment_layers({&part, 1}, from_everywhere(0), Executor(1));
  const ShadedBounds bounds = shaded_bounds(*layers);
  for (int i = 0; i < 5; ++i) {
    const TestMesh other = testing::shuffled(mesh, seed + static_cast<std::uint64_t>(i));
    const RasterPart ordered = part_of(other);
    const OverdrawCounts counts = overdraw_raster({&ordered, 1}, from_everywhere(0));
    OverdrawCount count;
    for (const OverdrawCount& view : counts[0]) count += view;
    RC_ASSERT(count.shaded >= bounds.least);
    RC_ASSERT(count.shaded <= bounds.most);
  }
}

RC_GTEST_PROP(OverdrawRasterProperties, threads_change_nothing, (std::uint64_t seed)) {
  const TestMesh mesh = random_tangle(seed);
  const std::vector<RasterPart> parts = {part_of(mesh), part_of(mesh, false)};
  const OverdrawCounts one = overdraw_raster(parts, from_everywhere(0));
  for (const int threads : {2, 7}) RC_ASSERT(overdraw_raster(parts, from_everywhere(0), Executor(threads)) == one);
}

}  // namespace
}  // namespace foredraw::overdraw_raster_properties_test
