#pragma once
// Vertices and triangles by numbers that no pipeline changes, so that two states of a draw that show the same are the
// same numbers.

#include <foredraw/scene/draw.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The vertices of a level by where they are: those that no skin and no morph target can part are one. They come in the
/// sequence of the file, then those that the file does not have.
struct Places {
  std::vector<std::uint32_t> of_vertex;  ///< [vertex] = its place
  std::vector<std::uint32_t> vertex;     ///< [place] = a vertex that is there
};

Places places_of(const Level& level);

/// [triangle of the stream] = its number in the sequence of the file, from 0 without gaps. Several that come from the
/// same triangle of the file, as its two sides may, follow one another, by the places of their corners.
std::vector<std::uint32_t> numbers_in_file(const IndexStream& stream, const Places& places);

}  // namespace foredraw
