#pragma once
// What the numbers of a stream are, and what may be done with them.

#include <foredraw/scene/vertex_streams.h>

namespace foredraw {

/// What lies between two values of the stream is a value, too; not so numbers of joints, and whole numbers that count
/// something else than an amount, such as identifiers.
bool is_amount(const VertexStream& stream);

/// Whether its first three components point somewhere.
bool is_direction(const VertexStream& stream);

}  // namespace foredraw
