#pragma once
// What the mesh readers deliver: records as their file numbers them, and faces whose corners name records. No
// connectivity is asked of it, so any soup of polygons fits. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/scene/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw::mesh_files {

inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// The records that a corner, or a vertex made for it, consists of.
struct Corner {
  std::uint32_t position = none;
  std::uint32_t texcoord = none;
  std::uint32_t normal = none;
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// Faces that are drawn together: of one object, with one material. Both names may be empty.
struct Part {
  std::string object;
  std::string material;
  friend auto operator<=>(const Part&, const Part&) = default;
};

struct PolygonMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;  ///< as glTF counts them: (0, 0) is the upper left corner
  std::vector<glm::vec3> normals;
  Format color_format{Component::float32, 0, false, 0};
  std::vector<std::byte> colors;  ///< one for each position, or none at all
  bool whole_vertices = false;    ///< a position's record is the whole vertex: texcoord and normal have its number

  std::vector<Corner> corners;
  std::vector<std::uint32_t> ends;  ///< [face] = one past its last corner
  std::vector<std::uint32_t> part;  ///< [face]; empty: all faces are of the first
  std::vector<Part> parts{Part{}};

  std::size_t face_count() const { return ends.size(); }
  std::size_t first_corner(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  std::span<const Corner> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner(i), ends[i] - first_corner(i));
  }
};

/// Cuts polygons into triangles.
class Triangulator {
 public:
  /// `corners`: how many there are in all polygons to come. It bounds the work that they share: ear clipping takes the
  /// square of a polygon's corners where many point inwards, and a file may hold what would take hours.
  explicit Triangulator(std::size_t corners) : tests_left_(64 * corners + 50'000'000) {}

  /// n - 2 triangles for n >= 3 points, as numbers of points, wound as the polygon is. By ear clipping (Meisters,
  /// "Polygons Have Ears", 1975) in the plane of the polygon's area vector; where no ear is left, as in polygons that
  /// cross themselves, or all the work is spent, the rest becomes a fan.
  void cut(std::span<const glm::vec3> points, std::vector<std::array<std::uint32_t, 3>>& triangles);

  /// Polygons that became fans, at least in part, for want of ears; for want of work.
  std::size_t earless() const { return earless_; }
  std::size_t unfinished() const { return unfinished_; }

 private:
  std::size_t tests_left_;
  std::size_t earless_ = 0, unfinished_ = 0;
};

/// What a draw was made of.
struct DrawRecords {
  std::vector<std::uint32_t> faces;  ///< [triangle] = the face's number in the file
  std::vector<Corner> vertices;      ///< [vertex] = its records; empty: each is the record of its own number
};

struct MeshScene {
  Scene scene;
  std::vector<DrawRecords> draws;
};

/// `materials`: those that the file's libraries hold; parts may name others. nullopt, with an error, where there is
/// nothing to draw.
std::optional<MeshScene> scene_of(const PolygonMesh& mesh, std::vector<Material> materials, const std::string& name,
                                  Diagnostics& diagnostics);

}  // namespace foredraw::mesh_files
