// Meshes, sprites and instances have the answers of the functions for C++, and what is wrong with them is refused.

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <evaluators/surface_error/surface_error.h>
#include <foredraw/base/parallel.h>
#include <foredraw/c/functions.h>
#include <foredraw/scene/draw.h>
#include <foredraw/viewing/view_directions.h>
#include <plugins/processors/merge_instances/merge_instances.h>
#include <plugins/processors/particle_trim/particle_trim.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>
#include <plugins/processors/second_depth/shells.h>
#include <plugins/processors/sprite_frames/sprite_frames.h>
#include <plugins/processors/weld/weld.h>

#include "bumpy_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw::same_meshes_test {
namespace {

using testing::BumpySheet;

VertexStreams streams_of(const BumpySheet& sheet) {
  VertexStreams streams;
  streams.count = static_cast<std::uint32_t>(sheet.vertices.size());
  const auto bytes = std::as_bytes(std::span(sheet.vertices));
  streams.base.push_back({"VERTEX",
                          {Component::uint8, 1, false, sizeof(BumpySheet::Vertex)},
                          Shared(std::vector<std::byte>(bytes.begin(), bytes.end()))});
  return streams;
}

TEST(MeshesForC, AreWeldedAsByTheFunction) {
  const BumpySheet sheet(9, BumpySheet::own_corners);
  const foredraw_triangles triangles = sheet.triangles();
  const foredraw_attribute attributes[] = {
      {sheet.vertices[0].position, sizeof(BumpySheet::Vertex), sizeof sheet.vertices[0].position},
      {&sheet.vertices[0].colour, sizeof(BumpySheet::Vertex), sizeof sheet.vertices[0].colour}};
  std::vector<std::uint32_t> destination(sheet.vertices.size()), kept(sheet.vertices.size());
  std::uint32_t count = 0;
  ASSERT_EQ(foredraw_weld(destination.data(), kept.data(), &count, &triangles, attributes, 2, 0), FOREDRAW_DONE);
  const std::vector<std::uint32_t> wide(sheet.indices.begin(), sheet.indices.end());
  const std::span<const std::uint32_t> indices = wide;
  const Weld made = weld(streams_of(sheet), {&indices, 1});
  EXPECT_EQ(destination, made.destination);
  EXPECT_EQ(count, made.count);
  EXPECT_LT(count, sheet.vertices.size() / 3);

  std::vector<std::uint16_t> moved(sheet.indices.size());
  ASSERT_EQ(foredraw_move_vertices(moved.data(), &triangles, destination.data()), FOREDRAW_DONE);
  std::vector<BumpySheet::Vertex> vertices(count);
  ASSERT_EQ(foredraw_reorder_elements(vertices.data(), sheet.vertices.data(), sheet.vertices.size(),
                                      sizeof(BumpySheet::Vertex), kept.data(), count),
            FOREDRAW_DONE);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    EXPECT_EQ(std::memcmp(&vertices[moved[i]], &sheet.vertices[sheet.indices[i]], sizeof(BumpySheet::Vertex)), 0);
  }
  destination[sheet.indices[4]] = 0xffffffff;
  EXPECT_EQ(foredraw_move_vertices(moved.data(), &triangles, destination.data()), FOREDRAW_NO_ORDER);
  EXPECT_EQ(foredraw_weld(destination.data(), nullptr, &count, &triangles, attributes, 0, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_weld(destination.data(), nullptr, nullptr, &triangles, attributes, 2, 0), FOREDRAW_NULL_POINTER);
  const foredraw_attribute none{nullptr, 0, 4}, wide_one{sheet.vertices.data(), 0, 65536};
  EXPECT_EQ(foredraw_weld(destination.data(), nullptr, &count, &triangles, &none, 1, 0), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_weld(destination.data(), nullptr, &count, &triangles, &wide_one, 1, 0), FOREDRAW_OPTION_RANGE);
}

TEST(MeshesForC, HaveTheOverdrawOfTheFunction) {
  const BumpySheet sheet(20);
  const foredraw_triangles triangles = sheet.triangles();
  const foredraw_positions positions = sheet.positions();
  foredraw_overdraw_figures figures;
  ASSERT_EQ(foredraw_overdraw(&figures, &triangles, &positions, 30, 64, 1), FOREDRAW_DONE);
  Views views{{}, 64};
  for (const glm::dvec3& direction : fibonacci_directions(30)) views.views.push_back({direction});
  const std::vector<std::uint32_t> indices(sheet.indices.begin(), sheet.indices.end());
  const std::vector<glm::vec3> places = sheet.places();
  const RasterPart part{places, indices, false};
  OverdrawCount sum;
  const OverdrawCounts counts = overdraw_raster({&part, 1}, views);
  for (const OverdrawCount& count : counts[0]) sum += count;
  EXPECT_EQ(figures.shaded, sum.shaded);
  EXPECT_EQ(figures.visible, sum.visible);
  EXPECT_EQ(figures.ties, sum.ties);
  EXPECT_GT(figures.ratio, 1.01);
  EXPECT_GT(figures.error, 0);
  EXPECT_GE(figures.worst_view, figures.ratio);
  EXPECT_EQ(foredraw_overdraw(&figures, &triangles, &positions, 0, 8, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_overdraw(&figures, &triangles, &positions, 0, 0, 2), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_overdraw(&figures, &triangles, nullptr, 0, 0, 0), FOREDRAW_NULL_POINTER);
  const foredraw_triangles nothing{nullptr, 0, 4, 0};
  ASSERT_EQ(foredraw_overdraw(&figures, &nothing, nullptr, 0, 0, 0), FOREDRAW_DONE);
  EXPECT_EQ(figures.ratio, 0);
}

TEST(MeshesForC, HaveTheSurfaceErrorOfTheFunction) {
  const BumpySheet sheet(12);
  BumpySheet moved = sheet;
  for (BumpySheet::Vertex& vertex : moved.vertices) vertex.position[1] += 0.25f;
  const foredraw_triangles triangles = sheet.triangles();
  const foredraw_positions before = sheet.positions(), after = moved.positions();
  foredraw_surface_error_figures figures;
  ASSERT_EQ(foredraw_surface_error(&figures, &triangles, &after, &triangles, &before, 500, 7), FOREDRAW_DONE);
  const std::vector<std::uint32_t> indices(sheet.indices.begin(), sheet.indices.end());
  const std::vector<glm::vec3> places = sheet.places(), moved_places = moved.places();
  const auto made = surface_error({moved_places, indices}, {places, indices}, {.samples = 500}, 7, Executor(1));
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(figures.largest, made->largest());
  EXPECT_EQ(figures.found, made->found());
  EXPECT_EQ(figures.rms, made->rms().value);
  EXPECT_EQ(figures.p99_error, made->p99().error);
  EXPECT_GT(figures.largest, 0.1);
  EXPECT_LT(figures.largest, 0.26);
  const foredraw_triangles nothing{nullptr, 0, 4, 0};
  EXPECT_EQ(foredraw_surface_error(&figures, &nothing, nullptr, &triangles, &before, 0, 0), FOREDRAW_NO_TRANSFORM);
  EXPECT_EQ(foredraw_surface_error(&figures, &nothing, nullptr, &nothing, nullptr, 0, 0), FOREDRAW_DONE);
  EXPECT_EQ(foredraw_surface_error(&figures, &triangles, nullptr, &triangles, &before, 0, 0), FOREDRAW_NULL_POINTER);
}

/// A sequence with room for a mesh.
struct Sequence {
  explicit Sequence(std::size_t vertices, bool moves)
      : collapses(vertices), pairs(vertices), first_pair(vertices + 1), places(3 * vertices) {
    arrays = {collapses.data(), pairs.data(), first_pair.data(), moves ? places.data() : nullptr, 0, 0};
  }
  std::vector<foredraw_collapse> collapses;
  std::vector<foredraw_vertex_pair> pairs;
  std::vector<std::uint32_t> first_pair;
  std::vector<float> places;
  foredraw_collapses arrays;
};

class Simplified : public ::testing::TestWithParam<bool> {
 protected:
  const BumpySheet sheet_{20};
  const foredraw_triangles triangles_ = sheet_.triangles();
  const foredraw_positions positions_ = sheet_.positions();
  Sequence sequence_{sheet_.vertices.size(), GetParam()};
};

TEST_P(Simplified, HasTheSequenceOfTheFunction) {
  ASSERT_EQ(foredraw_quadric_collapse(&sequence_.arrays, &triangles_, &positions_, nullptr, 0, 0), FOREDRAW_DONE);
  const std::vector<std::uint32_t> indices(sheet_.indices.begin(), sheet_.indices.end());
  const CollapseSequence made = quadric_collapse(
      sheet_.places(), indices, {.placement = GetParam() ? CollapsePlacement::optimal : CollapsePlacement::endpoint});
  ASSERT_EQ(sequence_.arrays.count, made.collapses.size());
  for (std::size_t i = 0; i < made.collapses.size(); ++i) {
    EXPECT_EQ(sequence_.collapses[i].removed, made.collapses[i].removed);
    EXPECT_EQ(sequence_.collapses[i].error, made.collapses[i].error);
  }
  if (!GetParam()) return;  // points stay where they are
  EXPECT_TRUE(std::equal(made.places.begin(), made.places.end(), sequence_.places.begin()));
}

TEST_P(Simplified, EndsAtACountAndAtAnError) {
  ASSERT_EQ(foredraw_quadric_collapse(&sequence_.arrays, &triangles_, &positions_, nullptr, 0, 0), FOREDRAW_DONE);
  std::vector<std::uint16_t> few(sheet_.indices.size());
  std::vector<float> places(3 * sheet_.vertices.size());
  foredraw_simplified half, exact, loose;
  const auto simplify = [&](foredraw_simplified& made, std::uint32_t count, double error) {
    return foredraw_simplify(few.data(), places.data(), &made, &triangles_, &positions_, &sequence_.arrays, count,
                             error);
  };
  ASSERT_EQ(simplify(half, 400, std::numeric_limits<double>::infinity()), FOREDRAW_DONE);
  EXPECT_LE(half.index_count, 1200u);
  EXPECT_GT(half.index_count, 1100u);
  EXPECT_GT(half.error, 0);
  for (std::size_t i = 0; i < half.index_count; ++i) ASSERT_LT(few[i], sheet_.vertices.size());
  ASSERT_EQ(simplify(loose, 0, half.error), FOREDRAW_DONE);
  EXPECT_LE(loose.error, half.error * 1.03);
  EXPECT_LE(loose.index_count, half.index_count);
  ASSERT_EQ(simplify(exact, 0, 0), FOREDRAW_DONE);
  EXPECT_LT(exact.error, 1e-5);
  EXPECT_EQ(simplify(exact, 0, -1), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(simplify(exact, 0, std::nan("")), FOREDRAW_OPTION_RANGE);
  sequence_.collapses[1].removed = sequence_.collapses[0].removed;
  EXPECT_EQ(simplify(exact, 0, 1), FOREDRAW_NO_ORDER);
  sequence_.first_pair[1] = 0xffffffff;
  EXPECT_EQ(simplify(exact, 0, 1), FOREDRAW_NO_ORDER);
}

TEST_P(Simplified, CountsWhatVerticesCarry) {
  std::vector<float> wave;
  for (std::size_t i = 0; i < sheet_.vertices.size(); ++i) wave.push_back(i % 7 < 3 ? 1.0f : std::nanf(""));
  const foredraw_weighted_attribute attribute{wave.data(), 0, 1, 5};
  ASSERT_EQ(foredraw_quadric_collapse(&sequence_.arrays, &triangles_, &positions_, &attribute, 1, 0), FOREDRAW_DONE);
  Sequence plain(sheet_.vertices.size(), GetParam());
  ASSERT_EQ(foredraw_quadric_collapse(&plain.arrays, &triangles_, &positions_, nullptr, 0, 0), FOREDRAW_DONE);
  EXPECT_NE(std::memcmp(plain.collapses.data(), sequence_.collapses.data(), 100 * sizeof(foredraw_collapse)), 0);
  const foredraw_weighted_attribute wrong{wave.data(), 0, 17, 1}, negative{wave.data(), 0, 1, -1};
  for (const auto* one : {&wrong, &negative}) {
    EXPECT_EQ(foredraw_quadric_collapse(&plain.arrays, &triangles_, &positions_, one, 1, 0), FOREDRAW_OPTION_RANGE);
  }
}

INSTANTIATE_TEST_SUITE_P(Places, Simplified, ::testing::Bool());

TEST(MeshesForC, HaveShellsOfFiveKinds) {
  // A cube, the same inside out beside it, and half of one behind.
  std::vector<glm::vec3> places;
  std::vector<std::uint16_t> indices;
  const std::uint16_t corners[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  for (int cube = 0; cube < 3; ++cube) {
    const auto first = static_cast<std::uint16_t>(places.size());
    for (int v = 0; v < 8; ++v) places.push_back({v % 2 + 3 * cube, v / 2 % 2, v / 4});
    for (int i = 0; i < (cube == 2 ? 18 : 36); ++i) {
      const int turned = cube == 1 ? i / 3 * 3 + 2 - i % 3 : i;
      indices.push_back(static_cast<std::uint16_t>(first + corners[turned]));
    }
  }
  const foredraw_triangles triangles{indices.data(), indices.size(), 2, static_cast<std::uint32_t>(places.size())};
  const foredraw_positions positions{places.data(), 0};
  std::vector<std::uint8_t> kinds(indices.size() / 3, 77);
  ASSERT_EQ(foredraw_shell_kinds(kinds.data(), &triangles, &positions), FOREDRAW_DONE);
  for (std::size_t t = 0; t < kinds.size(); ++t) {
    EXPECT_EQ(kinds[t], t < 12 ? FOREDRAW_SHELL_CLOSED : t < 24 ? FOREDRAW_SHELL_INSIDE_OUT : FOREDRAW_SHELL_OPEN) << t;
  }
  EXPECT_EQ(foredraw_shell_kinds(kinds.data(), &triangles, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_shell_kinds(nullptr, &triangles, &positions), FOREDRAW_NULL_POINTER);
}

/// Two discs, 8 bits in an image of four channels.
struct Discs {
  static constexpr std::uint32_t width = 64, height = 32;
  std::vector<std::uint8_t> texels = std::vector<std::uint8_t>(4 * width * height);

  Discs() {
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 64; ++x) {
        const int dx = x % 32 - 16, dy = y - 16;
        texels[4 * (y * 64 + x) + 3] = dx * dx + dy * dy < 100 ? 200 : 0;
      }
    }
  }
  foredraw_alpha alpha() const { return {texels.data() + 3, width, height, 1, 4, 0}; }
  AlphaImage image() const {
    AlphaImage made{width, height, {}};
    for (std::size_t i = 3; i < texels.size(); i += 4)
      made.alpha.push_back(static_cast<std::uint16_t>(texels[i] * 257));
    return made;
  }
};

TEST(SpritesForC, HaveTheFramesAndThePolygonsOfTheFunctions) {
  const Discs discs;
  const foredraw_alpha alpha = discs.alpha();
  foredraw_rectangle frames[8];
  std::uint32_t count = 1;
  EXPECT_EQ(foredraw_sprite_frames(frames, &count, &alpha, 0, 0), FOREDRAW_TOO_LARGE);
  ASSERT_EQ(count, 2u);
  ASSERT_EQ(foredraw_sprite_frames(frames, &count, &alpha, 0, 0), FOREDRAW_DONE);
  const auto found = found_frames(discs.image(), {0, 0, 64, 32});
  ASSERT_EQ(found.size(), 2u);
  foredraw_trimmed trimmed[2];
  std::vector<double> corners(64);
  foredraw_trim_options sampled_as_it_is = FOREDRAW_TRIM_DEFAULTS;
  sampled_as_it_is.mip_levels = 0;
  ASSERT_EQ(foredraw_particle_trim(trimmed, corners.data(), &alpha, frames, 2, &sampled_as_it_is), FOREDRAW_DONE);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((SpriteFrame{frames[i].x, frames[i].y, frames[i].width, frames[i].height}), found[i]);
    const TrimFrame frame{{found[i].x * 256, found[i].y * 256},
                          {(found[i].x + found[i].width) * 256, (found[i].y + found[i].height) * 256}};
    ParticleTrimOptions options;
    options.winding = TrimWinding::clockwise;
    options.mip_levels = 0;
    const auto made =
        particle_trim(discs.image(), {{Wrap::clamped, Wrap::clamped}, false}, {&frame, 1}, options).front();
    EXPECT_EQ(trimmed[i].outcome, static_cast<std::uint32_t>(FOREDRAW_TRIMMED));
    EXPECT_EQ(trimmed[i].area, made.area);
    EXPECT_LT(trimmed[i].area, 0.95 * trimmed[i].frame_area);
    ASSERT_EQ(trimmed[i].corner_count, made.corners.size());
    for (std::size_t c = 0; c < made.corners.size(); ++c) {
      EXPECT_EQ(corners[32 * i + 2 * c], made.corners[c].x);
      EXPECT_EQ(corners[32 * i + 2 * c + 1], made.corners[c].y);
    }
  }
}

TEST(SpritesForC, RefuseWhatIsWrong) {
  const Discs discs;
  const foredraw_alpha good = discs.alpha();
  foredraw_alpha bad = good;
  foredraw_rectangle frame{40, 0, 25, 10};
  foredraw_trimmed trimmed;
  double corners[32];
  std::uint32_t count = 0;
  EXPECT_EQ(foredraw_particle_trim(&trimmed, corners, &good, &frame, 1, nullptr), FOREDRAW_OPTION_RANGE);
  frame = {0, 0xffffffff, 1, 2};
  EXPECT_EQ(foredraw_particle_trim(&trimmed, corners, &good, &frame, 1, nullptr), FOREDRAW_OPTION_RANGE);
  frame = {0, 0, 32, 32};
  foredraw_trim_options options = FOREDRAW_TRIM_DEFAULTS;
  options.vertices = 17;
  EXPECT_EQ(foredraw_particle_trim(&trimmed, corners, &good, &frame, 1, &options), FOREDRAW_OPTION_RANGE);
  options.vertices = 4, options.size = 8;
  EXPECT_EQ(foredraw_particle_trim(&trimmed, corners, &good, &frame, 1, &options), FOREDRAW_OPTION_RANGE);
  options.size = sizeof options;
  EXPECT_EQ(foredraw_particle_trim(&trimmed, corners, &good, &frame, 1, &options), FOREDRAW_DONE);
  EXPECT_LE(trimmed.corner_count, 4u);
  EXPECT_EQ(foredraw_particle_trim(nullptr, corners, &good, &frame, 1, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_particle_trim(nullptr, nullptr, &good, nullptr, 0, nullptr), FOREDRAW_DONE);
  bad.bytes = 3;
  EXPECT_EQ(foredraw_sprite_frames(nullptr, &count, &bad, 0, 0), FOREDRAW_OPTION_RANGE);
  bad = good, bad.width = 40000;
  EXPECT_EQ(foredraw_sprite_frames(nullptr, &count, &bad, 0, 0), FOREDRAW_TOO_LARGE);
  bad = good, bad.first = nullptr;
  EXPECT_EQ(foredraw_sprite_frames(nullptr, &count, &bad, 0, 0), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_sprite_frames(nullptr, &count, &good, 1.5, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_sprite_frames(nullptr, nullptr, &good, 0, 0), FOREDRAW_NULL_POINTER);
}

struct Placed {
  const BumpySheet small{3}, large{8};
  std::vector<foredraw_packed_mesh> meshes;
  std::vector<foredraw_placed_mesh> placed;

  Placed() {
    meshes = {{small.triangles(), small.positions(), 0, 0},
              {large.triangles(), large.positions(), static_cast<std::uint32_t>(small.vertices.size()), 0}};
    for (std::uint32_t i = 0; i < 50; ++i) {
      const float x = static_cast<float>(i % 10) * 40, z = static_cast<float>(i / 10) * 40, side = i % 9 == 4 ? -1 : 1;
      placed.push_back({i % 2, {side, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, z}});
    }
  }
};

TEST(InstancesForC, AreMergedAsByTheFunction) {
  const Placed given;
  foredraw_merged merged;
  ASSERT_EQ(foredraw_merge_instances(&merged, given.meshes.data(), 2, given.placed.data(), 50, 0, 0), FOREDRAW_DONE);
  std::vector<std::vector<std::uint32_t>> indices;
  std::vector<processors::merge_instances::PackedMesh> meshes;
  std::vector<processors::merge_instances::PlacedMesh> placed;
  for (const BumpySheet* sheet : {&given.small, &given.large}) {
    indices.emplace_back(sheet->indices.begin(), sheet->indices.end());
  }
  const std::vector<glm::vec3> places[] = {given.small.places(), given.large.places()};
  for (std::size_t i = 0; i < 2; ++i) {
    meshes.push_back({"", indices[i], given.meshes[i].first_vertex, static_cast<std::uint32_t>(places[i].size())});
  }
  for (const foredraw_placed_mesh& at : given.placed) {
    processors::merge_instances::PlacedMesh one{at.mesh};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) one.world[column][row] = at.transform[4 * row + column];
    }
    for (const glm::vec3& place : places[at.mesh]) one.box.add(glm::vec3(one.world * glm::vec4(place, 1)));
    placed.push_back(one);
  }
  const processors::merge_instances::PackedInstances made = merge_instances(meshes, placed, {}, Executor(1));
  ASSERT_EQ(merged.instance_count, 50u);
  EXPECT_TRUE(
      std::equal(made.indices.begin(), made.indices.end(), merged.indices, merged.indices + merged.index_count));
  EXPECT_TRUE(std::equal(made.placed.begin(), made.placed.end(), merged.placed, merged.placed + 50));
  ASSERT_EQ(merged.slot_count, made.slots.size());
  EXPECT_EQ(std::memcmp(merged.slots, made.slots.data(), 8 * made.slots.size()), 0);
  EXPECT_EQ(std::memcmp(merged.transforms, made.transforms.data(), 48 * 50), 0);
  ASSERT_EQ(merged.draw_count, made.draws.size());
  EXPECT_EQ(merged.draws[0].frequency, made.draws[0].frequency);
  ASSERT_EQ(merged.group_count, made.groups.size());
  EXPECT_EQ(merged.groups[0].most[0], made.groups[0].most.x);
  foredraw_merged_free(&merged);
  EXPECT_EQ(merged.owner, nullptr);
  foredraw_merged_free(&merged);
  foredraw_merged_free(nullptr);
}

TEST(InstancesForC, RefuseWhatIsWrong) {
  Placed given;
  foredraw_merged merged;
  const auto merge = [&] {
    return foredraw_merge_instances(&merged, given.meshes.data(), 2, given.placed.data(), 50, 0, 0);
  };
  given.placed[3].mesh = 2;
  EXPECT_EQ(merge(), FOREDRAW_INDEX_RANGE);
  given.placed[3].mesh = 1, given.placed[3].transform[0] = 0;
  EXPECT_EQ(merge(), FOREDRAW_NO_TRANSFORM);
  given.placed[3].transform[0] = std::nanf("");
  EXPECT_EQ(merge(), FOREDRAW_NO_TRANSFORM);
  given.placed[3].transform[0] = 1, given.meshes[1].first_vertex = 0xffffffff;
  EXPECT_EQ(merge(), FOREDRAW_TOO_LARGE);
  given.meshes[1].first_vertex = 0, given.meshes[0].triangles.index_bytes = 3;
  EXPECT_EQ(merge(), FOREDRAW_INDEX_BYTES);
  EXPECT_EQ(foredraw_merge_instances(&merged, given.meshes.data(), 2, nullptr, 1, 0, 0), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_merge_instances(&merged, nullptr, 0, nullptr, 0, 5, 0), FOREDRAW_OPTION_RANGE);
  EXPECT_EQ(foredraw_merge_instances(nullptr, nullptr, 0, nullptr, 0, 0, 0), FOREDRAW_NULL_POINTER);
  ASSERT_EQ(foredraw_merge_instances(&merged, nullptr, 0, nullptr, 0, 0, 0), FOREDRAW_DONE);
  EXPECT_EQ(merged.slot_count, 0u);
  foredraw_merged_free(&merged);
}

}  // namespace
}  // namespace foredraw::same_meshes_test
