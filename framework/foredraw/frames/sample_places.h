#pragma once
// Where in a pixel its samples are.

#include <glm/vec2.hpp>

#include <vector>

namespace foredraw {

/// From the pixel's middle, to the right and upwards, in pixels.
using SamplePlaces = std::vector<glm::dvec2>;

/// The standard places of 1, 2, 4 or 8 samples: as Direct3D and Vulkan have them. std::invalid_argument for any other
/// number.
SamplePlaces standard_places(int samples);

/// Hammersley's set in base 2: so many columns of one sample each, so many rows, and even in between. Unlike a grid's,
/// no straight edge finds its places in a row. `other`: rows are shifted, so that two truths of equal worth
/// can be held against each other. std::invalid_argument unless `samples` is a power of two up to 2^16.
SamplePlaces hammersley_places(int samples, bool other = false);

}  // namespace foredraw
