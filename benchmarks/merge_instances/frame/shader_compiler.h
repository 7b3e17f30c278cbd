#pragma once
// Shaders whose text is known only when the program runs.

#include <cstdint>
#include <string>
#include <vector>

namespace foredraw::bench {

/// Whether glslangValidator can be called.
bool has_shader_compiler();

/// GLSL for Vulkan as SPIR-V. `stage`: "vert" or "frag". Throws std::runtime_error with what glslangValidator says
/// where it does not take the text.
std::vector<std::uint32_t> compiled_shader(const std::string& text, const std::string& stage);

}  // namespace foredraw::bench
