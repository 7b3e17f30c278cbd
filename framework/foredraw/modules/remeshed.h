#pragma once
#include <foredraw/scene/draw.h>

#include <span>

namespace foredraw {

/// Other triangles of a draw's vertices, as a technique answers them. Not yet checked.
struct Remesh {
  std::vector<std::uint32_t> indices;      ///< three a triangle, of new vertices
  std::vector<std::uint32_t> vertex_from;  ///< [new vertex] = old one
};

/// The draw, which has one level, with these triangles: attributes and morph targets of each vertex are those of the
/// one that it comes from. It has one order, and no clusters. std::runtime_error where the answer is none: a number
/// names nothing, there are more triangles or vertices than before, or none is left of some.
Draw remeshed(const Draw& draw, Remesh answer);

}  // namespace foredraw
