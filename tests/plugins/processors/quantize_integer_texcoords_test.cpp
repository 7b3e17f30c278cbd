// Texture coordinates as whole numbers: never farther off than asked for, and only where materials scale them back.
#include "plugins/processors/quantize/integer_texcoords.h"

#include <foredraw/image/texture_uv.h>
#include <foredraw/scene/triangle_draw.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace foredraw::quantize_integer_texcoords_test {
namespace {

using Uvs = std::vector<glm::vec2>;

constexpr double tolerance = 0.5 / 4096;

std::shared_ptr<const VertexStreams> vertices(const std::vector<Uvs>& sets) {
  auto made = std::make_shared<VertexStreams>();
  made->count = static_cast<std::uint32_t>(sets.front().size());
  for (std::size_t s = 0; s < sets.size(); ++s) {
    made->base.push_back(float_stream("TEXCOORD_" + std::to_string(s), sets[s]));
  }
  return made;
}

Draw draw_of(std::shared_ptr<const VertexStreams> vertices, std::optional<MaterialId> material = 0) {
  Draw draw;
  draw.levels.resize(1);
  draw.full().vertices = std::move(vertices);
  draw.full().orders.resize(1);
  draw.material = material;
  return draw;
}

Material painted(std::uint32_t sets = 1) {
  return {.base_colour = Texture{.image = 0}, .needs = VertexNeeds{.texcoords = sets}};
}

const Uvs corner = {{0, 0}, {1, 0}, {0, 1}};

/// Two draws of one material, and one of another.
Scene three_draws() {
  Scene scene;
  scene.materials = {painted(), painted()};
  scene.draws = {draw_of(vertices({corner}), 0), draw_of(vertices({{{2, .5}, {1, 0}, {.25, 1}}}), 0),
                 draw_of(vertices({{{-7, .5}, {-6, 0}, {-6, 1}}}), 1)};
  return scene;
}

/// [group] whether set 0 becomes whole numbers.
std::string planned(const Scene& scene, const std::vector<VertexGroup>& groups) {
  std::string made;
  for (const auto& grids : find_integer_texcoords(scene, groups, tolerance).of_groups)
    made += grids.empty() ? '.' : '#';
  return made;
}

std::string planned(const Scene& scene) { return planned(scene, vertex_groups(scene)); }

TEST(IntegerTexcoords, DrawsOfOneMaterialHaveOneGrid) {
  Scene scene = three_draws();
  const IntegerTexcoords plan = find_integer_texcoords(scene, vertex_groups(scene), tolerance);
  ASSERT_EQ(planned(scene), "###");
  const TexcoordGrid &a = plan.of_groups[0][0], &b = plan.of_groups[1][0], &c = plan.of_groups[2][0];
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.first, glm::dvec2(0));
  EXPECT_EQ(c.first, glm::dvec2(std::round(-7 / c.step), 0));
  EXPECT_EQ(plan.of_materials[0][0].scaled(), a.scaled());
  EXPECT_EQ(plan.of_materials[1][0].scaled(), c.scaled());
  scale_textures(scene.materials, plan);
  EXPECT_EQ(scene.materials[1].scaled_texcoords, std::vector{c.scaled()});
  EXPECT_EQ(scene.materials[1].base_colour->scale, glm::dvec2(c.step));
}

TEST(IntegerTexcoords, DrawsOfOneVertexStreamsOrOneBlockOfMemoryHaveOneGrid) {
  Scene scene = three_draws();
  scene.draws[2].full().vertices = scene.draws[0].full().vertices;
  EXPECT_EQ(planned(scene), "##");
  scene.materials[1].keeps_spaces = true;
  EXPECT_EQ(planned(scene), "..");
  scene.draws[2].full().vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  EXPECT_EQ(planned(scene), "...");
}

TEST(IntegerTexcoords, StayWhereNobodyWouldScaleThemBack) {
  const auto with = [](auto change) {
    Scene scene = three_draws();
    change(scene);
    return planned(scene);
  };
  EXPECT_EQ(with([](Scene& s) { s.draws[1].material.reset(); }), "#.#");
  EXPECT_EQ(with([](Scene& s) { s.materials[0].keeps_spaces = true; }), "..#");
  EXPECT_EQ(with([](Scene& s) { s.materials[0].needs.reset(); }), "..#");
  EXPECT_EQ(with([](Scene& s) { s.materials[0].needs = VertexNeeds{.texcoords = 2}; }), "..#") << "not looked up";
  EXPECT_EQ(with([](Scene& s) { s.draws.push_back(draw_of(vertices({corner}), 0)); }), "####");
}

TEST(IntegerTexcoords, StayWhereOneOfTheMaterialsDrawsMayNotChange) {
  const Scene scene = three_draws();
  std::vector<VertexGroup> groups = vertex_groups(scene);
  groups.erase(groups.begin() + 1);
  EXPECT_EQ(planned(scene, groups), ".#");
}

