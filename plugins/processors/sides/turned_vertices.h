#pragma once
// Vertices of reversed triangles: copies whose normals and tangents point the other way.

#include <foredraw/scene/vertex_streams.h>

#include <memory>
#include <span>

namespace foredraw::processors::sides {

/// The streams with copies of some vertices behind them. Of a copy NORMAL and TANGENT are negated in every component,
/// the tangent's handedness too, and so are the changes of both in every morph target: the shader gets what it would
/// make of them for the back of a double-sided triangle (glTF 2.0, 3.9.6). Integers saturate: -128 becomes 127.
/// A copy of a tangent of no length gets one at a right angle to the normal.
std::shared_ptr<const VertexStreams> with_turned_copies(const VertexStreams& streams,
                                                        std::span<const std::uint32_t> copies);

}  // namespace foredraw::processors::sides
