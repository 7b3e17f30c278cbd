#pragma once
// A stream's header and chunks put together; runtime/progressive_stream.h takes them apart.

#include <foredraw/runtime/progressive_stream.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct CodedChunk {
  std::vector<std::byte> bytes;
  std::uint32_t splits = 0;                   ///< of it
  std::uint32_t vertices = 0, triangles = 0;  ///< that are there behind it
  float error = 0;
};

/// With its own size set; the other numbers are as the header has them.
std::vector<std::byte> header_bytes(foredraw_stream_header& header, std::span<const foredraw_part> parts,
                                    std::span<const std::uint32_t> draw_parts,
                                    std::span<const foredraw_component> components);

/// The whole stream; where it would be too small for a reader to believe its counts, the last chunk is filled up.
/// `chunk_end` is set to where chunks end. std::runtime_error above 4 GB.
std::vector<std::byte> stream_bytes(foredraw_stream_header header, std::span<const foredraw_part> parts,
                                    std::span<const std::uint32_t> draw_parts,
                                    std::span<const foredraw_component> components, std::span<CodedChunk> chunks,
                                    std::vector<std::uint32_t>& chunk_end);

}  // namespace foredraw
