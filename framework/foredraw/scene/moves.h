#pragma once
// Where vertices and triangles went between two states of a draw: for products that name them by number.

#include <foredraw/scene/draw.h>

#include <optional>

namespace foredraw {

/// [number before] = number after; no_vertex where it is gone. Nothing where the vertices after do not come from those
/// before, as where a stage made others.
std::optional<std::vector<std::uint32_t>> vertex_moves(const Level& before, const Level& after);

/// The same of triangles. None is ever gone.
std::optional<std::vector<std::uint32_t>> triangle_moves(const IndexStream& before, const IndexStream& after);

/// Where ranges of triangles begin now: `bounds` are the first triangles of all ranges but the first, rising. A range
/// may have lost triangles, and be empty. Nothing where a triangle left its range, or is not known from before.
std::optional<std::vector<std::uint32_t>> moved_bounds(std::span<const std::uint32_t> bounds, const IndexStream& before,
                                                       const IndexStream& after);

/// How many triangles at the start of `after` come from the first `count` of `before`: what is left of a range that
/// comes first in its draw, where triangles were taken out of it to stand behind, or are gone. 0 where it is not known
/// from which they come.
std::uint32_t kept_first(std::uint32_t count, const IndexStream& before, const IndexStream& after);

}  // namespace foredraw
