#include "plugins/processors/sprite_frames/sprite_frames.h"

#include "plugins/processors/sprite_frames/image_parts.h"
#include "support/meshes.h"
#include "support/sprite_painter.h"
#include "support/sprite_scenes.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace foredraw::sprite_frames_test {
namespace {

/// Of rows of text: what is no space shows.
AlphaImage drawn(const std::vector<std::string>& rows) {
  AlphaImage image{static_cast<std::uint32_t>(rows[0].size()), static_cast<std::uint32_t>(rows.size()), {}};
  for (const std::string& row : rows) {
    for (const char c : row) image.alpha.push_back(c == ' ' ? 0 : 65535);
  }
  return image;
}

SpriteFrame whole_of(const AlphaImage& image) { return {0, 0, image.width, image.height}; }

std::vector<SpriteFrame> found(const AlphaImage& image, int gutter = 1) {
  return found_frames(image, whole_of(image), {.find = true, .gutter = gutter});
}

TEST(SpriteFrames, a_grid_has_its_edges_at_the_nearest_texels) {
  using Frames = std::vector<SpriteFrame>;
  EXPECT_EQ(grid_frames({5, 7, 10, 4}, 3, 2),
            (Frames{{5, 7, 3, 2}, {8, 7, 4, 2}, {12, 7, 3, 2}, {5, 9, 3, 2}, {8, 9, 4, 2}, {12, 9, 3, 2}}));
  EXPECT_EQ(grid_frames({0, 0, 3, 1}, 2, 1), (Frames{{0, 0, 2, 1}, {2, 0, 1, 1}}));
  EXPECT_EQ(grid_frames({0, 0, 1, 1}, 1, 1), (Frames{{0, 0, 1, 1}}));
  EXPECT_EQ(grid_frames({0, 0, 1024, 3}, 1024, 3).size(), 3072u);
  EXPECT_THROW(grid_frames({0, 0, 3, 4}, 4, 1), std::invalid_argument);
  EXPECT_THROW(grid_frames({0, 0, 3, 4}, 1, 5), std::invalid_argument);
}

TEST(SpriteFrames, parts_get_a_margin_as_far_as_the_frame_reaches) {
  EXPECT_EQ(found(drawn({"      ", "  #   ", "   # #"})), (std::vector<SpriteFrame>{{1, 0, 4, 3}, {4, 1, 2, 2}}));
  EXPECT_EQ(found(drawn({"#"})), (std::vector<SpriteFrame>{{0, 0, 1, 1}}));
  EXPECT_TRUE(found(drawn({"  ", "  "})).empty());
  EXPECT_EQ(found(drawn({"###", "###"})), (std::vector<SpriteFrame>{{0, 0, 3, 2}}));
}

TEST(SpriteFrames, what_lies_outside_of_the_frame_does_not_count) {
  const AlphaImage image = drawn({"#    #", "  ##  ", "#    #"});
  EXPECT_EQ(found_frames(image, {1, 1, 4, 1}, {.find = true}), (std::vector<SpriteFrame>{{1, 1, 4, 1}}));
  EXPECT_EQ(found_frames(image, {1, 0, 4, 3}, {.find = true}), (std::vector<SpriteFrame>{{1, 0, 4, 3}}));
}

TEST(SpriteFrames, the_gutter_says_what_parts_two_parts) {
  const AlphaImage image = drawn({"#  #   #"});
  EXPECT_EQ(found(image, 1).size(), 3u);
  EXPECT_EQ(found(image, 2).size(), 3u);
  EXPECT_EQ(found(image, 3).size(), 2u);
  EXPECT_EQ(found(image, 4).size(), 1u);
  EXPECT_EQ(found(image, 1024).size(), 1u);
}

TEST(SpriteFrames, the_threshold_is_of_what_shows) {
  const AlphaImage image{4, 1, {1, 0, 0, 32768}};
  const auto count = [&](double threshold) {
    return found_frames(image, whole_of(image), {.find = true, .threshold = threshold}).size();
  };
  EXPECT_EQ(count(0), 2u);
  EXPECT_EQ(count(0.5), 1u);
  EXPECT_EQ(count(0.51), 0u);
  EXPECT_EQ(count(1), 0u);
}

TEST(SpriteFrames, parts_whose_rectangles_overlap_or_touch_are_one) {
  EXPECT_EQ(found(drawn({"####", "#   ", "#  #"})).size(), 1u);
  EXPECT_EQ(found(drawn({"#    ", "#    ", "  ###", "#    ", "#    "})).size(), 3u);
  EXPECT_EQ(found(drawn({"## ## ## ## ", "            ", "## ## ## ## "})).size(), 8u);
  // Each one reaches into the next one's rectangle only after it was united with the one before.
  EXPECT_EQ(found(drawn({"#######   ", "#         ", "#   ####  ", "#      #  ", "#    # #  ", "        ##"})).size(),
            1u);
}

TEST(SpriteFrames, parts_are_read_line_by_line_from_the_left) {
  const std::vector<SpriteFrame> frames = found(drawn(
      {"   ##   ##    ", "#  ##   ##  # ", "#           # ", "#           # ", "              ", "##      ##    "}));
  std::vector<std::uint32_t> lefts;
  for (const SpriteFrame& frame : frames) lefts.push_back(frame.x);
  EXPECT_EQ(lefts, (std::vector<std::uint32_t>{2, 7, 0, 11, 0, 7}));
}

/// By looking at every pair of texels.
std::vector<TexelBox> naive_parts(const AlphaImage& image, std::int64_t reach) {
  std::vector<std::array<std::int64_t, 2>> texels;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      if (image.at(x, y) > 0) texels.push_back({x, y});
    }
  }
  std::vector<std::size_t> part(texels.size());
  std::iota(part.begin(), part.end(), 0u);
  for (std::size_t a = 0; a < texels.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const std::int64_t dx = std::abs(texels[a][0] - texels[b][0]), dy = std::abs(texels[a][1] - texels[b][1]);
      if (dx <= reach && dy <= reach)
        std::replace(part.begin(), part.end(), std::size_t{part[a]}, std::size_t{part[b]});
    }
  }
  std::map<std::size_t, TexelBox> boxes;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    boxes[part[i]].add({texels[i][0], texels[i][1], texels[i][0], texels[i][1]});
  }
  std::vector<TexelBox> all;
  for (const auto& [number, box] : boxes) all.push_back(box);
  return all;
}

