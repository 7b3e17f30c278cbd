// Sprites trimmed, and painted beside their quads.
#include <plugins/processors/particle_trim/footprint.h>
#include <plugins/processors/particle_trim/particle_trim.h>

#include "support/sprite_painter.h"
#include "support/sprite_scenes.h"

#include <foredraw/base/random.h>
#include <foredraw/image/sprite_pieces.h>
#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foredraw::particle_trim_sprites_test {
namespace {

struct Trimming {
  Scene scene;
  std::vector<DrawId> answer;
  Findings findings;

  double figure(const std::string& metric) const {
    for (const Measured& measured : findings.measured) {
      if (measured.metric == metric && measured.about.draw)
        return measured.numerator / measured.denominator.value_or(1);
    }
    return -1;
  }
  std::string note() const { return findings.notes.empty() ? "" : findings.notes.front().code; }
};

Trimming trim(Scene scene, const Settings& settings = {}) {
  Analyses analyses(testing::stored_texels());
  const Executor executor(2);
  Trimming trimming{std::move(scene), {}, {}};
  const Views views;
  Run run{analyses, executor, trimming.findings, views};
  std::vector<DrawId> draws(trimming.scene.draws.size());
  std::iota(draws.begin(), draws.end(), 0u);
  const Technique technique = particle_trim_plugin().create(settings);
  trimming.answer = std::get<std::unique_ptr<Processor>>(technique)->process(trimming.scene, draws, run);
  return trimming;
}

AlphaImage blank(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::uint16_t>(std::size_t{width} * height, 0)};
}

AlphaImage blots(Random& random, std::uint32_t most) {
  AlphaImage image =
      blank(3 + static_cast<std::uint32_t>(random.below(most)), 3 + static_cast<std::uint32_t>(random.below(most)));
  for (int blot = 0; blot < 3; ++blot) {
    const double x = random.unit() * image.width, y = random.unit() * image.height,
                 radius = 1 + random.unit() * most / 4;
    for (std::uint32_t v = 0; v < image.height; ++v) {
      for (std::uint32_t u = 0; u < image.width; ++u) {
        const double from = std::hypot(u + 0.5 - x, v + 0.5 - y) / radius;
        if (from < 1)
          image.alpha[std::size_t{v} * image.width + u] = static_cast<std::uint16_t>(65535 * (1 - from * from));
      }
    }
  }
  return image;
}

Settings with(Settings settings, const std::string& name, OptionValue value) {
  settings[name] = std::move(value);
  return settings;
}

const Settings all_savings = {{"least-saving", 0.0}};

/// The pixels that show in one picture and not, or otherwise, in the other; but for those on the frame's edge, which
/// rounded corners may take in or leave out either way.
std::size_t differing(const AlphaImage& image, const testing::SpriteStand& stand, const testing::SpritePicture& quad,
                      const testing::SpritePicture& trimmed, double threshold) {
  const auto is_on_edge = [&](const std::array<std::int64_t, 2>& pixel) {
    const double x = static_cast<double>(pixel[0]) + 0.5 - stand.offset.x,
                 y = static_cast<double>(pixel[1]) + 0.5 - stand.offset.y;
    const double u = (std::cos(stand.angle) * x + std::sin(stand.angle) * y) / stand.scale;
    const double v = (std::cos(stand.angle) * y - std::sin(stand.angle) * x) / stand.scale;
    const double off = std::min({std::abs(u), std::abs(v), std::abs(u - image.width), std::abs(v - image.height)});
    return off * stand.scale < 2.0 / 256;
  };
  std::size_t count = 0;
  const auto compare = [&](const testing::SpritePicture& from, const testing::SpritePicture& to) {
    for (const auto& [at, pixel] : from) {
      if (!(pixel.alpha > threshold) || is_on_edge(at)) continue;
      const auto found = to.find(at);
      count += found == to.end() || found->second.alpha != pixel.alpha || found->second.times != pixel.times;
    }
  };
  compare(quad, trimmed);
  compare(trimmed, quad);
  return count;
}

