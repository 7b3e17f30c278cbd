#pragma once
// Double-sided meshes drawn single-sided: each triangle once for every side of it that is seen. Source: own.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

namespace processors::sides {

/// The sides of a triangle; front faces turn counter-clockwise. Sets of them are sums.
enum Side : std::uint8_t { neither = 0, front = 1, back = 2, both = 3 };

}  // namespace processors::sides

/// A mesh to be drawn single-sided.
struct SingleSided {
  std::vector<std::uint32_t> indices;    ///< three a triangle; from `vertex_count` on they are of copies
  std::vector<std::uint32_t> copies;     ///< [number - vertex_count] whose copy it is, with its normal turned
  std::vector<std::uint32_t> triangles;  ///< [new] the triangle that it shows
  std::size_t added = 0;                 ///< triangles that are there a second time, reversed
  std::size_t turned = 0;                ///< triangles that are there reversed alone
};

/// `wanted`: [triangle] the sides that are to be drawn; a triangle of which none is stays as it is. What is reversed
/// keeps its first corner first, stands behind all others, and has vertices of its own, as its normals point the other
/// way. O(triangles + vertices).
SingleSided single_sided(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                         std::span<const processors::sides::Side> wanted);

struct Plugin;
Plugin sides_plugin();

}  // namespace foredraw
