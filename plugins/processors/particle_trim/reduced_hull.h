#pragma once
#include "pockets.h"

namespace foredraw::processors::particle_trim {

/// The edges that are left of a hull's when, again and again, the one is removed without which the polygon grows least,
/// until there are `most`, or none can be removed. Rising numbers.
std::vector<std::size_t> reduced_hull(const Pockets& pockets, std::size_t most);

}  // namespace foredraw::processors::particle_trim
