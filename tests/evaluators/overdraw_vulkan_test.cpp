#include "../../evaluators/overdraw_vulkan/overdraw_vulkan.h"
#include "../../evaluators/overdraw_vulkan/vulkan_painter.h"

#include "support/on_device.h"
#include "support/overdraw.h"
#include "support/painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace foredraw::overdraw_vulkan_test {
namespace {

using testing::all_sides;
using testing::part_of;
using testing::quad;
using testing::TestMesh;
using testing::total;
using testing::views_of;

std::vector<RasterPart> parts_of(std::span<const TestMesh> meshes, bool culls_back_faces = true) {
  std::vector<RasterPart> parts;
  for (const TestMesh& mesh : meshes) parts.push_back(part_of(mesh, culls_back_faces));
  return parts;
}

class OverdrawVulkan : public testing::OnDevice {
 protected:
  void SetUp() override {
    OnDevice::SetUp();
    if (!IsSkipped()) renew();
  }

  void TearDown() override {
    device_.reset();
    OnDevice::TearDown();
  }

  void renew() {
    device_.reset();
    device_ = std::make_unique<OverdrawDevice>(choice());
  }

  OverdrawDevice& device() { return *device_; }

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views) {
    return overdraw_vulkan(*device_, parts, views);
  }

  OverdrawCount draw(const TestMesh& mesh, const Views& views, bool culls_back_faces = true) {
    const RasterPart part = part_of(mesh, culls_back_faces);
    return total(draw({&part, 1}, views));
  }

 private:
  std::unique_ptr<OverdrawDevice> device_;
};

// --- what is counted
// ---------------------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, quads_cost_as_often_as_each_is_nearer_than_those_before_it) {
  const Views front = views_of({{0, 0, 1}}, 64);
  struct Row {
    std::vector<float> heights;
    std::uint64_t ratio;
  };
  for (const Row& row : {Row{{-0.2f, -0.1f, 0, 0.1f, 0.2f}, 5}, Row{{0.2f, 0.1f, 0, -0.1f, -0.2f}, 1},
                         Row{{-0.1f, -0.2f, 0.1f, 0, 0.2f}, 3}, Row{{0, 0.2f, 0.1f, -0.2f, -0.1f}, 2}}) {
    TestMesh stack;
    for (const float height : row.heights) stack = testing::joined(stack, quad(height));
    const OverdrawCount count = draw(stack, front);
    EXPECT_GT(count.visible, 1500u);
    EXPECT_EQ(count.shaded, row.ratio * count.visible);
    EXPECT_EQ(count.ties, 0u);
  }
}

