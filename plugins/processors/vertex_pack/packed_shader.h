#pragma once
// runtime/packed_vertex.h as functions of a shader, with a layout's constants.

#include <foredraw/base/shader_language.h>
#include <foredraw/packing/packed_vertices.h>

#include <string>
#include <vector>

namespace foredraw::processors::vertex_pack {

/// The different layouts of all draws, stored ones before posed ones, each draw's after those of the draws before.
std::vector<PackedLayout> distinct_layouts(const PackedVertices& all);

/// The structure and the functions that all layouts have in common. GLSL for Vulkan (version 450; no version line, so
/// that it can be included) or HLSL (shader model 5 and above).
std::string packed_shader_head(ShaderLanguage language);

/// Of a layout, behind the head:
///   PackedVertex packed_decode(uvec4 row)                       position, normal, tangent, uv
///   uint packed_encode(PackedVertex vertex, out uvec4 row)      0, or what the row does not hold: FOREDRAW_PACKED_*
/// The same bits as in C where positions are concerned; and all others too, where the device rounds additions and
/// multiplications as IEEE 754 does, as Vulkan asks of it.
std::string packed_shader_text(const PackedLayout& layout, ShaderLanguage language);

}  // namespace foredraw::processors::vertex_pack