TEST(ParticleTrim, paints_every_pixel_that_shows_as_the_quad_does) {
  Random random(31);
  int trimmed_ones = 0;
  for (int round = 0; round < 250; ++round) {
    const AlphaImage image = blots(random, 40);
    Scene scene = testing::sprite_scene(testing::texel_image(image));
    Texture& texture = *scene.materials[0].base_colour;
    texture.wrap = {static_cast<Wrap>(random.below(3)), static_cast<Wrap>(random.below(3))};
    texture.is_nearest = round % 5 == 0;
    const double threshold = round % 2 == 0 ? 0 : random.unit() * 0.5;
    const int mip_levels = static_cast<int>(random.below(3));
    Settings settings = {{"vertices", static_cast<std::int64_t>(3 + random.below(8))},
                         {"threshold", threshold},
                         {"mip-levels", std::int64_t{mip_levels}},
                         {"least-saving", 0.0}};
    if (round % 7 == 0) settings["method"] = std::string("persson");
    if (round % 3 == 0) settings["footprint"] = std::string("bilinear-loose");
    if (round % 4 == 0) settings["uv"] = std::string(round % 8 == 0 ? "float16" : "unorm16");
    const Trimming trimming = trim(scene, settings);
    if (trimming.findings.nothing_to_gain) continue;
    ++trimmed_ones;
    EXPECT_LE(trimming.figure("alpha-lost"), threshold);
    EXPECT_LE(trimming.figure("area"), 1);
    const std::vector<AlphaImage> levels = testing::levels_of(image);
    for (int look = 0; look < 6; ++look) {
      testing::SpriteStand stand;
      stand.filter = texture.is_nearest ? testing::SpriteFilter::nearest
                     : mip_levels == 0  ? testing::SpriteFilter::bilinear
                                        : testing::SpriteFilter::trilinear;
      stand.scale = look == 0 ? 1 : std::exp2(random.unit() * (2 + mip_levels) - mip_levels);
      stand.angle = look < 2 ? 0 : random.unit() * 6.28;
      stand.offset = {random.unit(), random.unit()};
      const auto quad = testing::painted(scene, scene.draws[0], levels, stand);
      const auto polygon = testing::painted(trimming.scene, trimming.scene.draws[0], levels, stand);
      EXPECT_EQ(differing(image, stand, quad, polygon, threshold), 0u)
          << "round " << round << ", scale " << stand.scale << ", angle " << stand.angle;
    }
  }
  EXPECT_GT(trimmed_ones, 150);
}

TEST(ParticleTrim, the_painter_would_see_a_polygon_that_is_too_small) {
  AlphaImage image = blank(16, 16);
  for (std::uint32_t v = 4; v < 12; ++v) std::fill_n(image.alpha.begin() + 16 * v + 4, 8, 65535);
  const Scene scene = testing::sprite_scene(testing::texel_image(image));
  const std::vector<AlphaImage> levels = testing::levels_of(image);
  const Settings texels = {{"footprint", std::string("texels")}, {"mip-levels", std::int64_t{0}}};
  const Trimming trimming = trim(scene, texels);  // while the picture is blended
  const testing::SpriteStand stand{.scale = 4};
  EXPECT_GT(differing(image, stand, testing::painted(scene, scene.draws[0], levels, stand),
                      testing::painted(trimming.scene, trimming.scene.draws[0], levels, stand), 0),
            0u);
}

