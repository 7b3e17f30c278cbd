#pragma once
#include <cstdint>

namespace foredraw {

/// What a shader's text is written in: GLSL for Vulkan (version 450), or HLSL (shader model 5 and above).
enum class ShaderLanguage : std::uint8_t { glsl, hlsl };

}  // namespace foredraw
