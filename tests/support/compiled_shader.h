#pragma once
// Shaders whose text is made while a test runs.

#include <foredraw/base/shader_language.h>

#include "support/program.h"

#include <cstdint>
#include <cstring>

namespace foredraw::testing {

inline bool has_shader_compiler() { return std::system("glslangValidator --version > /dev/null 2>&1") == 0; }

/// SPIR-V for Vulkan, as words. What the compiler will not take fails the test, and gives none. `stage`: "vert",
/// "tesc", "tese", "frag" or "comp".
inline std::vector<std::uint32_t> compiled_shader(const std::string& text, ShaderLanguage language,
                                                  const std::string& stage) {
  const TestFolder own;
  const std::filesystem::path& folder = own.path();
  const bool glsl = language == ShaderLanguage::glsl;
  put(folder / "source", (glsl ? "#version 450\n" : "") + text);
  const std::string path = "'" + folder.string() + "/";
  const std::string command = "glslangValidator -V -e main -S " + stage +
                              (glsl ? "" : " -D -DDISPLACED_PUSH_CONSTANT") + " -o " + path + "code' " + path +
                              "source' > " + path + "log' 2>&1";
  const bool compiles = std::system(command.c_str()) == 0;
  EXPECT_TRUE(compiles) << content(folder / "log") << text;
  const std::string code = compiles ? content(folder / "code") : "";
  std::vector<std::uint32_t> words(code.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), code.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

}  // namespace foredraw::testing