TEST_F(OverdrawVulkan, holes_show_what_lies_behind) {
  const TestMesh far = quad(-0.1f);
  const TestMesh near = quad(0.1f);
  const Views front = views_of({{0, 0, 1}});
  std::vector<RasterPart> parts = {part_of(far), part_of(near)};
  const std::uint64_t whole = draw(parts, front)[1][0].visible;
  EXPECT_GT(whole, 1000u);
  parts[1].mask = testing::half_a_hole();
  OverdrawCounts counts = draw(parts, front);
  EXPECT_EQ(counts[0][0], (OverdrawCount{whole, whole / 2, 0, 0}));
  EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
  std::swap(parts[0], parts[1]);  // near to far
  counts = draw(parts, front);
  EXPECT_EQ(counts[0][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
  EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
  auto opaque_on_the_left = std::make_shared<Mask>(*parts[0].mask);
  opaque_on_the_left->uv = {{1, 1}, {0, 1}, {1, 0}, {0, 0}};
  parts[1].mask = opaque_on_the_left;  // what the one lets through the other holds
  counts = draw(parts, front);
  EXPECT_EQ(counts[0][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
  EXPECT_EQ(counts[1][0], (OverdrawCount{whole / 2, whole / 2, 0, 0}));
}

TEST_F(OverdrawVulkan, holes_are_where_the_exact_one_has_them) {
  const TestMesh mesh = testing::shuffled(testing::sphere(24, 16), 1);
  Random random(5);
  auto image = std::make_shared<AlphaImage>(AlphaImage{7, 5, {}});
  for (int i = 0; i < 35; ++i) image->alpha.push_back(static_cast<std::uint16_t>(65535 * random.unit()));
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::clamped}) {
    for (const bool is_nearest : {false, true}) {
      auto mask = std::make_shared<Mask>(Mask{image, {{wrap, Wrap::mirrored}, is_nearest}, {}, {}, 0.4});
      for (const glm::vec3& position : mesh.positions) {
        mask->uv.emplace_back(1.3 * position.x - 0.2, 1.7 * position.y + 0.4);
        mask->alphas.push_back(0.9 + 0.1 * position.z);
      }
      RasterPart part = part_of(mesh, false);
      part.mask = mask;
      for (const double distance : {0.0, 3.0}) {
        const Views views = all_sides(128, distance, 5);
        const std::vector<std::uint32_t> order = testing::rising_order(mesh.indices.size() / 3);
        const OverdrawCount exact = total({testing::painted({&part, 1}, views, order)});
        const OverdrawCount count = total(draw({&part, 1}, views));
        EXPECT_NEAR(static_cast<double>(count.visible) / static_cast<double>(exact.visible), 1, 0.001);
        EXPECT_NEAR(static_cast<double>(count.shaded) / static_cast<double>(exact.shaded), 1, 0.001);
        EXPECT_LT(exact.visible, 128u * 128 * 5 * 0.75);
      }
    }
  }
}

TEST_F(OverdrawVulkan, nested_shells_cost_their_number_from_inside_out_and_nothing_from_outside_in) {
  constexpr int shells = 6;
  std::vector<TestMesh> meshes;
  for (int i = 0; i < shells; ++i) meshes.push_back(testing::sphere(48, 32, 0.95f + 0.01f * static_cast<float>(i)));
  const Views views = all_sides(128);
  const OverdrawCounts out = draw(parts_of(meshes), views);
  const OverdrawCount all = total(out);
  double expected = 0;
  for (int i = 0; i < shells; ++i) {
    expected += std::pow(0.95 + 0.01 * i, 2);
    EXPECT_EQ(total({out[static_cast<std::size_t>(i)]}).visible, i + 1 < shells ? 0u : all.visible);
  }
  EXPECT_NEAR(static_cast<double>(all.shaded) / static_cast<double>(all.visible), expected, 0.01);

  std::reverse(meshes.begin(), meshes.end());
  const OverdrawCounts in = draw(parts_of(meshes), views);
  EXPECT_EQ(total(in).visible, all.visible);
  EXPECT_LE(total(in).shaded, all.visible + all.visible / 10000);

  std::swap(meshes[0], meshes[shells - 1]);  // the smallest, the middle ones inwards, the largest
  const double mixed = std::pow(0.95, 2) + std::pow(0.99, 2) + 1;
  const OverdrawCount some = total(draw(parts_of(meshes), views));
  EXPECT_NEAR(static_cast<double>(some.shaded) / static_cast<double>(some.visible), mixed, 0.01);
}

TEST_F(OverdrawVulkan, equally_near_fragments_do_not_pass_and_are_ties) {
  const std::vector<TestMesh> twice = {quad(0), quad(0), quad(0)};
  const OverdrawCounts counts = draw(parts_of(twice), views_of({{0, 0, 1}, {0, 0, -1}}));
  EXPECT_GT(counts[0][0].visible, 1500u);
  EXPECT_EQ(counts[0][0], (OverdrawCount{counts[0][0].visible, counts[0][0].visible, 0}));
  EXPECT_EQ(counts[1][0], (OverdrawCount{0, 0, counts[0][0].visible}));
  EXPECT_EQ(counts[2][0], counts[1][0]);
  for (const auto& part : counts) EXPECT_EQ(part[1], OverdrawCount());  // culled
}

TEST_F(OverdrawVulkan, a_mirrored_part_shows_its_other_faces_and_a_double_sided_one_both) {
  const TestMesh mesh = quad(0);
  RasterPart part = part_of(mesh);
  const Views views = views_of({{0, 0, 1}, {0, 0, -1}});
  const std::uint64_t seen = draw({&part, 1}, views)[0][0].visible;
  EXPECT_GT(seen, 1500u);
  EXPECT_EQ(draw({&part, 1}, views)[0][1].visible, 0u);
  part.is_mirrored = true;
  EXPECT_EQ(draw({&part, 1}, views)[0][0].visible, 0u);
  EXPECT_EQ(draw({&part, 1}, views)[0][1].visible, seen);
  part.culls_back_faces = false;
  EXPECT_EQ(draw({&part, 1}, views)[0][0].visible, seen);
  EXPECT_EQ(draw({&part, 1}, views)[0][1].visible, seen);
}

TEST_F(OverdrawVulkan, parts_sum_to_what_they_are_as_one) {
  const std::vector<TestMesh> meshes = {testing::tangle(1, false), testing::shuffled(testing::torus(24, 12), 2),
                                        testing::tangle(3, false)};
  TestMesh whole;
  for (const TestMesh& mesh : meshes) whole = testing::joined(whole, mesh);
  for (const double distance : {0.0, 1.5}) {
    const OverdrawCounts apart = draw(parts_of(meshes), all_sides(100, distance));
    EXPECT_EQ(total(apart), draw(whole, all_sides(100, distance)));
    for (const auto& part : apart) EXPECT_GT(total({part}).shaded, 1000u);
  }
}

// --- what hardly is there
// ----------------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, nothing_is_drawn_of_nothing) {
  const Views views = all_sides();
  EXPECT_TRUE(draw(std::span<const RasterPart>(), views).empty());
  EXPECT_EQ(draw(TestMesh(), views), OverdrawCount());
  EXPECT_EQ(draw(TestMesh{{{1, 1, 1}}, {0, 0, 0}}, views), OverdrawCount());
  EXPECT_TRUE(draw(std::vector<RasterPart>(1), views_of({}))[0].empty());
  EXPECT_TRUE(draw(parts_of(std::vector{quad(0)}), views_of({}))[0].empty());
}

TEST_F(OverdrawVulkan, parts_without_triangles_keep_their_place) {
  const std::vector<TestMesh> meshes = {TestMesh(), quad(-0.1f), TestMesh{{{5, 5, 5}}, {}}, quad(0.1f), TestMesh()};
  const OverdrawCounts counts = draw(parts_of(meshes), views_of({{0, 0, 1}}));
  ASSERT_EQ(counts.size(), meshes.size());
  const std::uint64_t pixels = counts[3][0].visible;
  EXPECT_GT(pixels, 1500u);
  EXPECT_EQ(counts[1][0], (OverdrawCount{pixels, 0, 0}));
  EXPECT_EQ(counts[3][0], (OverdrawCount{pixels, pixels, 0}));
  for (const std::size_t empty : {0, 2, 4}) EXPECT_EQ(counts[empty][0], OverdrawCount());
}

TEST_F(OverdrawVulkan, one_triangle_covers_its_area) {
  const TestMesh triangle = {{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};
  // The sphere is around the middle of the box, (0, 0.5, 0), out to the corners below: radius sqrt(1.25).
  const double pixels = std::pow(256, 2) / 1.25;
  const OverdrawCount count = draw(triangle, views_of({{0, 0, 1}}, 512));
  EXPECT_NEAR(static_cast<double>(count.visible), pixels, pixels / 200);
  EXPECT_EQ(count.shaded, count.visible);
}

TEST_F(OverdrawVulkan, triangles_with_positions_that_are_not_finite_are_left_out) {
  TestMesh mesh = testing::shuffled(testing::torus(20, 10), 1);
  const OverdrawCount before = draw(mesh, all_sides(), false);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
  mesh.positions.emplace_back(0, std::numeric_limits<float>::infinity(), 0);
  mesh.positions.emplace_back(std::numeric_limits<float>::max(), 0, 0);  // finite, but nobody uses it
  mesh.indices.insert(mesh.indices.begin(), {0, 1, first, first + 1, 0, 1, 0, 0, 1, 0, 3, 3});
  EXPECT_EQ(draw(mesh, all_sides(), false), before);
}

// --- where it looks from
// -----------------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, size_and_place_of_a_subject_do_not_matter) {
  const TestMesh mesh = testing::tangle(6, false);
  for (const double distance : {0.0, 2.0}) {
    const OverdrawCount count = draw(mesh, all_sides(100, distance));
    for (const float scale : {0x1p66f, 0x1p-66f}) {
      TestMesh scaled = mesh;
      for (glm::vec3& position : scaled.positions) position *= scale;
      EXPECT_EQ(draw(scaled, all_sides(100, distance)), count);
    }
  }
}

TEST_F(OverdrawVulkan, counts_the_same_again_and_on_a_device_opened_anew) {
  const TestMesh mesh = testing::tangle(7, false);
  const RasterPart part = part_of(mesh);
  const OverdrawCounts counts = draw({&part, 1}, all_sides(200));
  EXPECT_EQ(draw({&part, 1}, all_sides(200)), counts);
  draw({&part, 1}, all_sides(50));  // other pictures in between
  EXPECT_EQ(draw({&part, 1}, all_sides(200)), counts);
  renew();
  EXPECT_EQ(draw({&part, 1}, all_sides(200)), counts);
}

TEST_F(OverdrawVulkan, more_views_than_fit_into_a_batch_count_as_each_alone) {
  const std::vector<TestMesh> meshes = {testing::tangle(8, false), testing::torus(12, 8)};
  const std::vector<RasterPart> parts = parts_of(meshes);
  const Views views = all_sides(1200, 0, 7);
  ASSERT_LT(device().painter().pictures(1200).count(), 4u);
  const OverdrawCounts counts = draw(parts, views);
  for (std::size_t v = 0; v < views.views.size(); ++v) {
    const OverdrawCounts alone = draw(parts, Views{{views.views[v]}, views.size});
    for (std::size_t part = 0; part < parts.size(); ++part) EXPECT_EQ(alone[part][0], counts[part][v]);
  }
}

TEST_F(OverdrawVulkan, many_parts_and_many_views_of_small_pictures) {
  std::vector<TestMesh> meshes;
  for (int i = 0; i < 300; ++i) meshes.push_back(quad(static_cast<float>(i - 150) / 300));
  const OverdrawCounts counts = draw(parts_of(meshes), all_sides(16, 0, 150));
  EXPECT_EQ(counts[299].size(), 150u);
  for (std::size_t v = 0; v < 150; ++v) {
    OverdrawCount sum;
    for (const auto& part : counts) sum += part[v];
    EXPECT_GE(sum.shaded, sum.visible);
    EXPECT_EQ(counts[299][v].shaded, counts[299][v].visible);
  }
}

TEST_F(OverdrawVulkan, what_is_near_hides_what_is_a_little_farther) {
  struct Row {
    double distance;
    float gap;  // in radii
  };
  // As far behind the centre as it gets, where depth is coarsest.
  for (const Row& row : {Row{0, 1e-6f}, Row{3, 2e-6f}, Row{1.5, 4e-6f}, Row{1.01, 1e-4f}}) {
    TestMesh mesh = testing::joined(quad(-0.5f, 0.3f), quad(-0.5f + row.gap, 0.3f));
    mesh = testing::joined(mesh, {{{0, 0, 1}, {0, 0, 1}, {0, 0, -1}}, {0, 1, 2}});  // sets the sphere
    const OverdrawCount count = draw(mesh, views_of({{0, 0, 1}}, 512, row.distance));
    EXPECT_GT(count.visible, 100u);
    EXPECT_EQ(count.shaded, 2 * count.visible) << row.distance;
    EXPECT_EQ(count.ties, 0u) << row.distance;
  }
}

// --- against the exact rasteriser
// --------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, differs_from_the_exact_rasteriser_by_rounding_alone) {
  // llvmpipe snaps to 1/256 pixel as the rasteriser does, from floats: at most 15 of 4.8 million fragments differed.
  // Other devices may have 1/16 pixel.
  const double allowed = device().is_processor() ? 1e-5 : 1e-2;
  const auto near = [&](std::uint64_t counted, std::uint64_t exact) {
    return std::abs(static_cast<double>(counted) - static_cast<double>(exact)) <=
           6 + allowed * static_cast<double>(exact);
  };
  for (const double distance : {0.0, 1.01, 1.5, 3.0, 1e6}) {
    const Views views = all_sides(200, distance, 12);
    for (const TestMesh& mesh : {testing::shuffled(testing::torus(60, 40), 1), testing::sphere(40, 20),
                                 testing::tangle(1, false), testing::tangle(2, true)}) {
      for (const bool culls : {true, false}) {
        const RasterPart part = part_of(mesh, culls);
        OverdrawCount exact;
        for (const OverdrawCount& count :
             testing::painted({&part, 1}, views, testing::rising_order(mesh.indices.size() / 3))) {
          exact += count;
        }
        const OverdrawCount counted = draw(mesh, views, culls);
        EXPECT_TRUE(near(counted.shaded, exact.shaded)) << counted.shaded << " for " << exact.shaded;
        EXPECT_TRUE(near(counted.visible, exact.visible)) << counted.visible << " for " << exact.visible;
        EXPECT_TRUE(near(counted.ties, exact.ties)) << counted.ties << " for " << exact.ties;
      }
    }
  }
}

