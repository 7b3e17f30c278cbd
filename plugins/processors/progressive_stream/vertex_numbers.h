#pragma once
// The whole numbers that stand for places and attributes of vertices in a stream.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/runtime/split_mesh.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// How finely floats are stored. Numbers that the draws store as whole ones stay as they are.
struct NumberBits {
  std::uint32_t position_bits = 16;  ///< of the longest side of the mesh's box, 4 to 20
  std::uint32_t uv_bits = 14;        ///< of each texture coordinate's range, 4 to 24
  std::uint32_t normal_bits = 10;    ///< of normals and tangents, from -1 to 1, 4 to 24
  std::uint32_t other_bits = 16;     ///< of the range of each other number, 4 to 24
  bool lossless = false;             ///< all floats as they are; splits are still found by position_bits
};

/// How numbers are to be understood: what a stream's header says.
struct NumberGrid {
  std::uint32_t bits = 16;  ///< of places
  float least[3] = {0, 0, 0};
  float step = 0;
  std::vector<foredraw_component> components;
  std::vector<foredraw_part> parts;  ///< [stream of the mesh]; each with its positions or without
  std::uint32_t width = 0;           ///< the most components of a part
};

/// std::runtime_error where a position is not finite.
NumberGrid number_grid(const JoinedMesh& mesh, const NumberBits& bits);

struct VertexNumbers {
  std::vector<std::int32_t> places;  ///< [3 * vertex], from 0 to 2^bits - 1
  std::vector<std::int32_t> values;  ///< [width * vertex + component of its part]
};

/// Nothing where the mesh's vertices have other attributes than the grid's.
std::optional<VertexNumbers> vertex_numbers(const JoinedMesh& mesh, const NumberGrid& grid);

/// What the numbers of a stream's vertices are, in sequence: the name of the attribute, "target 0 NORMAL" of a morph
/// target, once for each of its components.
std::vector<std::string> number_names(const VertexStreams& vertices, const foredraw_part& part);

}  // namespace foredraw
