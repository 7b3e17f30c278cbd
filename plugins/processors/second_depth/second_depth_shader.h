#pragma once
// runtime/second_depth.h as functions of a shader.

#include <foredraw/base/shader_language.h>

#include <string>

namespace foredraw {

/// GLSL for Vulkan (version 450; no version line, so that it can be included), or HLSL of shader model 5 and above:
///
///   struct SecondDepthRule { float towards_far, absolute, relative, round_rims; };
///   float second_depth_edge(SecondDepthRule rule, float depth[7], float second[7], int before, int behind)
///   vec2 second_depth_offset(float row, float column)
///
/// and what these call. The same numbers as in C, up to how the device rounds its divisions.
std::string second_depth_shader_text(ShaderLanguage language);

}  // namespace foredraw
