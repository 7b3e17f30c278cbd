#pragma once
// What the words of one channel take in a block of a stream.

#include <foredraw/io/meshopt/private/vertex_layout.h>

namespace foredraw::meshopt {

// Of both: `words` begins with the word before the block; behind its `count` the last one is there again up to whole
// groups. `mode`: the byte of the tail.

/// The fewest bytes, without the control byte, in version 1.
std::size_t cost_of_channel(const std::uint32_t* words, std::size_t count, unsigned mode);

/// Writes these bytes, and what says how they are to be read into `control`, which is 0; version 0 has none. Returns
/// what lies behind them; up to 32 bytes more may be overwritten.
Byte* put_channel(const std::uint32_t* words, std::size_t count, unsigned mode, VertexVersion version, Byte* control,
                  Byte* to);

}  // namespace foredraw::meshopt