// --- what the device says besides
// --------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, vertex_shader_runs_once_for_each_vertex_at_least_and_each_corner_at_most) {
  const std::vector<TestMesh> meshes = {testing::sphere(40, 20), TestMesh(), testing::soup(100, 1),
                                        testing::shuffled(testing::sphere(40, 20), 3)};
  const auto invocations = vertex_shader_invocations(device(), parts_of(meshes));
  ASSERT_EQ(invocations.has_value(), device().painter().device().counts_vertices());
  if (!invocations) GTEST_SKIP() << "this device does not count vertices";
  ASSERT_EQ(invocations->size(), meshes.size());
  for (const std::size_t i : {0, 3}) {
    EXPECT_GE((*invocations)[i], meshes[i].positions.size() - 2 * 39);  // of the poles one vertex each is used
    EXPECT_LE((*invocations)[i], meshes[i].indices.size());
  }
  EXPECT_EQ((*invocations)[1], 0u);
  EXPECT_EQ((*invocations)[2], 300u);
  EXPECT_LT((*invocations)[0], (*invocations)[3]);  // an order that jumps about costs vertices
  EXPECT_EQ(vertex_shader_invocations(device(), parts_of(meshes)), invocations);
  EXPECT_EQ(vertex_shader_invocations(device(), parts_of(std::vector<TestMesh>(2))), std::vector<std::uint64_t>(2));
}

TEST_F(OverdrawVulkan, light_and_heavy_fragments_take_time) {
  const std::vector<TestMesh> meshes = {testing::sphere(16, 8)};
  const auto time = gpu_time(device(), parts_of(meshes), all_sides(64, 0, 4));
  if (!time) GTEST_SKIP() << "this device has no clock";
  EXPECT_GT(time->light, 0);
  EXPECT_GT(time->heavy, 0);
  EXPECT_EQ(gpu_time(device(), {}, all_sides())->light, 0);
}

// --- what can not be had
// -----------------------------------------------------------------------------------------------

TEST_F(OverdrawVulkan, pictures_too_large_for_the_device_are_refused) {
  const std::vector<TestMesh> meshes = {quad(0)};
  try {
    draw(parts_of(meshes), views_of({{0, 0, 1}}, 1 << 20));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("smaller size"), std::string::npos) << error.what();
  }
  EXPECT_GT(draw(quad(0), views_of({{0, 0, 1}})).visible, 1500u);  // the device is whole
}

}  // namespace
}  // namespace foredraw::overdraw_vulkan_test
