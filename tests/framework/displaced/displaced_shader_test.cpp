#include <foredraw/displaced/displaced_shader.h>

#include "support/compiled_shader.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace foredraw::displaced_shader_test {
namespace {

using enum DisplacedStage;
using Levels = DisplacedShader::Levels;

const char* compiler_stage(DisplacedStage stage) {
  return stage == cage ? "comp" : stage == control ? "tesc" : stage == evaluation ? "tese" : "vert";
}

constexpr ShaderLanguage languages[] = {ShaderLanguage::glsl, ShaderLanguage::hlsl};
constexpr DisplacedStage stages[] = {cage, vertex, vertex_of_cage, control, evaluation};

void expect_to_compile(const DisplacedShader& shader) {
  for (const ShaderLanguage language : languages) {
    for (const DisplacedStage stage : stages) {
      EXPECT_FALSE(
          testing::compiled_shader(displaced_shader_text(shader, language, stage), language, compiler_stage(stage))
              .empty());
    }
  }
  EXPECT_FALSE(testing::compiled_shader(displaced_shader_text(shader, ShaderLanguage::glsl, cage_capture),
                                        ShaderLanguage::glsl, "vert")
                   .empty());
}

TEST(DisplacedShader, EveryStageCompilesInBothLanguages) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  DisplacedShader shader;
  shader.map = {nullptr, 2048, 1024, {FOREDRAW_HEIGHT_MIRRORED, FOREDRAW_HEIGHT_CLAMPED}, 0};
  shader.factor = 0.1f;
  shader.offset = -1e-7f;
  shader.vertices = 1000;
  expect_to_compile(shader);
  shader.map.is_nearest = 1;
  shader.texels = DisplacedShader::Texels::whole;
  shader.joints = 60;
  shader.levels = Levels::stored;
  shader.spacing = TessellationSpacing::fractional_odd;
  shader.set = 2;
  shader.first_binding = 3;
  shader.map_set = 2;
  shader.map_binding = 9;
  expect_to_compile(shader);
  shader.levels = Levels::constant;
  shader.level = 7;
  shader.spacing = TessellationSpacing::fractional_even;
  expect_to_compile(shader);
  shader.captures = true;
  const std::string text = displaced_shader_text(shader, ShaderLanguage::glsl, evaluation);
  EXPECT_FALSE(testing::compiled_shader(text, ShaderLanguage::glsl, "tese").empty());
}

TEST(DisplacedShader, FunctionsCompileInShadersOfOnesOwn) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const ShaderLanguage language : languages) {
    const std::string text = displaced_shader_text({}, language, functions) +
                             (language == ShaderLanguage::glsl ? "layout(local_size_x = 1) in;\nvoid main() {}\n"
                                                               : "[numthreads(1, 1, 1)] void main() {}\n");
    EXPECT_FALSE(testing::compiled_shader(text, language, "comp").empty());
  }
}

TEST(DisplacedShader, HoldsTheDrawsConstants) {
  DisplacedShader shader;
  shader.map = {nullptr, 4096, 512, {FOREDRAW_HEIGHT_CLAMPED, FOREDRAW_HEIGHT_MIRRORED}, 1};
  shader.factor = 0.1f;
  shader.offset = -3;
  shader.bits = 12;
  shader.vertices = 17684;
  const auto expect = [&](ShaderLanguage language, std::initializer_list<const char*> lines) {
    const std::string text = displaced_shader_text(shader, language, evaluation);
    for (const char* line : lines) EXPECT_NE(text.find(line), std::string::npos) << line;
    EXPECT_EQ(text.find('@'), std::string::npos);
  };
  expect(ShaderLanguage::glsl,
         {"const uvec2 displaced_size = uvec2(4096u, 512u);\n", "const uvec2 displaced_wrap = uvec2(2u, 1u);\n",
          "const bool displaced_is_nearest = true;\n", "const uint displaced_bits = 12u;\n",
          "const float displaced_factor = 0.1;\n", "const float displaced_offset = -3.0;\n",
          "const uint displaced_vertices = 17684u;\n", "layout(triangles, equal_spacing, cw) in;\n"});
  expect(ShaderLanguage::hlsl, {"static const uint2 displaced_size = uint2(4096u, 512u);\n",
                                "static const float displaced_factor = 0.1;\n", "register(t0, space1)"});
}

TEST(DisplacedShader, WhatNoShaderCanDoIsRefused) {
  const auto refused = [](auto change, ShaderLanguage language = ShaderLanguage::glsl,
                          DisplacedStage stage = evaluation) {
    DisplacedShader shader;
    change(shader);
    EXPECT_THROW(displaced_shader_text(shader, language, stage), std::invalid_argument);
  };
  constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  refused([](DisplacedShader& shader) { shader.map.width = 0; });
  refused([](DisplacedShader& shader) { shader.map.height = 65537; });
  refused([](DisplacedShader& shader) { shader.bits = 0; });
  refused([](DisplacedShader& shader) { shader.bits = 17; });
  refused([](DisplacedShader& shader) { shader.factor = none; });
  refused([](DisplacedShader& shader) { shader.offset = endless; });
  refused([](DisplacedShader& shader) { shader.level = 0; });
  refused([](DisplacedShader& shader) { shader.pixels_per_part = none; });
  refused([](DisplacedShader& shader) { shader.captures = true; }, ShaderLanguage::hlsl);
  refused([](DisplacedShader&) {}, ShaderLanguage::hlsl, cage_capture);
}

}  // namespace
}  // namespace foredraw::displaced_shader_test
