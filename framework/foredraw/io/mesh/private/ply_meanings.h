#pragma once
// What the properties of a PLY file say of vertices and faces. Private to io.

#include <foredraw/io/mesh/private/ply.h>

namespace foredraw::mesh_files {

/// What a property of a vertex or face means to us.
enum class Meaning : std::uint8_t {
  x,
  y,
  z,
  nx,
  ny,
  nz,
  u,
  v,
  red,
  green,
  blue,
  alpha,
  corners,
  wedges,
  strip,
  nothing
};

struct PlyMeanings {
  std::vector<std::vector<Meaning>> of;  ///< [element][property]; what is not read means nothing
  bool has_normals = false;
  bool has_texcoords = false;  ///< of vertices, which count where the faces' corners have none of their own
  bool has_wedges = false;     ///< texture coordinates of the faces' corners
  Format color_format{Component::float32, 0, false, 0};  ///< no components: colours are not read
};

/// nullopt, with the error, where positions or the corners of faces are missing, or what is read stands there twice.
std::optional<PlyMeanings> ply_meanings(const Reading& reading, const PlyHeader& header);

/// Names the properties that mean nothing, which a scene cannot hold.
void tell_left_out(const Reading& reading, const PlyHeader& header, const PlyMeanings& meanings);

}  // namespace foredraw::mesh_files
