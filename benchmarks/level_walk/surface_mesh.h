#pragma once
// Triangles that are made up: put together of grids, with normals and tangents of their own.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace foredraw::bench {

/// [vertex] places, normals and so on; three indices a triangle, counter-clockwise as seen from outside.
struct SurfaceMesh {
  std::vector<glm::vec3> places;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;  ///< as glTF has them: w is the side of the bitangent, which points along -v
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;

  std::size_t triangles() const { return indices.size() / 3; }
};

/// Where vertex (i, j) of a grid lies.
using GridPlace = std::function<glm::dvec3(std::size_t i, std::size_t j)>;

/// Adds columns times rows quadrilaterals, of two triangles each; triangles without area (two corners at one place) are
/// left out. The outer side is the one to which i cross j points. Texture coordinates go from (0, 0) to `repeats`.
void add_grid(SurfaceMesh& to, std::size_t columns, std::size_t rows, const GridPlace& place,
              const glm::dvec2& repeats = glm::dvec2(1));

/// Adds the six sides of a cube from -1 to 1, of cells times cells quadrilaterals each, with every place moved by
/// `place`. Sides meet exactly, whatever they are moved by.
void add_cube(SurfaceMesh& to, std::size_t cells, const std::function<glm::dvec3(const glm::dvec3&)>& place,
              const glm::dvec2& repeats = glm::dvec2(1));

/// Adds the other one, as it is.
void add_mesh(SurfaceMesh& to, const SurfaceMesh& other);

/// Leaves out vertices that no triangle has, and replaces normals and tangents: normals are the mean over the triangles
/// at a place (weighted by area, whatever vertex has them), so that seams of texture coordinates do not show; tangents
/// those of a vertex' own triangles.
void finish(SurfaceMesh& mesh);

}  // namespace foredraw::bench
