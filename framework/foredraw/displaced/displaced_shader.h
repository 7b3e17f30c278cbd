#pragma once
// Shaders that draw a displaced surface as the processor computes it, with a draw's constants.

#include <foredraw/base/shader_language.h>
#include <foredraw/displaced/edge_division.h>
#include <foredraw/displaced/height_bits.h>
#include <foredraw/runtime/displaced_height.h>

#include <cstdint>
#include <string>

namespace foredraw {

/// What the shaders of a draw know from the beginning.
struct DisplacedShader {
  /// The map's size, what lies beyond its edges, and whether texels have hard edges; `texels` is not read.
  foredraw_height_map map{nullptr, 1, 1, {FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_REPEAT}, 0};
  /// How the texture has heights: as 0 to 1 (UNORM of 8 or 16 bits), or as whole numbers (UINT of 16 bits). Both are
  /// the same to the bit.
  enum class Texels : std::uint8_t { normalized, whole } texels = Texels::normalized;
  float factor = 1, offset = 0;      ///< finite
  std::uint32_t bits = height_bits;  ///< of a height, 1 to 16

  TessellationSpacing spacing = TessellationSpacing::equal;
  /// Where levels come from: `level` is everyone's; or each edge gets parts of `pixels_per_part` pixels
  /// (foredraw_edge_level(); inside, as the finest edge); or a buffer has four numbers for each triangle, those of
  /// edges 0, 1 and 2 and the inner one.
  enum class Levels : std::uint8_t { constant, by_pixels, stored } levels = Levels::by_pixels;
  float level = 1;            ///< finite, above 0
  float pixels_per_part = 8;  ///< finite, above 0

  std::uint32_t vertices = 0;  ///< of the cage
  std::uint32_t joints = 0;    ///< maps that each instance has; 0: it has one, and vertices have no joints
  bool reads_seams = false;    ///< heights of seams come from a buffer, and are equal on both sides at any level
  bool captures = false;  ///< GLSL: what fragments get goes into a transform feedback buffer, too: 40 bytes a corner

  std::uint32_t set = 0;  ///< Vulkan's descriptor set of the buffers, or HLSL's register space
  std::uint32_t first_binding =
      0;  ///< of six: rest, skin, maps, cage, levels, seams; in HLSL registers t, and u of the cage
  std::uint32_t map_set = 1, map_binding = 0;  ///< of the map
};

/// Of which each is a shader with its own `main`, but for the first.
enum class DisplacedStage : std::uint8_t {
  functions,       ///< those of displaced_height.h, displaced_surface.h and displaced_cage.h, for shaders of one's own
  cage,            ///< compute: poses the cage of each instance once, into a buffer
  cage_capture,    ///< vertex, GLSL: the same by transform feedback, from points
  vertex,          ///< vertex: poses the cage as it is drawn
  vertex_of_cage,  ///< vertex: reads the posed cage
  control,         ///< tessellation control, or hull
  evaluation,      ///< tessellation evaluation, or domain
};

/// The text of a stage: GLSL for Vulkan without a version line (450 is needed, so that it can be put behind one), or
/// HLSL of shader model 5.1. Entry points are called `main`.
///
/// Buffers are laid out as displaced_cage.h says: `rest` [vertex] and `skin` [vertex], of which cage_buffers.h makes
/// the content, `maps` [instance][joint], `cage` [instance][vertex], `levels` [triangle] four floats, and `seams` the
/// words of stored_seams.h. Levels and seams are those of the patch's number in its draw call: draw all at once. The
/// evaluation stage, and the control stage where levels are by pixels, read a push constant (in HLSL a constant buffer
/// at b0, or a push constant where DISPLACED_PUSH_CONSTANT is defined):
///
///   mat4 clip_from_posed     what the posed cage is in, on the screen
///   vec3 eye                 in the same space
///   float pixels_per_unit    of a thing of size 1 at distance 1
///
/// Drawn are lists of patches of three, indexed by the cage's triangles, in as many instances as there are. The
/// compute stage has 64 vertices to a group along x, and instances along y. The capturing one draws as many points as
/// the cage has vertices, with rasterisation off. Fragment shaders are handed the point, its weights, and the numbers
/// of the corners and the instance: whatever else a vertex has is read and interpolated there.
///
/// Everything that decides where a point lies is `precise`: two triangles that share an edge give the same bits along
/// it. On the processor displaced_positions() gives the same ones, but for what a device's division and square root
/// round differently.
///
/// Throws std::invalid_argument where a number is out of its range, or HLSL is asked to capture.
std::string displaced_shader_text(const DisplacedShader& shader, ShaderLanguage language, DisplacedStage stage);

}  // namespace foredraw
