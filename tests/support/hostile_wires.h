#pragma once
// Meshes that a finder of wires must survive.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace foredraw::testing {

struct HostileWire {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

  /// A tube of eight sides with its middle at each place; the last ring joins the first one where it is closed.
  void tube(std::uint32_t rings, const std::function<glm::dvec3(double)>& place, double radius, bool closed = false,
            bool inside_out = false) {
    constexpr std::uint32_t sides = 8;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t r = 0; r < rings; ++r) {
      const double t = static_cast<double>(r) / (closed ? rings : rings - 1);
      const glm::dvec3 way = glm::normalize(place(t + 1e-3) - place(t - 1e-3));
      const glm::dvec3 u =
          glm::normalize(glm::cross(way, std::abs(way.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
      const glm::dvec3 v = glm::cross(way, u);
      for (std::uint32_t s = 0; s < sides; ++s) {
        const double angle = 2 * std::numbers::pi * s / sides;
        positions.emplace_back(place(t) + radius * (std::cos(angle) * u + std::sin(angle) * v));
      }
    }
    for (std::uint32_t r = 0; r + (closed ? 0 : 1) < rings; ++r) {
      for (std::uint32_t s = 0; s < sides; ++s) {
        const std::uint32_t a = first + r * sides + s, b = first + r * sides + (s + 1) % sides;
        const std::uint32_t c = first + (r + 1) % rings * sides + s,
                            d = first + (r + 1) % rings * sides + (s + 1) % sides;
        inside_out ? triangle(a, d, b) : triangle(a, b, d);
        inside_out ? triangle(a, c, d) : triangle(a, d, c);
      }
    }
  }
};

inline glm::dvec3 straight(double t) { return {10 * t, 0, 0}; }

inline glm::dvec3 around(double t) {
  const double angle = 2 * std::numbers::pi * t;
  return {3 * std::cos(angle), 0, 3 * std::sin(angle)};
}

inline HostileWire straight_tube(double radius) {
  HostileWire mesh;
  mesh.tube(20, straight, radius);
  return mesh;
}

inline HostileWire scaled_tube(double scale) {
  HostileWire mesh;
  mesh.tube(
      20, [&](double t) { return scale * straight(t); }, scale * 0.1);
  return mesh;
}

inline HostileWire rings_that_coincide() {
  HostileWire mesh;
  mesh.tube(
      40, [](double t) { return straight(std::floor(t * 20) / 20); }, 0.1);
  return mesh;
}

inline HostileWire tube_twice() {
  HostileWire mesh = straight_tube(0.1);
  mesh.tube(20, straight, 0.1);
  return mesh;
}

inline HostileWire tube_with(float bad) {
  HostileWire mesh = straight_tube(0.1);
  mesh.positions[77].y = bad;
  return mesh;
}

inline HostileWire inside_out_tube() {
  HostileWire mesh;
  mesh.tube(20, straight, 0.1, false, true);
  return mesh;
}

inline HostileWire wire_ring() {
  HostileWire mesh;
  mesh.tube(64, around, 0.1, true);
  return mesh;
}

/// Each turn lies on the last one, and shares its vertices.
inline HostileWire coil_welded_turn_to_turn() {
  HostileWire mesh;
  constexpr std::uint32_t turns = 8, sides = 24;
  for (std::uint32_t level = 0; level <= turns; ++level) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const glm::dvec3 at = around(static_cast<double>(i) / sides);
      mesh.positions.emplace_back(at.x, 0.2 * level, at.z);
      mesh.positions.emplace_back(1.1 * at.x, 0.2 * level, 1.1 * at.z);
    }
  }
  for (std::uint32_t level = 0; level < turns; ++level) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const auto number = [&](std::uint32_t l, std::uint32_t j, std::uint32_t out) {
        return 2 * (l * sides + j % sides) + out;
      };
      const std::uint32_t corner[8] = {number(level, i, 0),         number(level, i, 1),        number(level + 1, i, 1),
                                       number(level + 1, i, 0),     number(level, i + 1, 0),    number(level, i + 1, 1),
                                       number(level + 1, i + 1, 1), number(level + 1, i + 1, 0)};
      for (std::uint32_t s = 0; s < 4; ++s) {
        mesh.triangle(corner[s], corner[(s + 1) % 4], corner[4 + (s + 1) % 4]);
        mesh.triangle(corner[s], corner[4 + (s + 1) % 4], corner[4 + s]);
      }
    }
  }
  return mesh;
}

inline HostileWire wire_knot() {
  HostileWire mesh;
  mesh.tube(
      400,
      [](double t) {
        const double a = 2 * std::numbers::pi * t;
        return glm::dvec3(std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a), -std::sin(3 * a));
      },
      0.1, true);
  return mesh;
}

