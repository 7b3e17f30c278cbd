#pragma once
#include <foredraw/base/content_hash.h>
#include <foredraw/scene/material.h>

namespace foredraw {

/// Of all that it says; its image by number.
Stamp stamp_of(const Displacement& displacement);

}  // namespace foredraw
