#pragma once
// The vertex fetch of merged draws as functions of a shader, with the draws' constants.

#include <foredraw/base/shader_language.h>
#include <foredraw/instances/merged_instances.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// All attributes of the merged meshes in one buffer of bytes, one stream behind the other: each without gaps, and
/// beginning at a multiple of four.
struct MergedVertexLayout {
  struct Attribute {
    std::string semantic;  ///< glTF's word
    std::string name;      ///< in the shader: "position", "texcoord_0"; different from all others
    Format format;
    std::uint32_t offset = 0;  ///< bytes
  };
  std::vector<Attribute> attributes;
  std::uint64_t bytes = 0;  ///< of the buffer: a multiple of four
};

/// Throws std::length_error where the streams have 2^32 bytes or more: a shader could not address them.
MergedVertexLayout merged_vertex_layout(const VertexStreams& vertices);

/// What the layout says, filled.
std::vector<std::byte> merged_vertex_bytes(const VertexStreams& vertices, const MergedVertexLayout& layout);

struct MergedShaderOptions {
  ShaderLanguage language = ShaderLanguage::glsl;
  std::uint32_t frequency = 3;  ///< where MERGED_FREQUENCY is not defined
  std::uint32_t set = 0;        ///< Vulkan's descriptor set, or HLSL's register space
  std::uint32_t first_binding =
      0;                   ///< of four or five: slots, indices, transforms, vertices, materials; in HLSL registers t
  bool materials = false;  ///< instances have their own
};

/// Functions for a vertex shader: GLSL for Vulkan (version 450; no version line, so that it can be included) or HLSL
/// (shader model 5 and above). The frequency is a constant of the shader, so that the division by it becomes a
/// multiplication: MERGED_FREQUENCY, defined before the text, or the option's.
///
///   MergedVertex merged_vertex(uint number, uint first_slot)   number: gl_VertexIndex or SV_VertexID of a draw that
///   begins
///                                                              with vertex 0; first_slot: the draw's, as a push
///                                                              constant
///   vec3 merged_position(uint vertex)                          and one for each attribute, as floats
///   vec3 merged_to_world(uint instance, vec3 position)
///   vec3 merged_direction_to_world(uint instance, vec3 direction)   of tangents; not normalised
///   vec3 merged_normal_to_world(uint instance, vec3 normal)         also under uneven and mirroring scales; not
///   normalised float merged_handedness(uint instance)                     1, or -1 where mirrored: times a tangent's w
///   uint merged_material(uint instance)                        glTF's number, where instances have their own
///
/// Attributes of more than four components (matrices) are left out, and a comment says so.
std::string merged_shader_text(const MergedVertexLayout& layout, const MergedShaderOptions& options);

/// The text for each of a scene's sets, MERGED_SET chooses which one: 0 where it is not defined.
std::string merged_shader_text(std::span<const MergedInstances> sets, ShaderLanguage language);

}  // namespace foredraw