inline HostileWire moebius_ribbon() {
  HostileWire mesh;
  constexpr std::uint32_t sides = 48;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const glm::dvec3 out(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
    const glm::dvec3 across = std::cos(angle / 2) * out + std::sin(angle / 2) * up;
    mesh.positions.emplace_back(3.0 * out + 0.05 * across);
    mesh.positions.emplace_back(3.0 * out - 0.05 * across);
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const bool last = i + 1 == sides;
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangle(a, b, d);
    mesh.triangle(a, d, c);
  }
  return mesh;
}

/// Two walls around one centre line.
inline HostileWire pipe_in_a_pipe() {
  HostileWire mesh;
  mesh.tube(20, straight, 0.1);
  mesh.tube(20, straight, 0.08, false, true);
  return mesh;
}

inline HostileWire one_triangle() {
  HostileWire mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {10, 0.1f, 0}};
  mesh.triangle(0, 1, 2);
  return mesh;
}

inline HostileWire chain_link_net() {
  HostileWire mesh;
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (const double lean : {1.0, -1.0}) {
      mesh.tube(
          24, [&](double t) { return glm::dvec3(0.3 * i + lean * 2 * t, 2 * t, 0.02 * std::sin(40 * t)); }, 0.01);
    }
  }
  return mesh;
}

/// Steps of the grid are half the radius.
inline HostileWire tube_of_two_steps() {
  HostileWire mesh;
  mesh.tube(
      60, [](double t) { return glm::dvec3(400 * t, 60 * t * t, 0); }, 2.2);
  for (glm::vec3& at : mesh.positions) at = glm::vec3(std::round(at.x), std::round(at.y), std::round(at.z));
  return mesh;
}

inline HostileWire wires_that_share_vertices() {
  HostileWire mesh;
  mesh.tube(20, straight, 0.1);
  const std::size_t first = mesh.positions.size();
  mesh.tube(
      20, [](double t) { return glm::dvec3(10 + 10 * t, 0, 0); }, 0.1);
  mesh.positions[first] = mesh.positions[first - 8];  // in one vertex
  return mesh;
}

inline HostileWire three_sheets_at_an_edge() {
  HostileWire mesh;
  mesh.positions = {{0, 0, 0},        {10, 0, 0},        {0, 0.2f, 0},      {10, 0.2f, 0},
                    {0, -0.2f, 0.1f}, {10, -0.2f, 0.1f}, {0, -0.2f, -0.1f}, {10, -0.2f, -0.1f}};
  for (const std::uint32_t side : {2u, 4u, 6u}) {
    mesh.triangle(0, 1, side + 1);
    mesh.triangle(0, side + 1, side);
  }
  return mesh;
}

/// A sheet that is folded again and again.
inline HostileWire pleated_sheet() {
  HostileWire mesh;
  constexpr std::uint32_t columns = 60, rows = 40;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) mesh.positions.emplace_back(0.1f * (x % 2), 0.1f * y, 0.1f * x);
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + columns + 1;
      mesh.triangle(a, a + 1, b + 1);
      mesh.triangle(a, b + 1, b);
    }
  }
  return mesh;
}

/// Two closed shells that have a vertex in common, or an edge.
inline HostileWire shells_that_touch(bool in_an_edge) {
  HostileWire mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::uint32_t apex = in_an_edge ? 3 : 0;
  mesh.positions.insert(mesh.positions.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  const auto shell = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    for (const auto& [x, y, z] : {std::array{a, c, b}, std::array{a, b, d}, std::array{b, c, d}, std::array{c, a, d}})
      mesh.triangle(x, y, z);
  };
  shell(0, 1, 2, 3);
  in_an_edge ? shell(0, 4, 5, apex) : shell(apex, 5, 4, 6);
  return mesh;
}

/// All of them, by name.
inline std::vector<std::pair<std::string, HostileWire>> hostile_wires() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  return {{"zero-radius", straight_tube(0)},
          {"rings-that-coincide", rings_that_coincide()},
          {"twice", tube_twice()},
          {"no-number", tube_with(nan)},
          {"infinite", tube_with(inf)},
          {"1e-30", scaled_tube(1e-30)},
          {"1e30", scaled_tube(1e30)},
          {"ring", wire_ring()},
          {"welded-coil", coil_welded_turn_to_turn()},
          {"knot", wire_knot()},
          {"moebius", moebius_ribbon()},
          {"pipe-in-a-pipe", pipe_in_a_pipe()},
          {"inside-out", inside_out_tube()},
          {"one-triangle", one_triangle()},
          {"chain-link", chain_link_net()},
          {"two-steps-a-radius", tube_of_two_steps()},
          {"shared-vertices", wires_that_share_vertices()},
          {"three-sheets-at-an-edge", three_sheets_at_an_edge()},
          {"pleats", pleated_sheet()},
          {"touching-in-a-vertex", shells_that_touch(false)},
          {"touching-in-an-edge", shells_that_touch(true)}};
}

}  // namespace foredraw::testing
