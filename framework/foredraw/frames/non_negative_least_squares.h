#pragma once
// Few unknowns, none below zero, that come nearest to many equations.

#include <cstddef>
#include <span>
#include <vector>

namespace foredraw {

/// The x of least |A x - b| with no x[i] below 0. `rows`: A, row after row, `unknowns` numbers each; `wanted`: b, one
/// for each row. All are finite. Of unknowns that the rows do not tell apart, the first ones get what they can take,
/// and the others are 0; so are those that no row has. Rows as they stand count as much as they are long.
///
/// C. Lawson, R. Hanson: Solving Least Squares Problems, 1974, chapter 23. The rows are brought to a triangle first, by
/// reflections, so that no precision is lost to squares. O(rows * unknowns^2). Only + - * / and square roots: the same
/// bits everywhere.
std::vector<double> non_negative_least_squares(std::span<const double> rows, std::span<const double> wanted,
                                               std::size_t unknowns);

}  // namespace foredraw
