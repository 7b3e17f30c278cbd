#pragma once
// What a map has to fulfil along its seams, as equations between texels.

#include <foredraw/analysis/seam_points.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::displacement_seams {

/// The weighted sum of these texels ought to be 0: the height on one side less that on the other.
struct EqualityRow {
  std::uint32_t count = 0;
  std::array<std::uint32_t, 8> texels{};  ///< each once; at first by their place in the map
  std::array<double, 8> weights{};
};

/// One a point and each of its sides but the first: the sum over four texels that displaced_height.h has, over 65536.
/// None where both sides lie in the same texels alike.
std::vector<EqualityRow> rows_of_points(const SeamPoints& points, const foredraw_height_map& map);

/// The same for four texels in doubles, at the exact uvs of each edge's ends and of its points at factors: so that
/// whoever filters with floats finds no gap there either. Together with those above they say that slopes across the
/// seam agree, too, as places are rounded: which bends smooth heights by far more than they differ. So rows of an edge
/// whose gaps are less than a hundredth of the range, rms, are weaker, as that part, down to a thousandth.
std::vector<EqualityRow> rows_of_exact_points(const SeamEdges& seams, std::span<const std::uint32_t> factors,
                                              const foredraw_height_map& map);

/// All along the seams. Between two crossings of texel borders the gap is a square function of the way along the edge,
/// so three rows a piece, at the points and with the weights of Gauss, say its mean square exactly: the squares of all
/// rows together are that of the gap, summed over the texels of the longer side. Texels are those of the exact uvs, in
/// doubles. Where the gap of an edge is less than a hundredth of the range, rms, its squares count as that part of
/// them: what is nearly equal is not made into what texels of both sides can show alike all along.
///
/// No rows have sides longer than four times the map, nor those longer than an eighth of it that are stretched by more
/// than a quarter: where faces fill the whole image, such rows tie every texel to every other one. They are equal at
/// their points alone.
std::vector<EqualityRow> rows_along_seams(const SeamEdges& seams, const foredraw_height_map& map);

/// The texels of all rows, ascending, each once; the rows then name them by their number here.
std::vector<std::uint32_t> numbered(std::span<EqualityRow> rows, std::span<EqualityRow> more);

}  // namespace foredraw::processors::displacement_seams
