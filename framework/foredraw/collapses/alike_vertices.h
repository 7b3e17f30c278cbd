#pragma once
// Vertices at one place that differ in nothing but directions: in normals and tangents, as where faces are shaded flat.

#include <foredraw/collapses/attribute_rows.h>

namespace foredraw {

/// As AttributeRows::alike. By the bytes of all streams and morph targets, whether they count or not.
std::vector<std::uint32_t> alike_vertices(const JoinedMesh& mesh);

/// The same by the numbers of rows, of vertices of which nothing else is known. None where there are no directions.
std::vector<std::uint32_t> alike_vertices(const AttributeRows& rows, std::span<const glm::vec3> positions);

}  // namespace foredraw
