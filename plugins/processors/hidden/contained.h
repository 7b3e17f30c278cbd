#pragma once
// What lies wholly within something closed: hidden by proof, without a sample.

#include "connected.h"
#include "sight.h"

namespace foredraw::processors::hidden {

/// Of components of which all triangles are `asked` those that lie within one other component that hides, is closed and
/// faces outwards: no vertex of either is nearer to the other than a hundred thousandth of its size, no edge of one
/// passes through the other, and the outer one winds around a vertex of the inner one once. Every line from the inner
/// one to the outside then meets the front of the outer one, even where that passes through itself. Up to the rounding
/// of doubles. Both are known to stay together.
Flags inside_closed(const Sight& sight, const Connected& surface, const Flags& asked);

}  // namespace foredraw::processors::hidden
