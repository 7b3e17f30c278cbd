#pragma once
#include <foredraw/scene/scene.h>

#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// Why a draw can not be cut into frames; empty: it is one quad that shows its frame of an image of known size, with
/// nothing else than floating-point attributes.
std::string why_not_cut(const Scene& scene, const Draw& draw);

/// The draw once for each frame, all else as it was: its quad where that part of the quad was, with all attributes as
/// they were there. Corners that two frames share are equal in every bit. For a draw that can be cut.
std::vector<Draw> cut_draws(const Scene& scene, const Draw& draw, std::span<const SpriteFrame> frames);

}  // namespace foredraw