std::vector<std::array<std::int64_t, 4>> sorted(const std::vector<TexelBox>& boxes) {
  std::vector<std::array<std::int64_t, 4>> all;
  for (const TexelBox& box : boxes) all.push_back({box.left, box.top, box.right, box.bottom});
  std::ranges::sort(all);
  return all;
}

TEST(SpriteFrames, parts_are_exact) {
  Random random(11);
  for (int round = 0; round < 300; ++round) {
    AlphaImage image{
        static_cast<std::uint32_t>(1 + random.below(24)), static_cast<std::uint32_t>(1 + random.below(24)), {}};
    image.alpha.resize(std::size_t{image.width} * image.height);
    const std::uint64_t one_in = 2 + random.below(30);
    for (std::uint16_t& alpha : image.alpha) alpha = random.below(one_in) == 0 ? 1 : 0;
    for (const std::uint32_t reach : {1u, 2u, 3u, 5u, 30u}) {
      EXPECT_EQ(sorted(image_parts(image, whole_of(image), 0, reach)), sorted(naive_parts(image, reach)));
    }
  }
}

TEST(SpriteFrames, thousands_of_specks_are_refused) {
  AlphaImage image{512, 512, std::vector<std::uint16_t>(512 * 512, 0)};
  for (std::size_t y = 0; y < 512; y += 2) {
    for (std::size_t x = 0; x < 512; x += 2) image.alpha[512 * y + x] = 9;
  }
  EXPECT_THROW(found(image), std::runtime_error);
  EXPECT_EQ(found(image, 2).size(), 1u);
}

struct Cutting {
  Scene scene;
  std::vector<DrawId> answer;
  Findings findings;
};

Cutting cut(Scene scene, const Settings& settings) {
  Analyses analyses(testing::stored_texels());
  const Executor executor(2);
  Cutting cutting{std::move(scene), {}, {}};
  const Views views;
  Run run{analyses, executor, cutting.findings, views};
  std::vector<DrawId> draws(cutting.scene.draws.size());
  std::iota(draws.begin(), draws.end(), 0u);
  const Technique technique = sprite_frames_plugin().create(settings);
  cutting.answer = std::get<std::unique_ptr<Processor>>(technique)->process(cutting.scene, draws, run);
  return cutting;
}

const Settings three_by_two = {{"columns", std::int64_t{3}}, {"rows", std::int64_t{2}}};

Scene noisy_sheet(std::uint32_t width, std::uint32_t height) {
  AlphaImage image{width, height, {}};
  Random random(width);
  for (std::uint32_t i = 0; i < width * height; ++i)
    image.alpha.push_back(static_cast<std::uint16_t>(random.below(65536)));
  return testing::sprite_scene(testing::texel_image(image), "sheet");
}

