// Wherever memory runs out, the functions say so; nothing leaks, and no exception comes out.

#include <foredraw/c/functions.h>

#include "bumpy_sheet.h"
#include "counted_memory.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace foredraw::no_memory_test {
namespace {

using foredraw::testing::held;
using foredraw::testing::left;

/// Calls it with ever more allocations that succeed, until it is done: each of the first hundred fails once, of the
/// rest one in so many.
void expect_survives(const std::function<int()>& call, long one_in = 1) {
  int failed = 0;
  for (long allowed = 0;; allowed += allowed < 100 ? 1 : one_in) {
    const long before = held;
    left = allowed;
    const int status = call();
    left = -1;
    ASSERT_EQ(held, before);
    if (status == FOREDRAW_DONE) break;
    ASSERT_EQ(status, FOREDRAW_NO_MEMORY);
    ++failed;
  }
  EXPECT_GT(failed, 0);
}

TEST(WithoutMemory, FunctionsSayThatItRanOut) {
  std::uint16_t indices[300];
  std::uint32_t order[100], offsets[101], sequence[100], clusters = 0;
  float positions[300];
  for (int i = 0; i < 300; ++i)
    indices[i] = static_cast<std::uint16_t>(i * 37 % 100), positions[i] = static_cast<float>(i);
  const foredraw_triangles list{indices, 300, 2, 100};
  const foredraw_positions places{positions, 0};
  foredraw_vertex_cache_figures figures;
  expect_survives([&] { return foredraw_tipsify(order, &list, 0); });
  expect_survives([&] { return foredraw_forsyth(order, &list, 0); });
  expect_survives([&] { return foredraw_lookahead(order, &list, FOREDRAW_LOOKAHEAD_HIGH, 0, 0); });
  expect_survives([&] { return foredraw_linear_clusters(offsets, &clusters, &list, 0, 0); });
  expect_survives([&] { return foredraw_dot_rule(sequence, &list, &places, offsets, clusters); });
  expect_survives([&] { return foredraw_order_of_clusters(order, offsets, clusters, sequence); });
  expect_survives([&] { return foredraw_vertex_fetch(order, nullptr, &list); });
  expect_survives([&] { return foredraw_renumber_vertices(indices, &list, order); });
  expect_survives([&] { return foredraw_vertex_cache(&figures, &list, 0); });
}

TEST(WithoutMemory, MeshesSayThatItRanOut) {
  const foredraw::testing::BumpySheet sheet(6);
  const foredraw_triangles list = sheet.triangles();
  const foredraw_positions places = sheet.positions();
  const std::size_t vertices = sheet.vertices.size();
  std::vector<std::uint32_t> order(72), destination(vertices), kept(vertices), first_pair(vertices + 1);
  std::vector<foredraw_collapse> collapses(vertices);
  std::vector<foredraw_vertex_pair> pairs(vertices);
  std::vector<std::uint16_t> few(sheet.indices.size());
  foredraw_collapses sequence{collapses.data(), pairs.data(), first_pair.data(), nullptr, 0, 0};
  foredraw_simplified simplified;
  foredraw_overdraw_figures figures;
  std::uint32_t count = 0;
  const foredraw_attribute attribute{sheet.vertices.data(), 0, sizeof sheet.vertices[0]};
  expect_survives([&] { return foredraw_weld(destination.data(), kept.data(), &count, &list, &attribute, 1, 0); });
  expect_survives([&] { return foredraw_move_vertices(few.data(), &list, destination.data()); });
  expect_survives([&] { return foredraw_overdraw(&figures, &list, &places, 3, 16, 0); });
  expect_survives([&] { return foredraw_quadric_collapse(&sequence, &list, &places, nullptr, 0, 0); }, 7);
  expect_survives([&] { return foredraw_simplify(few.data(), nullptr, &simplified, &list, &places, &sequence, 20, 1); },
                  7);
  std::vector<float> moved(3 * vertices);
  sequence.places = moved.data();
  const foredraw_weighted_attribute height{sheet.vertices[0].position + 1, sizeof sheet.vertices[0], 1, 1};
  sequence.solves = 1;
  expect_survives([&] { return foredraw_quadric_collapse(&sequence, &list, &places, &height, 1, 0); }, 7);
  std::vector<float> heights(vertices);
  expect_survives([&] { return foredraw_level_attributes(heights.data(), &list, &places, &sequence, 20, &height, 1); },
                  7);
  std::vector<std::uint8_t> kinds(72);
  expect_survives([&] { return foredraw_shell_kinds(kinds.data(), &list, &places); });
  foredraw_surface_error_figures error;
  std::vector<float> flat(3 * vertices);
  const foredraw_positions flat_places{flat.data(), 0};
  for (std::size_t i = 0; i < vertices; ++i)
    flat[3 * i] = sheet.vertices[i].position[0], flat[3 * i + 2] = static_cast<float>(i);
  expect_survives([&] { return foredraw_surface_error(&error, &list, &places, &list, &flat_places, 20, 1); }, 5);
  expect_survives([&] { return foredraw_occlusion_order(order.data(), &list, &places, 0, 0, 0, 1); }, 97);
}

TEST(WithoutMemory, SpritesAndInstancesSayThatItRanOut) {
  std::vector<std::uint8_t> texels(16 * 16);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = i / 16 > 4 && i % 16 > 4 && i / 16 + i % 16 < 24 ? 255 : 0;
  const foredraw_alpha alpha{texels.data(), 16, 16, 1, 0, 0};
  foredraw_rectangle frames[4];
  foredraw_trimmed trimmed[4];
  double corners[128];
  expect_survives([&] {
    std::uint32_t room = 4;
    return foredraw_sprite_frames(frames, &room, &alpha, 0, 0);
  });
  const foredraw_rectangle whole{0, 0, 16, 16};
  expect_survives([&] { return foredraw_particle_trim(trimmed, corners, &alpha, &whole, 1, nullptr); }, 23);

  const foredraw::testing::BumpySheet sheet(3);
  const foredraw_packed_mesh mesh{sheet.triangles(), sheet.positions(), 0, 0};
  std::vector<foredraw_placed_mesh> placed;
  for (int i = 0; i < 9; ++i) placed.push_back({0, {1, 0, 0, static_cast<float>(5 * i), 0, 1, 0, 0, 0, 0, 1, 0}});
  expect_survives([&] {
    foredraw_merged merged;
    const int status = foredraw_merge_instances(&merged, &mesh, 1, placed.data(), 9, 0, 0);
    if (status == FOREDRAW_DONE) foredraw_merged_free(&merged);
    return status;
  });
}

}  // namespace
}  // namespace foredraw::no_memory_test
