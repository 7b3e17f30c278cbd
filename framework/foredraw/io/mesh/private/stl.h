#pragma once
// STL, binary and ASCII. Private to io.

#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>

namespace foredraw::mesh_files {

inline constexpr std::size_t stl_header = 84;  ///< bytes before the first record of a binary file
inline constexpr std::size_t stl_record = 50;  ///< of a triangle in a binary file

/// By the length that the count asks for; the word "solid" at the beginning stands in files of both kinds.
bool is_binary_stl(std::string_view text);

/// The name behind "solid" or "endsolid", taken off the front of a text: what is left of the line, or what comes before
/// a facet that begins on it.
std::string_view take_solid_name(std::string_view& text);

bool read_stl(const Reading& reading, PolygonMesh& mesh);

}  // namespace foredraw::mesh_files
