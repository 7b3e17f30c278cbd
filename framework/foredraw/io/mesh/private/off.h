#pragma once
// OFF, line by line: comments and empty lines do not count. Private to io.

#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>

namespace foredraw::mesh_files {

struct OffHeader {
  bool has_texcoords = false, has_colors = false, has_normals = false;
  std::uint64_t vertices = 0, faces = 0;
  std::string_view body;  ///< what follows the counts
};

/// The next line that holds something, its comment cut off; nothing at the end.
std::string_view take_off_line(std::string_view& text);

struct OffFace {
  std::string_view size;                  ///< how many corners it states
  std::vector<std::string_view> corners;  ///< the numbers of its vertices
  bool has_more = false;                  ///< on its line: a colour
  std::string_view whole;                 ///< from its size to what is last on its line, or its lines
};

/// The next face. It may go over several lines, which then hold nothing but its corners. False: there is none like
/// that.
bool take_off_face(std::string_view& text, OffFace& face);

std::optional<OffHeader> read_off_header(const Reading& reading);
bool read_off(const Reading& reading, PolygonMesh& mesh);

}  // namespace foredraw::mesh_files
