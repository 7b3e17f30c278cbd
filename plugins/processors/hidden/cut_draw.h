#pragma once
#include <foredraw/scene/draw.h>

namespace foredraw::processors::hidden {

/// The draw without some of its triangles; [triangle] 1: it goes. Its vertices stay. Where every triangle goes, one
/// without area stands for them, so that the draw keeps its place, and no file is left with an empty one.
void cut(Draw& draw, const std::vector<std::uint8_t>& goes);

}  // namespace foredraw::processors::hidden
