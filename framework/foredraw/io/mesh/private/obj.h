#pragma once
// OBJ, line by line. Private to io.

#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>

namespace foredraw::mesh_files {

/// A line as OBJ has them: a backslash at the end of one joins the next to it.
struct ObjLine {
  std::string_view whole;  ///< without the line feed, a carriage return included
  std::string_view keyword;
  std::string_view rest;
};

/// Where a comment begins: at the first number sign that begins a word; npos: there is none.
std::size_t comment_in(std::string_view line);

/// The name that a line gives, which may hold spaces and number signs ("Material #25"). Only a number sign that stands
/// alone begins a comment.
std::string obj_name(std::string_view rest);

/// Takes the next line off the front of a text. False at its end.
bool take_obj_line(std::string_view& text, ObjLine& line);

/// The next token of a line's rest; empty at its end or at a comment.
std::string_view take_obj_token(std::string_view& rest);

/// How many records there are so far of what corners name.
struct ObjCounts {
  std::size_t positions = 0, texcoords = 0, normals = 0;

  /// Whether the line holds such a record; it is then counted.
  bool count(std::string_view keyword);
};

/// A texture coordinate or normal that cannot be there: number 0, or one before the first.
inline constexpr std::uint32_t absent = none - 1;

/// "3", "3/1", "3//2", "3/1/2" as records from 0 on; what follows the end of the numbers counts from back there.
/// Says what is wrong; empty: nothing. That a record exists is not checked where its number is positive.
std::string read_obj_corner(std::string_view token, const ObjCounts& so_far, Corner& corner);

/// `libraries`: what the lines `mtllib` name.
bool read_obj(const Reading& reading, PolygonMesh& mesh, std::vector<std::string>& libraries);

}  // namespace foredraw::mesh_files
