#include "support/thin_scenes.h"

#include "support/meshes.h"

#include <foredraw/base/random.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <numbers>

namespace foredraw::testing {

namespace {

constexpr int wire_sides = 8;  // as in the demonstration of the paper
constexpr float pi = std::numbers::pi_v<float>;

/// At right angles to a direction, and to each other.
std::pair<glm::vec3, glm::vec3> sides_of(const glm::vec3& axis) {
  const glm::vec3 other = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 side = glm::normalize(glm::cross(axis, other));
  return {side, glm::cross(side, axis)};
}

template <class T>
VertexStream stream_of(const char* semantic, const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {semantic,
          {Component::float32, sizeof(T) / sizeof(float), false, sizeof(T)},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// Ten lines through a ring around the middle, at all angles and one before the other.
template <class Add>
void for_ten_lines(FrameSize size, Add add) {
  const float edge = static_cast<float>(std::min(size.width, size.height));
  for (int i = 0; i < 10; ++i) {
    const float angle = pi * (static_cast<float>(i) / 10 + 0.013f), turn = 2 * pi * static_cast<float>(3 * i % 10) / 10;
    const glm::vec3 middle(0.3f * edge * std::cos(turn), 0.3f * edge * std::sin(turn),
                           0.03f * edge * static_cast<float>(i));
    add(middle, glm::vec3(std::cos(angle), std::sin(angle), 0), 0.32f * edge);
  }
}

}  // namespace

void ThinMesh::add_tube(const std::vector<glm::vec3>& points, float radius, int sides) {
  const float outer = radius / std::cos(pi / static_cast<float>(sides));
  const auto first = static_cast<std::uint32_t>(positions.size()), n = static_cast<std::uint32_t>(sides);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 axis = glm::normalize(points[std::min(p + 1, points.size() - 1)] - points[p == 0 ? 0 : p - 1]);
    const auto [right, up] = sides_of(axis);
    for (int s = 0; s < sides; ++s) {
      const float angle = 2 * pi * (static_cast<float>(s) + 0.3f) / static_cast<float>(sides);
      const glm::vec3 outwards = outer * (std::cos(angle) * right + std::sin(angle) * up);
      positions.push_back(points[p] + outwards);
      wires.emplace_back(-outwards, radius);
      axes.emplace_back(axis, 0);
    }
  }
  for (std::uint32_t p = 0; p + 1 < points.size(); ++p) {
    for (std::uint32_t s = 0; s < n; ++s) {
      const std::uint32_t a = first + p * n + s, b = first + p * n + (s + 1) % n, c = a + n, d = b + n;
      for (const std::uint32_t corner : {a, c, b, b, c, d}) indices.push_back(corner);
    }
  }
}

void ThinMesh::add_ribbon(const std::vector<glm::vec3>& points, const glm::vec3& across, float half_breadth) {
  const auto first = static_cast<std::uint32_t>(positions.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 axis = glm::normalize(points[std::min(p + 1, points.size() - 1)] - points[p == 0 ? 0 : p - 1]);
    for (const float side : {-half_breadth, half_breadth}) {
      positions.push_back(points[p] + side * across);
      wires.emplace_back(-side * across, half_breadth);
      axes.emplace_back(axis, 1);
    }
  }
  for (std::uint32_t p = 0; p + 1 < points.size(); ++p) {
    const std::uint32_t a = first + 2 * p, b = a + 1, c = a + 2, d = a + 3;
    for (const std::uint32_t corner : {a, c, b, b, c, d}) indices.push_back(corner);
  }
}

void ThinMesh::add_box(const glm::vec3& half, const glm::vec3& along_x, const glm::vec3& along_y,
                       const glm::vec3& centre) {
  const glm::vec3 along_z = glm::cross(along_x, along_y);
  const glm::vec3 axes_of[3] = {along_x * half.x, along_y * half.y, along_z * half.z};
  for (int face = 0; face < 6; ++face) {
    const float side = face < 3 ? 1.0f : -1.0f;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      glm::vec3 by(0);  // along each axis, summed in one sequence, so that faces meet to the bit
      by[face % 3] = side;
      by[(face + 1) % 3] = corner.x * side;
      by[(face + 2) % 3] = corner.y;
      positions.push_back(centre + by.x * axes_of[0] + by.y * axes_of[1] + by.z * axes_of[2]);
      wires.emplace_back(0);
      axes.emplace_back(0);
    }
    for (const std::uint32_t corner : {0, 1, 2, 0, 2, 3}) indices.push_back(first + corner);
  }
}

Scene scene_of(const ThinMesh& mesh, const glm::vec3& colour, bool has_wires) {
  Scene scene = scene_of(TestMesh{mesh.positions, mesh.indices});
  Material material;
  material.colour = colour;
  scene.materials.push_back(material);
  scene.draws[0].material = 0;
  if (!has_wires) return scene;
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  vertices->base.push_back(stream_of("_FOREDRAW_WIRE", mesh.wires));
  vertices->base.push_back(stream_of("_FOREDRAW_WIRE_AXIS", mesh.axes));
  scene.draws[0].full().vertices = vertices;
  return scene;
}

FrameCamera pixel_camera(FrameSize size, double distance) {
  FrameCamera camera = looking_at({0, 0, distance}, {0, 0, 0});
  camera.half_height = size.height / (2 * distance);
  camera.near = distance / 100;
  return camera;
}

std::vector<FrameCamera> pixel_cameras_around(FrameSize size, int views) {
  std::vector<FrameCamera> cameras;
  for (int view = 0; view < views; ++view) {  // along a spiral by the golden angle
    const double y = (2 * view + 1.0) / views - 1, radius = std::sqrt(1 - y * y),
                 angle = 2.399963229728653 * view + 0.4;
    FrameCamera camera =
        looking_at(1000.0 * glm::dvec3(radius * std::cos(angle), y, radius * std::sin(angle)), {0, 0, 0});
    camera.half_height = size.height / 2000.0;
    camera.near = 10;
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<FrameCamera> sliding(const FrameCamera& camera, int frames, const glm::dvec2& step) {
  std::vector<FrameCamera> all(static_cast<std::size_t>(frames), camera);
  for (int f = 0; f < frames; ++f) {
    all[static_cast<std::size_t>(f)].eye += static_cast<double>(f) * (step.x * camera.right + step.y * camera.up);
  }
  return all;
}

ThinMesh lines_at_all_angles(float radius, FrameSize size) {
  ThinMesh mesh;
  for_ten_lines(size, [&](const glm::vec3& middle, const glm::vec3& along, float reach) {
    mesh.add_tube({middle - reach * along, middle + reach * along}, radius, wire_sides);
  });
  return mesh;
}

ThinMesh ribbons_at_all_angles(float half_breadth, FrameSize size) {
  ThinMesh mesh;
  float turn = 0.05f;
  for_ten_lines(size, [&](const glm::vec3& middle, const glm::vec3& along, float half_length) {
    const glm::vec3 aside(-along.y, along.x, 0);
    const glm::vec3 across = std::cos(turn) * aside + std::sin(turn) * glm::vec3(0, 0, 1);
    mesh.add_ribbon({middle - half_length * along, middle + half_length * along}, across, half_breadth);
    turn += 0.16f;  // the last one to within 4 degrees of its edge
  });
  return mesh;
}

ThinMesh crossing_wires(float radius, float length) {
  ThinMesh mesh;
  const float depth = 8 * radius;
  mesh.add_tube({{-length, -0.3f * length, depth}, {length, 0.4f * length, depth}}, radius, wire_sides);
  mesh.add_tube({{-length, 0.5f * length, 0}, {length, -0.2f * length, 0}}, radius, wire_sides);
  mesh.add_tube({{0.1f * length, -length, -depth}, {-0.2f * length, length, -depth}}, radius, wire_sides);
  return mesh;
}

ThinMesh road_wires(float radius) {
  ThinMesh mesh;
  for (int span = 0; span < 8; ++span) {
    for (int wire = 0; wire < 3; ++wire) {
      std::vector<glm::vec3> points;
      for (int i = 0; i <= 12; ++i) {
        const float part = static_cast<float>(i) / 12, sag = 4 * part * (1 - part);
        points.emplace_back(4 + 0.6f * static_cast<float>(wire), 6 - 0.9f * sag,
                            -30 * (static_cast<float>(span) + part));
      }
      mesh.add_tube(points, radius, wire_sides);
    }
  }
  return mesh;
}

FrameCamera road_camera() {
  FrameCamera camera = looking_at({0, 1.7, 4}, {2.5, 4.5, -40});
  camera.near = 0.05;
  return camera;
}

ThinMesh turned_box(float edge) {
  ThinMesh mesh;
  const glm::vec3 x = glm::normalize(glm::vec3(0.8f, 0.25f, -0.55f));
  const glm::vec3 y = glm::normalize(glm::cross(glm::vec3(0.5f, 0.1f, 0.86f), x));
  mesh.add_box(glm::vec3(edge / 2), x, y, {0.21f, -0.37f, 0});
  return mesh;
}

ThinMesh bars(float width, FrameSize size) {
  ThinMesh mesh;
  for_ten_lines(size, [&](const glm::vec3& middle, const glm::vec3& along, float reach) {
    mesh.add_box({reach, width / 2, width / 2}, along, glm::vec3(-along.y, along.x, 0), middle);
  });
  return mesh;
}

ThinMesh cylinder(float radius, int sides, float length) {
  ThinMesh mesh;
  const glm::vec3 axis = glm::normalize(glm::vec3(0.35f, 0.9f, 0.2f));
  mesh.add_tube({-length / 2 * axis, length / 2 * axis}, radius, sides);
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    const auto first = static_cast<std::uint32_t>(end * static_cast<std::size_t>(sides));
    for (std::uint32_t s = 1; s + 1 < static_cast<std::uint32_t>(sides); ++s) {
      for (const std::uint32_t corner : end == 0 ? std::array{0u, s, s + 1} : std::array{0u, s + 1, s}) {
        mesh.indices.push_back(first + corner);
      }
    }
  }
  return mesh;
}

ThinMesh grass_cards(int blades, std::uint64_t seed, FrameSize size) {
  ThinMesh mesh;
  Random random(seed);
  const auto between = [&](float from, float to) { return from + (to - from) * static_cast<float>(random.unit()); };
  for (int blade = 0; blade < blades; ++blade) {
    const glm::vec3 foot(between(-0.4f, 0.4f) * static_cast<float>(size.width),
                         between(-0.4f, 0.1f) * static_cast<float>(size.height), between(-40, 40));
    const glm::vec3 top = foot + glm::vec3(between(-12, 12), between(20, 50), between(-12, 12));
    const float half = between(0.5f, 2);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 middle = (foot + top) / 2.0f + glm::vec3(between(-3, 3), 0, 0);
    for (const glm::vec3& p : {foot - glm::vec3(half, 0, 0), foot + glm::vec3(half, 0, 0),
                               middle - glm::vec3(0.7f * half, 0, 0), middle + glm::vec3(0.7f * half, 0, 0), top}) {
      mesh.positions.push_back(p);
      mesh.wires.emplace_back(0);
      mesh.axes.emplace_back(0);
    }
    for (const std::uint32_t corner : {0, 1, 2, 2, 1, 3, 2, 3, 4}) mesh.indices.push_back(first + corner);
  }
  return mesh;
}

}  // namespace foredraw::testing
