#pragma once
// Looks that are kept back: they decide nothing, and judge what the others decided.

#include <foredraw/overdraw/subject_layers.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foredraw {

/// Whether the look judges: every fifth, spread evenly over the looks of every pose and over all of them.
bool judges(std::size_t look);

/// Of a pixel of each look, in whole numbers, the heaviest at most 2^20: sums over all pixels stay far below 2^63.
std::vector<std::int64_t> pixel_weights(const SubjectLayers& seen);

}  // namespace foredraw
