#include "evaluators/sprite_fill/sprite_fill.h"

#include "support/meshes.h"
#include "support/sprite_painter.h"
#include "support/sprite_scenes.h"

#include <foredraw/technique/plugin.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace foredraw::sprite_fill_test {
namespace {

using Triangles = std::vector<std::uint32_t>;
const std::vector<glm::dvec2> whole_image = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Triangles quad = {0, 1, 2, 0, 2, 3};

AlphaImage image_of(std::uint32_t width, std::uint32_t height, std::uint16_t alpha) {
  return {width, height, std::vector<std::uint16_t>(std::size_t{width} * height, alpha)};
}

/// A disc that touches the edges.
AlphaImage disc(std::uint32_t side) {
  AlphaImage image = image_of(side, side, 0);
  const double radius = side / 2.0;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const double dx = x + 0.5 - radius, dy = y + 0.5 - radius;
      if (dx * dx + dy * dy < (radius - 1.5) * (radius - 1.5)) image.alpha[y * side + x] = 65535;
    }
  }
  return image;
}

/// Half of its texels are empty.
AlphaImage noise(std::uint32_t width, std::uint32_t height, Random& random) {
  AlphaImage image = image_of(width, height, 0);
  for (std::uint16_t& alpha : image.alpha) {
    if (random.below(2) == 0) alpha = static_cast<std::uint16_t>(random.below(65536));
  }
  return image;
}

constexpr std::array<Wrap, 2> clamped = {Wrap::clamped, Wrap::clamped};

SpriteFill fill_of(const std::vector<glm::dvec2>& places, const Triangles& indices, const AlphaImage& image,
                   const SpriteFillOptions& options, const Sampling& sampling = {clamped, false}) {
  const AlphaLevels levels = alpha_levels(std::make_shared<const AlphaImage>(image));
  SpriteFill sum;
  for (const SpriteLook& look : sprite_looks(options)) {
    const SpriteFill fill = sprite_fill(placed_triangles(places, indices), levels, sampling, look, options);
    sum.filled += fill.filled;
    sum.needed += fill.needed;
  }
  return sum;
}

SpriteFill painted_fill(const std::vector<glm::dvec2>& places, const Triangles& indices, const AlphaImage& image,
                        const SpriteFillOptions& options, std::array<Wrap, 2> wrap, testing::SpriteFilter filter) {
  const std::vector<AlphaImage> levels = testing::levels_of(image);
  SpriteFill sum;
  for (const SpriteLook& look : sprite_looks(options)) {
    const testing::SpriteStand stand{look.scale, look.angle, look.offset, filter};
    for (const auto& [at, pixel] : testing::painted(places, indices, levels, wrap, stand)) {
      sum.filled += static_cast<std::uint64_t>(pixel.times);
      if (pixel.alpha > options.threshold) sum.needed += static_cast<std::uint64_t>(pixel.times);
    }
  }
  return sum;
}

TEST(SpriteFill, an_opaque_upright_image_fills_a_pixel_a_texel_and_needs_them_all) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {8u, 8u}, {3u, 17u}}) {
    const SpriteFill fill = fill_of(whole_image, quad, image_of(width, height, 65535), {.scales = "1", .turns = 1});
    EXPECT_EQ(fill.filled, width * height);
    EXPECT_EQ(fill.needed, width * height);
  }
}

TEST(SpriteFill, of_an_empty_image_nothing_is_needed) {
  const SpriteFill fill = fill_of(whole_image, quad, image_of(8, 4, 0), {});
  EXPECT_GT(fill.filled, 0u);
  EXPECT_EQ(fill.needed, 0u);
}

