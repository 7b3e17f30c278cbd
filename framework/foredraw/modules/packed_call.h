#pragma once
#include <foredraw/c/plugin.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace foredraw {

/// What is asked in a call.
struct ForeignQuestion {
  std::uint32_t plugin = 0;  ///< of the module's, by number
  const foredraw_draw& draw;
  std::span<const foredraw_value> options;
  std::uint64_t seed = 0;
  std::uint64_t room = 0;  ///< numbers that the answer may have
  std::uint64_t vertex_room = 0;
  bool may_count = false;  ///< whether it may ask for overdraw

  /// How many there may be in all, in the block of answers.
  std::uint64_t numbers() const { return room + vertex_room + (may_count ? draw.triangle_count : 0); }
};

/// How many bytes it takes in a block.
std::size_t packed_size(const ForeignQuestion& question);

/// Puts it at the begin of a block, which has room for it.
void pack(const ForeignQuestion& question, std::byte* block);

}  // namespace foredraw
