#pragma once
// Elements copied from rows to rows, and integers made wider or narrower: the loops that every byte of a file passes.
// Private to io.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::gltf {

/// Copies `count` elements of so many bytes, each row `from_stride` or `to_stride` bytes behind the last.
void copy_rows(std::byte* to, std::size_t to_stride, const std::byte* from, std::size_t from_stride, std::size_t bytes,
               std::size_t count);

/// Tight little-endian unsigned integers of 1, 2 or 4 bytes: as 32 bits, and back, where they must fit; and the
/// greatest, 0 where there is none.
std::vector<std::uint32_t> widened(std::span<const std::byte> elements, std::size_t width);
std::vector<std::byte> narrowed(std::span<const std::uint32_t> values, std::size_t width);
std::uint32_t greatest(std::span<const std::byte> elements, std::size_t width);

}  // namespace foredraw::gltf
