#include "surface_mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace foredraw::bench {

namespace {

void add_triangle(SurfaceMesh& to, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const glm::vec3 &p = to.places[a], &q = to.places[b], &r = to.places[c];
  if (p == q || q == r || r == p) return;
  to.indices.insert(to.indices.end(), {a, b, c});
}

/// [vertex] The least vertex at the same place.
std::vector<std::uint32_t> place_numbers(const std::vector<glm::vec3>& places) {
  std::vector<std::uint32_t> order(places.size()), numbers(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {},
                    [&](std::uint32_t v) { return std::make_tuple(places[v].x, places[v].y, places[v].z, v); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && places[order[i]] == places[order[i - 1]];
    numbers[order[i]] = is_same ? numbers[order[i - 1]] : order[i];
  }
  return numbers;
}

/// Vertices that no triangle has: of triangles that were left out.
void drop_unused(SurfaceMesh& mesh) {
  std::vector<bool> is_used(mesh.places.size(), false);
  for (const std::uint32_t index : mesh.indices) is_used[index] = true;
  std::vector<std::uint32_t> numbers(mesh.places.size());
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (!is_used[v]) continue;
    mesh.places[count] = mesh.places[v];
    mesh.uvs[count] = mesh.uvs[v];
    numbers[v] = count++;
  }
  mesh.places.resize(count);
  mesh.uvs.resize(count);
  for (std::uint32_t& index : mesh.indices) index = numbers[index];
}

/// Of length 1; `other` where it has no length.
glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& other) {
  const double length = std::sqrt(glm::dot(vector, vector));
  return length > 1e-30 ? vector / length : other;
}

/// At a right angle to a vector of length 1.
glm::dvec3 some_tangent(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return unit_or(axis - glm::dot(axis, normal) * normal, axis);
}

}  // namespace

void add_grid(SurfaceMesh& to, std::size_t columns, std::size_t rows, const GridPlace& place,
              const glm::dvec2& repeats) {
  const auto first = static_cast<std::uint32_t>(to.places.size());
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      to.places.emplace_back(place(i, j));
      to.uvs.emplace_back(repeats.x * static_cast<double>(i) / static_cast<double>(columns),
                          repeats.y * static_cast<double>(j) / static_cast<double>(rows));
    }
  }
  const auto width = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = first + j * width + i, b = a + 1, c = a + width, d = c + 1;
      add_triangle(to, a, b, d);
      add_triangle(to, a, d, c);
    }
  }
}

void add_cube(SurfaceMesh& to, std::size_t cells, const std::function<glm::dvec3(const glm::dvec3&)>& place,
              const glm::dvec2& repeats) {
  const auto along = [&](std::size_t i) {
    return (2 * static_cast<double>(i) - static_cast<double>(cells)) / static_cast<double>(cells);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      add_grid(
          to, cells, cells,
          [&](std::size_t i, std::size_t j) {
            glm::dvec3 at(0);
            at[axis] = side;
            at[(axis + 1) % 3] = side * along(i);  // so that the one cross the other points outwards on both sides
            at[(axis + 2) % 3] = along(j);
            return place(at);
          },
          repeats);
    }
  }
}

void add_mesh(SurfaceMesh& to, const SurfaceMesh& other) {
  const auto first = static_cast<std::uint32_t>(to.places.size());
  to.places.insert(to.places.end(), other.places.begin(), other.places.end());
  to.uvs.insert(to.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const std::uint32_t index : other.indices) to.indices.push_back(first + index);
}

void finish(SurfaceMesh& mesh) {
  drop_unused(mesh);
  const std::size_t count = mesh.places.size();
  const std::vector<std::uint32_t> numbers = place_numbers(mesh.places);
  std::vector<glm::dvec3> normals(count, glm::dvec3(0)), along_u(count, glm::dvec3(0)), along_v(count, glm::dvec3(0));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t corners[] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    const glm::dvec3 p(mesh.places[corners[0]]);
    const glm::dvec3 side = glm::dvec3(mesh.places[corners[1]]) - p, other = glm::dvec3(mesh.places[corners[2]]) - p;
    const glm::dvec2 uv(mesh.uvs[corners[0]]);
    const glm::dvec2 s = glm::dvec2(mesh.uvs[corners[1]]) - uv, t = glm::dvec2(mesh.uvs[corners[2]]) - uv;
    const double turned = s.x * t.y - t.x * s.y < 0 ? -1 : 1;
    for (const std::uint32_t corner : corners) {
      normals[numbers[corner]] += glm::cross(side, other);
      along_u[corner] += turned * (t.y * side - s.y * other);
      along_v[corner] += turned * (s.x * other - t.x * side);
    }
  }
  mesh.normals.resize(count);
  mesh.tangents.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const glm::dvec3 normal = unit_or(normals[numbers[v]], {0, 1, 0});
    const glm::dvec3 tangent = unit_or(along_u[v] - glm::dot(along_u[v], normal) * normal, some_tangent(normal));
    const double side = glm::dot(glm::cross(normal, tangent), along_v[v]) > 0 ? -1 : 1;
    mesh.normals[v] = normal;
    mesh.tangents[v] = glm::vec4(tangent, side);
  }
}

}  // namespace foredraw::bench