TEST(SpriteFrames, every_frame_has_a_draw_a_mesh_and_a_node) {
  Scene sheet = noisy_sheet(10, 4);
  sheet.animations.push_back({"rise", {{.node = 0}}});
  const Scene scene = cut(sheet, three_by_two).scene;
  ASSERT_EQ(scene.draws.size(), 6u);
  ASSERT_EQ(scene.meshes.size(), 6u);
  ASSERT_EQ(scene.nodes.size(), 7u);
  EXPECT_FALSE(scene.nodes[0].mesh);
  EXPECT_EQ(scene.nodes[0].name, "sheet");
  EXPECT_EQ(scene.animations[0].channels[0].node, 0u);
  EXPECT_EQ(scene.nodes[0].children, (std::vector<NodeId>{1, 2, 3, 4, 5, 6}));
  for (DrawId i = 0; i < 6; ++i) {
    EXPECT_EQ(scene.draws[i].name, "sheet/" + std::to_string(i));
    EXPECT_EQ(scene.draws[i].frame, grid_frames({0, 0, 10, 4}, 3, 2)[i]);
    EXPECT_EQ(scene.draws[i].traits, sheet.draws[0].traits);
    EXPECT_EQ(scene.nodes[i + 1].mesh, i);
    EXPECT_EQ(scene.meshes[i].draws, (std::vector<DrawId>{i}));
  }
  EXPECT_EQ(cut(sheet, {{"columns", std::int64_t{10}}, {"rows", std::int64_t{2}}}).scene.draws[7].name, "sheet/07");
}

TEST(SpriteFrames, nodes_that_share_a_mesh_and_draws_that_share_one_stay_so) {
  Scene sheet = noisy_sheet(6, 6);
  sheet.nodes.push_back(sheet.nodes[0]);
  sheet.draws.push_back(testing::draw_of(testing::grid(1, 1), "stays"));
  sheet.meshes[0].draws.push_back(1);
  const Cutting cutting = cut(sheet, {{"columns", std::int64_t{2}}});
  const Scene& scene = cutting.scene;
  EXPECT_EQ(cutting.answer, (std::vector<DrawId>{0, 2}));
  EXPECT_EQ(scene.meshes[0].draws, (std::vector<DrawId>{1}));
  ASSERT_EQ(scene.nodes.size(), 6u);
  for (const NodeId n : {0u, 1u}) {
    EXPECT_EQ(scene.nodes[n].mesh, 0u);
    ASSERT_EQ(scene.nodes[n].children.size(), 2u);
    EXPECT_EQ(scene.nodes[scene.nodes[n].children[0]].mesh, 1u);
    EXPECT_EQ(scene.nodes[scene.nodes[n].children[1]].mesh, 2u);
  }
  ASSERT_EQ(cutting.findings.notes.size(), 1u);
  EXPECT_EQ(cutting.findings.notes[0].about.draw, 1u);
}

/// Positions and places of corners, so that what shows a place is known to lie where it did.
void expect_same_map(const Draw& before, const Draw& after) {
  const auto corners = [](const Draw& draw) {
    return std::pair(decode_vec3(*draw.levels[0].vertices->find("POSITION")),
                     decode_vec3(*draw.levels[0].vertices->find("TEXCOORD_0")));
  };
  const auto [p, t] = corners(before);
  const auto [q, s] = corners(after);
  // The fourth corner is along the one side, the second along the other.
  const glm::vec2 u = t[1] - t[0], v = t[3] - t[0];
  const float area = u.x * v.y - u.y * v.x;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const glm::vec2 off = s[i] - t[0];
    const float a = (off.x * v.y - off.y * v.x) / area, b = (u.x * off.y - u.y * off.x) / area;
    const glm::vec3 place = p[0] + a * (p[1] - p[0]) + b * (p[3] - p[0]);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(q[i][axis], place[axis], 1e-4f);
  }
}

TEST(SpriteFrames, cells_together_are_the_picture_that_there_was) {
  const Scene sheet = noisy_sheet(20, 11);
  const Cutting cutting = cut(sheet, three_by_two);
  const std::vector<AlphaImage> levels =
      testing::levels_of(alpha_image(std::get<Texels>(testing::stored_texels()(sheet.images[0]))));
  for (const double scale : {1.0, 0.37, 2.5}) {
    const testing::SpriteStand stand{scale, 0.7, {0.3, 0.9}, testing::SpriteFilter::trilinear};
    const testing::SpritePicture whole = testing::painted(sheet, sheet.draws[0], levels, stand);
    testing::SpritePicture cells;
    for (const Draw& draw : cutting.scene.draws) {
      for (const auto& [at, pixel] : testing::painted(cutting.scene, draw, levels, stand)) {
        cells[at].alpha = pixel.alpha;
        cells[at].times += pixel.times;
      }
    }
    EXPECT_EQ(testing::differing_pixels(whole, cells, -1), 0u);
  }
  for (const Draw& draw : cutting.scene.draws) expect_same_map(sheet.draws[0], draw);
}

