#pragma once
// How well a grid can be ordered by whoever knows that it is one: strips just as wide as the cache allows.

#include <cstdint>
#include <vector>

namespace foredraw::bench {

/// A strip's width in cells: in its first row, and where it has grown by one in each row, at the most.
struct StripWidth {
  std::uint32_t first;
  std::uint32_t most;
};

/// Both rows of vertices around a row of cells stay in a FIFO of `cache_size` entries, at least 6.
StripWidth plain_strips(std::uint32_t cache_size);

/// Strips that start as plain ones and grow. Once a row of vertices has entered in sequence, one row is all that the
/// cache must hold: each vertex leaves just after its last use. Growing row by row is what brings a strip there.
StripWidth primed_strips(std::uint32_t cache_size);

/// The order of the triangles ([new] = old) of a grid of columns x rows cells, numbered row by row with two triangles a
/// cell: (a, a + 1, c) and (c, a + 1, c + 1), a being the cell's vertex in this row and c that in the next.
std::vector<std::uint32_t> grid_strips(std::uint32_t columns, std::uint32_t rows, StripWidth width);

}  // namespace foredraw::bench