TEST(ParticleTrim, keeps_every_attribute_running_as_it_runs_over_the_quad) {
  AlphaImage image = blank(64, 32);
  for (std::uint32_t v = 8; v < 20; ++v) std::fill_n(image.alpha.begin() + 64 * v + 20, 4 + v, 40000);
  const Scene scene = testing::sprite_scene(testing::texel_image(image));
  const Trimming trimming = trim(scene);
  ASSERT_EQ(trimming.answer, std::vector<DrawId>{0});
  const Draw& draw = trimming.scene.draws[0];
  const VertexStreams& vertices = *draw.levels[0].vertices;
  EXPECT_LE(vertices.count, 8u);
  EXPECT_EQ(draw.levels[0].orders[0].triangle_count(), vertices.count - 2);
  const auto positions = decode_vec3(*vertices.find("POSITION")), uv = decode_vec3(*vertices.find("TEXCOORD_0"));
  for (std::uint32_t v = 0; v < vertices.count; ++v) {
    EXPECT_NEAR(positions[v].x, uv[v].x * 64, 1e-4);
    EXPECT_NEAR(positions[v].y, uv[v].y * -32, 1e-4);
  }
  EXPECT_TRUE(is_made_of_sprites(draw));
  EXPECT_EQ(draw.frame, scene.draws[0].frame);
  // The quad runs counter-clockwise on the screen.
  const auto area = [&](const Trimming& made) {
    const auto& indices = made.scene.draws[0].levels[0].orders[0].indices.view();
    const auto p = decode_vec3(*made.scene.draws[0].levels[0].vertices->find("TEXCOORD_0"));
    double sum = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const glm::vec3 a = p[indices[i + 1]] - p[indices[i]], b = p[indices[i + 2]] - p[indices[i]];
      sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
  };
  EXPECT_NEAR(area(trimming), -trimming.figure("area"), 1e-5);
  EXPECT_NEAR(area(trim(scene, {{"winding", std::string("clockwise")}})), trimming.figure("area"), 1e-5);
  EXPECT_NEAR(area(trim(scene, {{"winding", std::string("counter-clockwise")}})), -trimming.figure("area"), 1e-5);
}

TEST(ParticleTrim, says_why_it_leaves_a_sprite_as_it_is) {
  const auto code = [](const AlphaImage& image, const Settings& settings = {}) {
    const Trimming trimming = trim(testing::sprite_scene(testing::texel_image(image)), settings);
    EXPECT_TRUE(trimming.findings.nothing_to_gain);
    EXPECT_EQ(trimming.figure("area"), 1);
    return trimming.note();
  };
  AlphaImage full = blank(9, 5);
  std::ranges::fill(full.alpha, 65535);
  EXPECT_EQ(code(full), "full");
  EXPECT_EQ(code(blank(9, 5)), "empty");
  EXPECT_EQ(code(blank(1, 1)), "empty");
  EXPECT_EQ(code({1, 1, {1}}), "full");
  AlphaImage corner = full;
  corner.alpha[0] = 0;
  EXPECT_EQ(code(corner, {{"footprint", std::string("texels")}, {"mip-levels", std::int64_t{0}}}), "no-saving");
  AlphaImage faint = blank(9, 5);
  faint.alpha[20] = 600;
  EXPECT_EQ(code(faint, {{"threshold", 0.01}}), "empty");
}

