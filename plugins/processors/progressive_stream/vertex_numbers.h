#pragma once
// The whole numbers that stand for places and attributes of vertices in a stream.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/runtime/split_mesh.h>

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

struct VertexNumbers {
  float least[3] = {0, 0, 0};
  float step = 0;
  std::vector<std::int32_t> places;  ///< [3 * vertex], from 0 to 2^position_bits - 1
  std::vector<foredraw_component> components;
  std::vector<foredraw_part> parts;  ///< [stream of the mesh]
  std::uint32_t width = 0;           ///< the most components of a part
  std::vector<std::int32_t> values;  ///< [width * vertex + component of its part]
};

/// std::runtime_error where a position is not finite.
VertexNumbers vertex_numbers(const JoinedMesh& mesh, const NumberBits& bits);

}  // namespace foredraw
