#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace foredraw {

/// What a shader's text is written in: GLSL for Vulkan, or HLSL.
enum class ShaderLanguage : std::uint8_t { glsl, hlsl };

/// Words of GLSL as HLSL calls them: types of vectors, and roundEven. Everything else stays.
std::string in_hlsl(std::string_view glsl);

}  // namespace foredraw