TEST(SpriteFill, a_quad_round_a_disc_fills_four_pixels_for_every_pi_and_an_octagon_less_of_the_same) {
  const AlphaImage image = disc(128);
  const SpriteFillOptions options{.scales = "1 0.5", .turns = 5, .threshold = 0.5};
  const SpriteFill of_quad = fill_of(whole_image, quad, image, options);
  EXPECT_NEAR(static_cast<double>(of_quad.filled) / static_cast<double>(of_quad.needed), 1.273, 0.07);

  const double cut = 1 - std::sqrt(0.5);  // of a regular octagon round the circle
  const std::vector<glm::dvec2> octagon = {{cut, 0},     {1 - cut, 0}, {1, cut},     {1, 1 - cut},
                                           {1 - cut, 1}, {cut, 1},     {0, 1 - cut}, {0, cut}};
  Triangles fan;
  for (std::uint32_t v = 1; v + 1 < octagon.size(); ++v) fan.insert(fan.end(), {0, v, v + 1});
  const SpriteFill of_octagon = fill_of(octagon, fan, image, options);
  EXPECT_EQ(of_octagon.needed, of_quad.needed);
  EXPECT_NEAR(static_cast<double>(of_octagon.filled) / static_cast<double>(of_quad.filled), 0.828, 0.01);
}

TEST(SpriteFill, counts_what_the_plain_painter_paints) {
  Random random(5);
  const std::vector<std::array<std::uint32_t, 2>> sizes = {{1, 1}, {1, 9}, {16, 16}, {13, 6}};
  const std::array<Wrap, 2> wraps[] = {clamped, {Wrap::repeat, Wrap::mirrored}};
  for (const auto& size : sizes) {
    for (const std::array<Wrap, 2>& wrap : wraps) {
      const AlphaImage image = noise(size[0], size[1], random);
      std::vector<glm::dvec2> places = whole_image;
      for (int i = 0; i < 6; ++i) {
        const double x = random.unit(), y = random.unit();
        places.emplace_back(3 * x - 1, 3 * y - 1);
      }
      const Triangles indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 7, 8, 9, 9, 4, 7, 9, 4, 7, 5, 5, 6};
      for (const double threshold : {0.0, 0.3137}) {
        SpriteFillOptions options{.scales = "3.7 1 0.71 0.5 0.3 0.06", .turns = 4, .threshold = threshold};
        const auto compare = [&](testing::SpriteFilter filter) {
          const bool is_nearest = filter == testing::SpriteFilter::nearest;
          options.mipmaps = filter == testing::SpriteFilter::trilinear;
          const SpriteFill fill = fill_of(places, indices, image, options, {wrap, is_nearest});
          const SpriteFill painted = painted_fill(places, indices, image, options, wrap, filter);
          EXPECT_EQ(fill.filled, painted.filled);
          EXPECT_EQ(fill.needed, painted.needed) << size[0] << " x " << size[1] << ", " << static_cast<int>(filter);
          EXPECT_TRUE(size[0] == 1 || (fill.needed > 0 && fill.needed < fill.filled));
        };
        compare(testing::SpriteFilter::nearest);
        compare(testing::SpriteFilter::bilinear);
        compare(testing::SpriteFilter::trilinear);
      }
    }
  }
}

TEST(SpriteFill, triangles_that_share_edges_fill_each_pixel_once_and_overlaps_fill_it_twice) {
  const AlphaImage image = image_of(32, 20, 65535);
  const SpriteFillOptions options{.scales = "1 0.4", .turns = 7};
  std::vector<glm::dvec2> places = whole_image;
  places.emplace_back(0.3, 0.71);
  const SpriteFill of_quad = fill_of(whole_image, quad, image, options);
  EXPECT_EQ(fill_of(places, {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4}, image, options).filled, of_quad.filled);
  EXPECT_EQ(fill_of(places, {0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0}, image, options).filled, of_quad.filled);
  EXPECT_EQ(fill_of(places, {0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3}, image, options).needed, 2 * of_quad.needed);
  EXPECT_EQ(fill_of(places, {0, 1, 2, 0, 2, 3, 0, 1, 3, 1, 2, 3}, image, options).filled, 2 * of_quad.filled);
}

