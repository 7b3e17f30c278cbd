#include <foredraw/wires/wire_shader.h>

#include "support/compiled_shader.h"

#include <gtest/gtest.h>

namespace foredraw::viewing_wire_shader_test::wires_wire_shader_test {
namespace {

TEST(WireShader, EveryStageCompilesInBothLanguages) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
    for (const std::string defined : {"", "#define WIRE_COVERAGE\n"}) {
      const std::string text = wire_shader_text(language);
      EXPECT_FALSE(testing::compiled_shader("#define WIRE_VERTEX\n" + defined + text, language, "vert").empty());
      EXPECT_FALSE(testing::compiled_shader("#define WIRE_FRAGMENT\n" + defined + text, language, "frag").empty());
    }
  }
}

TEST(WireShader, FunctionsCompileInShadersOfOnesOwn) {
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
    const std::string text = wire_shader_text(language) + (language == ShaderLanguage::glsl
                                                               ? "layout(local_size_x = 1) in;\nvoid main() {}\n"
                                                               : "[numthreads(1, 1, 1)] void main() {}\n");
    EXPECT_FALSE(testing::compiled_shader(text, language, "comp").empty());
  }
}

}  // namespace
}  // namespace foredraw::viewing_wire_shader_test::wires_wire_shader_test