TEST(IntegerTexcoords, StayWhereALevelCanNotBeWholeNumbers) {
  const auto with_level = [](std::shared_ptr<const VertexStreams> level) {
    Scene scene = three_draws();
    scene.draws[1].levels.push_back(scene.draws[1].levels[0]);
    scene.draws[1].levels[1].vertices = std::move(level);
    return planned(scene);
  };
  EXPECT_EQ(with_level(vertices({corner})), "####");
  auto without = std::make_shared<VertexStreams>();
  without->base = {float_stream("POSITION", std::vector<glm::vec3>(3))};
  without->count = 3;
  EXPECT_EQ(with_level(without), "...#") << "its textures are looked up at 0";
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    EXPECT_EQ(with_level(vertices({{{0, 0}, {1, odd}}})), "...#");
  EXPECT_EQ(with_level(vertices({{{0, 0}, {1e9f, 1}}})), "...#");
  auto morphed = std::make_shared<VertexStreams>(*vertices({corner}));
  morphed->morph_targets = {{float_stream("TEXCOORD_0", corner)}};
  EXPECT_EQ(with_level(morphed), "...#");
  auto whole = std::make_shared<VertexStreams>(
      *with_integer_texcoords(*vertices({corner}), std::vector{TexcoordGrid{.step = 1}}).vertices);
  EXPECT_EQ(with_level(whole), "...#");
}

TEST(IntegerTexcoords, OfEachSetAreForThemselves) {
  Scene scene;
  scene.materials = {painted(0b101)};
  scene.draws = {draw_of(vertices({corner, corner, {{0, 0}, {.01f, 0}, {0, .02f}}}))};
  const IntegerTexcoords plan = find_integer_texcoords(scene, vertex_groups(scene), tolerance);
  ASSERT_EQ(plan.of_groups[0].size(), 2u);
  const IntegerVertices made = with_integer_texcoords(*scene.draws[0].full().vertices, plan.of_groups[0]);
  EXPECT_EQ(made.vertices->find("TEXCOORD_0")->format, (Format{Component::uint16, 2, false, 4}));
  EXPECT_EQ(made.vertices->find("TEXCOORD_1")->format.component, Component::float32);
  EXPECT_EQ(made.vertices->find("TEXCOORD_2")->format, (Format{Component::uint8, 2, false, 2}));
}

struct AnyProduct {
  static constexpr std::string_view product = "any";
  friend bool operator==(const AnyProduct&, const AnyProduct&) = default;
};

TEST(IntegerTexcoords, OfScenesWithProductsStay) {
  Scene scene = three_draws();
  EXPECT_EQ(planned(scene), "###");
  EXPECT_TRUE(find_integer_texcoords(scene, vertex_groups(scene), 0).of_groups[0].empty()) << "no tolerance";
  scene.products.set(AnyProduct{});
  EXPECT_EQ(planned(scene), "...");
}

/// Whole numbers m * 2^e with 32 <= m < 64.
bool has_six_bits(double step) {
  const double m = std::ldexp(step, 5 - std::ilogb(step));
  return m == std::floor(m) && m >= 32 && m < 64;
}

RC_GTEST_PROP(IntegerTexcoords, TexturesLieWhereTheyLayWithinTheTolerance, ()) {
  const double within = std::ldexp(*rc::gen::inRange(1, 1000), -13);
  const float wide = std::ldexp(1.0f, *rc::gen::inRange(-8, 2));
  const auto number = rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'000),
                                   [&](int one) { return static_cast<float>(one) * 1e-6f * wide; });
  const auto flat = *rc::gen::container<std::vector<float>>(2 * *rc::gen::inRange(1u, 30u), number);
  Uvs uvs;
  for (std::size_t i = 0; i < flat.size(); i += 2) uvs.emplace_back(flat[i], flat[i + 1]);
  Scene scene;
  scene.materials = {painted()};
  scene.materials[0].base_colour->scale = {1, 3};
  scene.materials[0].base_colour->rotation = 1;
  scene.draws = {draw_of(vertices({uvs}))};
  const IntegerTexcoords plan = find_integer_texcoords(scene, vertex_groups(scene), within);
  RC_ASSERT(plan.of_groups[0].size() == 1u);
  const TexcoordGrid grid = plan.of_groups[0][0];
  RC_ASSERT(has_six_bits(grid.step));
  RC_ASSERT(grid.step * std::sqrt(0.5) <= within);
  RC_ASSERT(grid.step * std::sqrt(0.5) * 33 / 32 > within * 0.999999);
  const Texture before = *scene.materials[0].base_colour;
  const IntegerVertices made = with_integer_texcoords(*scene.draws[0].full().vertices, plan.of_groups[0]);
  RC_ASSERT(made.largest <= within);
  scale_textures(scene.materials, plan);
  const VertexStream& whole = *made.vertices->find("TEXCOORD_0");
  const ScaledTexcoords back = grid.scaled();
  double largest = 0;
  for (std::size_t v = 0; v < uvs.size(); ++v) {
    const glm::vec2 q(decode_component(whole, v, 0), decode_component(whole, v, 1));
    const glm::vec2 seen = glm::vec2(back.offset) + glm::vec2(back.scale) * q;
    RC_ASSERT(glm::dvec2(seen) == back.offset + back.scale * glm::dvec2(q));  // floats are exact
    const glm::dvec2 off = glm::dvec2(seen) - glm::dvec2(uvs[v]);
    largest = std::max(largest, std::sqrt(off.x * off.x + off.y * off.y));
  }
  RC_ASSERT(largest == made.largest);
  const auto places = texture_uv(float_stream("TEXCOORD_0", uvs), before),
             now = texture_uv(whole, *scene.materials[0].base_colour);
  for (std::size_t v = 0; v < uvs.size(); ++v) {
    const glm::dvec2 off = now[v] - places[v];
    RC_ASSERT(std::sqrt(off.x * off.x + off.y * off.y) <= 3 * within + 1e-12);
  }
}

}  // namespace
}  // namespace foredraw::quantize_integer_texcoords_test