TEST(SpriteFill, triangles_without_area_or_place_fill_nothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec2> places = {
      {0, 0}, {1, 1}, {0.5, 0.5}, {nan, 0}, {1, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(fill_of(places, {0, 1, 2, 0, 0, 1, 0, 1, 3, 4, 0, 1}, image_of(64, 64, 65535), {}).filled, 0u);
}

TEST(SpriteFill, smaller_scales_sample_mip_levels_unless_told_not_to) {
  AlphaImage image = image_of(64, 64, 0);
  image.alpha[64 * 21 + 13] = 65535;  // a point shows in every level, but between the pixels of a coarse grid
  const SpriteFillOptions options{.scales = "0.0625", .turns = 8};
  EXPECT_GT(fill_of(whole_image, quad, image, options).needed, 8u);
  SpriteFillOptions plain = options;
  plain.mipmaps = false;
  EXPECT_LT(fill_of(whole_image, quad, image, plain).needed, 4u);
}

TEST(SpriteFill, looks_begin_upright_and_hang_on_the_options_alone) {
  const auto looks = sprite_looks({.scales = " 1  0.25 ", .turns = 2});
  ASSERT_EQ(looks.size(), 4u);
  EXPECT_EQ(looks[0].angle, 0);
  EXPECT_GT(looks[1].angle, 2);
  EXPECT_EQ(looks[3].scale, 0.25);
  std::set<double> offsets;
  for (const SpriteLook& look : looks) offsets.insert({look.offset.x, look.offset.y});
  EXPECT_EQ(offsets.size(), 8u);
  EXPECT_EQ(sprite_looks({.scales = "1 0.25", .turns = 2})[2].offset, looks[2].offset);
  EXPECT_NE(sprite_looks({.scales = "1 0.25", .turns = 2, .seed = 2})[2].offset, looks[2].offset);
}

TEST(SpriteFill, scales_that_are_none_are_refused_by_name) {
  for (const std::string wrong : {"", " ", "0", "-1", "17", "1 two", "1,2", "nan", "inf", "1e999", "0.5x"}) {
    EXPECT_THROW(sprite_looks({.scales = wrong}), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(sprite_looks({.scales = "1e-300", .turns = 1}).size(), 1u);
}

TEST(SpriteFill, what_is_too_far_or_too_much_is_refused) {
  const AlphaImage image = image_of(4096, 1, 65535);
  const SpriteFillOptions options{.scales = "16", .turns = 1};
  EXPECT_THROW(fill_of({{0, 0}, {17, 0}, {0, 1}}, {0, 1, 2}, image, options), std::runtime_error);
  EXPECT_THROW(fill_of({{0, 0}, {15, 0}, {0, 60000}}, {0, 1, 2}, image, options), std::runtime_error);
  EXPECT_THROW(fill_of({{0, 0}, {1e300, 0}, {0, 1e300}}, {0, 1, 2}, image, {.scales = "1e-300"}), std::runtime_error);
  EXPECT_EQ(fill_of({{0, 0}, {1e5, 0}, {0, 1e5}}, {0, 1, 2}, image, {.scales = "1e-300"}).filled, 0u);
}

/// What the evaluator finds out about a scene's first draw.
Findings found(const Scene& scene, const Settings& settings) {
  Analyses analyses(testing::stored_texels());
  const Executor executor(2);
  Findings findings;
  const Views views;
  Run run{analyses, executor, findings, views};
  const Plugin plugin = sprite_fill_plugin();
  const Technique technique = plugin.create(settings);
  std::get<std::unique_ptr<DrawEvaluator>>(technique)->evaluate({scene, 0}, run);
  return findings;
}

std::map<std::string, Measured> measured(const Scene& scene, const Settings& settings) {
  std::map<std::string, Measured> figures;
  for (const Measured& figure : found(scene, settings).measured) figures[figure.metric] = figure;
  return figures;
}

TEST(SpriteFill, the_evaluator_tells_of_images_without_alpha) {
  const Scene glow = testing::sprite_scene(testing::texel_image({2, 1, 3, 8, false}, {0, 0, 0, 9, 9, 9}));
  const Findings of_alpha = found(glow, {{"scales", "1"}});
  ASSERT_EQ(of_alpha.notes.size(), 1u);
  EXPECT_EQ(of_alpha.notes[0].code, "no-alpha");
  EXPECT_TRUE(found(glow, {{"scales", "1"}, {"channel", "luminance"}}).notes.empty());
  EXPECT_TRUE(found(testing::sprite_scene(testing::texel_image(disc(8))), {{"scales", "1"}}).notes.empty());
}

TEST(SpriteFill, the_evaluator_measures_images_of_every_depth_by_their_channel) {
  const Settings once = {{"scales", "1"}, {"turns", std::int64_t{1}}, {"channel", "luminance"}};
  const Scene coarse = testing::sprite_scene(testing::texel_image({2, 1, 3, 8, false}, {0, 0, 0, 9, 9, 9}));
  const Scene fine = testing::sprite_scene(testing::texel_image({2, 1, 4, 16, false}, {0, 0, 0, 9, 1, 1, 1, 0}));
  for (const Scene* scene : {&coarse, &fine}) {
    const auto figures = measured(*scene, once);
    EXPECT_EQ(figures.at("filled").numerator, 2);
    EXPECT_GE(figures.at("needed").numerator, 1);
    EXPECT_EQ(figures.at("fill").numerator, 2);
    EXPECT_EQ(figures.at("fill").denominator, figures.at("needed").numerator);
  }
  EXPECT_EQ(measured(coarse, {{"scales", "1"}}).at("needed").numerator,
            measured(coarse, {{"scales", "1"}}).at("filled").numerator);
}

TEST(SpriteFill, the_evaluator_sees_the_texture_as_it_is_laid_on) {
  Scene scene = testing::sprite_scene(testing::texel_image(disc(32)));
  const auto figures = measured(scene, {});
  scene.materials[0].base_colour->rotation = 1.5707963267948966;
  scene.materials[0].base_colour->offset = {0, 1};
  const auto turned = measured(scene, {});
  EXPECT_EQ(turned.at("needed").numerator, figures.at("needed").numerator);
  scene.materials[0].base_colour->scale = {2, 2};
  scene.materials[0].base_colour->wrap = {Wrap::repeat, Wrap::repeat};
  EXPECT_NEAR(measured(scene, {}).at("filled").numerator / figures.at("filled").numerator, 4, 0.01);
}

TEST(SpriteFill, the_evaluator_says_why_it_can_not_measure) {
  Scene scene = testing::sprite_scene(testing::texel_image(disc(8)));
  const auto why = [&] {
    try {
      measured(scene, {});
    } catch (const std::runtime_error& problem) {
      return std::string(problem.what());
    }
    return std::string();
  };
  EXPECT_EQ(why(), "");
  scene.images[0].bytes = {};
  EXPECT_EQ(why(), "its image cannot be read: it holds no texels");
  scene.materials[0].base_colour->texcoord = 1;
  EXPECT_EQ(why(), "it has no TEXCOORD_1, which its material's texture needs");
  scene.materials[0].base_colour->image = 7;
  EXPECT_EQ(why(), "the format of its texture is not supported");
  scene.materials[0].base_colour.reset();
  EXPECT_EQ(why(), "its material has no texture");
  EXPECT_THROW(measured(scene, {{"scales", "many"}}), std::invalid_argument);
}

TEST(SpritePainter, tells_pictures_apart_where_they_show) {
  const std::vector<AlphaImage> levels = testing::levels_of(disc(16));
  const testing::SpriteStand stand{1, 0.3, {0.2, 0.6}, testing::SpriteFilter::trilinear};
  const auto all = testing::painted(whole_image, quad, levels, clamped, stand);
  const std::vector<glm::dvec2> rather_more = {{-1, 0}, {1, 0}, {1, 1}, {-1, 1}};
  const std::vector<glm::dvec2> rather_less = {{0, 0}, {0.6, 0}, {0.6, 1}, {0, 1}};
  EXPECT_EQ(testing::differing_pixels(all, testing::painted(rather_more, quad, levels, clamped, stand), 0), 0u);
  EXPECT_GT(testing::differing_pixels(all, testing::painted(rather_less, quad, levels, clamped, stand), 0), 20u);
  EXPECT_EQ(testing::differing_pixels(all, {}, 1), 0u);
}

}  // namespace
}  // namespace foredraw::sprite_fill_test