TEST(ParticleTrim, tells_of_images_without_alpha) {
  const Scene glow = testing::sprite_scene(
      testing::texel_image({3, 3, 3, 8, false}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 9, 9, 9, 0, 0, 0,  //
                                                 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(trim(glow).note(), "no-alpha");
  EXPECT_NE(trim(glow, {{"channel", std::string("luminance")}}).note(), "no-alpha");
}

TEST(ParticleTrim, small_thin_and_wide_images_are_trimmed_right) {
  const Settings plain = {{"mip-levels", std::int64_t{0}}, {"least-saving", 0.0}};
  AlphaImage dot = blank(32, 32);
  dot.alpha[32 * 9 + 20] = 1;
  // A texel blends two by two texels wide.
  EXPECT_NEAR(trim(testing::sprite_scene(testing::texel_image(dot)), plain).figure("area"), 4.0 / 1024, 2e-4);
  EXPECT_NEAR(trim(testing::sprite_scene(testing::texel_image(dot)), with(plain, "footprint", std::string("texels")))
                  .figure("area"),
              1.0 / 1024, 1e-4);
  EXPECT_NEAR(
      trim(testing::sprite_scene(testing::texel_image(dot)), with(plain, "vertices", std::int64_t{3})).figure("area"),
      8.0 / 1024, 4e-4);
  AlphaImage line = blank(16384, 3);
  for (std::uint32_t u = 100; u < 16000; ++u) line.alpha[16384 + u] = 9;
  const Trimming wide = trim(testing::sprite_scene(testing::texel_image(line)), with(plain, "padding", 0.0));
  EXPECT_NEAR(wide.figure("area"), 15901.0 * 2 / (3 * 16384), 8e-3);
  AlphaImage diagonal = blank(256, 256);
  for (std::uint32_t u = 0; u < 256; ++u) diagonal.alpha[257 * u] = 65535;
  const double hairline =
      trim(testing::sprite_scene(testing::texel_image(diagonal)), with(plain, "vertices", std::int64_t{6}))
          .figure("area");
  EXPECT_LT(hairline, 0.02);
  AlphaImage ring = blank(64, 64), disc = ring;
  Random random(7);
  for (int v = 0; v < 64; ++v) {
    for (int u = 0; u < 64; ++u) {
      const double from = std::hypot(u - 31.5, v - 31.5);
      const auto at = static_cast<std::size_t>(64 * v + u);
      if (from < 25) disc.alpha[at] = 65535;
      if (from < 25 && from > 22) ring.alpha[at] = 65535;
    }
  }
  EXPECT_EQ(trim(testing::sprite_scene(testing::texel_image(ring)), plain).figure("area"),
            trim(testing::sprite_scene(testing::texel_image(disc)), plain).figure("area"));
}

TEST(ParticleTrim, reaches_out_of_a_tile_only_where_nothing_shows) {
  // A blade that leans over, in the left tile of two; the right tile is empty, or a wall.
  AlphaImage image = blank(64, 32);
  for (std::uint32_t v = 2; v < 30; ++v) std::fill_n(image.alpha.begin() + 64 * v + 1 + v * 26 / 30, 4, 65535);
  const auto area = [](const AlphaImage& atlas, double threshold) {
    const TrimFrame tile{{0, 0}, {32 * 256, 32 * 256}};
    const auto made = particle_trim(atlas, {{Wrap::clamped, Wrap::clamped}, false}, {&tile, 1},
                                    {.vertices = 3, .threshold = threshold, .mip_levels = 0, .least_saving = 0});
    return std::pair(made[0].outcome, made[0].area);
  };
  const auto [free_outcome, free_area] = area(image, 0);
  EXPECT_EQ(free_outcome, TrimmedSprite::Outcome::trimmed);
  AlphaImage wall = image;
  for (std::uint32_t v = 0; v < 32; ++v) std::fill_n(wall.alpha.begin() + 64 * v + 33, 30, 65535);
  const auto [kept_outcome, kept_area] = area(wall, 0);
  EXPECT_GT(kept_area, free_area);
  // Below the threshold the wall does not show.
  for (std::uint32_t v = 0; v < 32; ++v) std::fill_n(wall.alpha.begin() + 64 * v + 33, 30, 100);
  EXPECT_NEAR(area(wall, 0.01).second, area(image, 0.01).second, 1e-6);
}

TEST(ParticleTrim, frames_may_share_one_shape) {
  AlphaImage image = blank(64, 32);
  for (std::uint32_t v = 10; v < 20; ++v) std::fill_n(image.alpha.begin() + 64 * v + 8, 6, 65535);
  for (std::uint32_t v = 14; v < 26; ++v) std::fill_n(image.alpha.begin() + 64 * v + 32 + 14, 6, 65535);
  const processors::particle_trim::ShownImage shown(image, {{Wrap::clamped, Wrap::clamped}, false},
                                                    processors::particle_trim::FootprintOptions{});
  const std::array<TrimFrame, 2> tiles{{{{0, 0}, {32 * 256, 32 * 256}}, {{32 * 256, 0}, {64 * 256, 32 * 256}}}};
  const auto both = particle_trim(shown, tiles, {.least_saving = 0});
  ASSERT_EQ(both.size(), 2u);
  ASSERT_EQ(both[0].corners.size(), both[1].corners.size());
  for (std::size_t i = 0; i < both[0].corners.size(); ++i) {
    EXPECT_EQ(both[0].corners[i] + glm::dvec2(0.5, 0), both[1].corners[i]);
  }
  const auto alone = particle_trim(shown, {tiles.data(), 1}, {.least_saving = 0});
  EXPECT_LT(alone[0].area, both[0].area);
}

}  // namespace
}  // namespace foredraw::particle_trim_sprites_test
