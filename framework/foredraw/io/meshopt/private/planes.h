#pragma once
// The differences of a block, by the places of their bytes, and how they become elements.

#include <foredraw/io/meshopt/private/vertex_layout.h>

namespace foredraw::meshopt {

constexpr std::size_t channels_at_once = 4;

/// [4 c + b]: of byte b of channel c, in the sequence of the elements. Aligned to 64 bytes; what lies behind the
/// block's elements may be anything.
using Planes = Byte[channels_at_once * channel_bytes][most_in_block];

/// Adds up the differences of 1 to 4 channels, beginning with what `last` holds of them, and puts them side by side
/// into `count` elements of `stride` bytes. `modes`: their bytes of the tail.
void sum_up_planes(const Planes& planes, const Byte* modes, std::size_t channels, std::size_t count, const Byte* last,
                   std::size_t stride, Byte* to);

}  // namespace foredraw::meshopt
