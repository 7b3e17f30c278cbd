#pragma once
#include <cstdint>

namespace foredraw {

/// What a shader's text is written in: GLSL for Vulkan, or HLSL.
enum class ShaderLanguage : std::uint8_t { glsl, hlsl };

}  // namespace foredraw