TEST(SpriteFrames, quads_may_be_turned_mirrored_or_moved_by_their_texture) {
  const Scene sheet = noisy_sheet(12, 8);
  const std::vector<std::vector<glm::vec2>> all = {{{1, 1}, {1, 0}, {0, 0}, {0, 1}}, {{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
  for (const std::vector<glm::vec2>& texcoords : all) {
    Scene turned = sheet;
    VertexStreams vertices = *sheet.draws[0].levels[0].vertices;
    const auto bytes = std::as_bytes(std::span(texcoords));
    vertices.base[1].bytes = Shared<std::byte>({bytes.begin(), bytes.end()});
    turned.draws[0].levels[0].vertices = std::make_shared<const VertexStreams>(std::move(vertices));
    const Cutting cutting = cut(turned, three_by_two);
    ASSERT_EQ(cutting.scene.draws.size(), 6u);
    for (const Draw& draw : cutting.scene.draws) expect_same_map(turned.draws[0], draw);
  }
  Scene moved = sheet;
  moved.materials[0].base_colour->scale = {1, -1};
  moved.materials[0].base_colour->offset = {0, 1};
  EXPECT_EQ(cut(moved, three_by_two).scene.draws.size(), 6u);
  moved.materials[0].base_colour->offset = {0, 0.5};
  EXPECT_EQ(cut(moved, three_by_two).scene.draws.size(), 1u);
}

TEST(SpriteFrames, finds_parts_of_images_of_any_depth) {
  Scene sheet = testing::sprite_scene(testing::texel_image({5, 1, 1, 8, false}, {255, 0, 0, 0, 1}));
  const Cutting by_luminance = cut(sheet, {{"find", true}, {"channel", "luminance"}});
  ASSERT_EQ(by_luminance.scene.draws.size(), 2u);
  EXPECT_EQ(by_luminance.scene.draws[1].frame, (SpriteFrame{3, 0, 2, 1}));
  EXPECT_EQ(by_luminance.findings.measured[0].numerator, 2);
  // It has no alpha, so it is opaque.
  const Cutting by_alpha = cut(sheet, {{"find", true}});
  EXPECT_TRUE(by_alpha.findings.nothing_to_gain);
  EXPECT_EQ(by_alpha.findings.notes[0].message, "not cut into frames: it is a single part that fills its frame");
  const Cutting one =
      cut(testing::sprite_scene(testing::texel_image({1, 1, 4, 16, false}, {1, 2, 3, 0})), {{"find", true}});
  EXPECT_EQ(one.findings.notes[0].message, "not cut into frames: no texel is above the threshold");
}

TEST(SpriteFrames, leaves_alone_what_can_not_be_cut_and_says_why) {
  const auto why = [](const Scene& scene) {
    const Cutting cutting = cut(scene, three_by_two);
    EXPECT_EQ(cutting.scene.draws.size(), scene.draws.size());
    EXPECT_TRUE(cutting.findings.nothing_to_gain);
    return cutting.findings.notes.empty() ? "" : cutting.findings.notes[0].message.substr(21);
  };
  const Scene sheet = noisy_sheet(10, 4);
  EXPECT_EQ(why(noisy_sheet(2, 4)), "2 x 4 texels cannot be cut into 3 columns and 2 rows");
  Scene scene = sheet;
  scene.draws[0].frame.reset();
  EXPECT_EQ(why(scene), "it was not made from an image, so it has no frame");
  scene = sheet;
  scene.draws[0].frame = SpriteFrame{0, 0, 9, 4};
  EXPECT_EQ(why(scene), "its quad does not show exactly its frame of the image");
  scene.draws[0].frame = SpriteFrame{4, 0, 10, 4};
  EXPECT_EQ(why(scene), "its frame is empty or extends beyond the image");
  scene = sheet;
  scene.draws[0].levels[0].orders[0].indices = Shared<std::uint32_t>({0, 1, 2});
  EXPECT_EQ(why(scene), "it is not a single quad; put sprite-frames before particle-trim");
  EXPECT_TRUE(cut(sheet, {}).findings.nothing_to_gain);
  EXPECT_THROW(cut(sheet, {{"find", true}, {"rows", std::int64_t{2}}}), std::invalid_argument);
  scene = sheet;
  scene.images[0].bytes = {};
  EXPECT_THROW(cut(scene, {{"find", true}}), std::runtime_error);
}

}  // namespace
}  // namespace foredraw::sprite_frames_test
