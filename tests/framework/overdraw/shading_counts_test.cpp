#include <foredraw/overdraw/shading_counts.h>

#include "support/painter.h"

#include <foredraw/overdraw/heat_map.h>
#include <foredraw/viewing/view_set.h>

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace foredraw::shading_counts_test {
namespace {

using testing::part_of;
using testing::TestMesh;

Views some_views() {
  ViewSet set;
  set.views = "fibonacci";
  set.count = 5;
  set.size = 48;
  return make_views(set);
}

TestMesh in_order(const TestMesh& mesh, std::span<const std::uint32_t> order) {
  TestMesh ordered{mesh.positions, {}};
  for (const std::uint32_t t : order) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) ordered.indices.push_back(mesh.indices[3 * t + corner]);
  }
  return ordered;
}

TEST(OverdrawDetails, agree_with_drawing_each_order) {
  // Twice the same torus among others: ties too.
  const TestMesh torus = testing::torus(24, 12);
  const TestMesh mesh = testing::joined(testing::joined(torus, testing::sphere(12, 8)), torus);
  const RasterPart part = part_of(mesh);
  const Views views = some_views();
  const auto layers = fragment_layers({&part, 1}, views, Executor(1)).value();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const std::vector<std::uint32_t> order = testing::random_order(layers.owners, seed);
    const TestMesh ordered = in_order(mesh, order);
    const RasterPart drawn = part_of(ordered);
    std::vector<std::uint64_t> pixels(2);
    for (const View& view : views.views) {
      for (const std::uint32_t times : heat_map({&drawn, 1}, view, views.size).times) {
        if (times == 0) continue;
        if (times >= pixels.size()) pixels.resize(times + 1);
        ++pixels[times];
      }
    }
    const OverdrawDetails details = overdraw_details(layers, order);
    EXPECT_EQ(details.pixels_by_times, pixels);
    const OverdrawCount count = count_overdraw(layers, order);
    EXPECT_EQ(std::accumulate(details.hidden.begin(), details.hidden.end(), std::uint64_t{0}),
              count.shaded - count.visible);
  }
}

TEST(OverdrawDetails, name_the_triangles_that_are_hidden) {
  const TestMesh behind{{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}, {0, 1, 2}};
  const TestMesh before{{{-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}}, {0, 1, 2}};
  const TestMesh mesh = testing::joined(behind, before);
  const RasterPart part = part_of(mesh);
  const Views front{{View{}}, 64};
  const auto layers = fragment_layers({&part, 1}, front, Executor(1)).value();
  const std::vector<std::uint32_t> back_to_front = {0, 1};
  const OverdrawCount count = count_overdraw(layers, back_to_front);
  EXPECT_EQ(overdraw_details(layers, back_to_front).hidden, (std::vector<std::uint64_t>{count.visible, 0}));
  EXPECT_EQ(overdraw_details(layers, std::vector<std::uint32_t>{1, 0}).hidden, (std::vector<std::uint64_t>{0, 0}));
}

TEST(OverdrawDetails, what_is_no_order_is_refused) {
  const TestMesh mesh = testing::torus(8, 6);
  const RasterPart part = part_of(mesh);
  const auto layers = fragment_layers({&part, 1}, some_views(), Executor(1)).value();
  EXPECT_THROW(overdraw_details(layers, std::vector<std::uint32_t>(layers.owners, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::shading_counts_test
