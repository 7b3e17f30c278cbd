#pragma once
// Shaders that draw wires as wire_radius.h computes them.

#include <foredraw/base/shader_language.h>

#include <string>

namespace foredraw {

/// GLSL for Vulkan without a version line (450 is needed, so that it can be put behind one), or HLSL of shader model
/// 5.1. The same for every draw.
///
/// It holds the functions of wire_radius.h, one for one, for shaders of one's own. With WIRE_VERTEX or WIRE_FRAGMENT
/// defined it is such a shader, and its entry point is called `main`; with WIRE_COVERAGE defined too, fragments compute
/// their coverage, and without it wires are a pixel wide at least and fade. Coverage needs one sample a pixel; where
/// there are more, define WIRE_SAMPLES as their number for the vertices.
///
/// Wires are drawn twice: with WIRE_OPAQUE defined the fragment shader leaves out what is not opaque, which is drawn
/// later, blended, with WIRE_FADED defined, and without writing depth.
///
/// The vertex shader reads positions at location 0, _FOREDRAW_WIRE at 1 and _FOREDRAW_WIRE_AXIS, four numbers, at 2.
/// The fragment shader gives the share of lighting as its colour, and alpha. Both read a push constant (in HLSL a
/// constant buffer at b0, or with WIRE_VULKAN defined a push constant):
///
///   mat4 clip_from_mesh
///   vec2 viewport         pixels
///
/// In HLSL pixels are counted as Direct3D has them, with clip space's y upwards; with WIRE_VULKAN defined as Vulkan.
std::string wire_shader_text(ShaderLanguage language);

/// The functions alone, for any GLSL. GLSL ES has no `precise`: define it as nothing before the text.
std::string wire_functions_text();

}  // namespace foredraw
