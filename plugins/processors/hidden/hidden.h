#pragma once
// Triangles that no camera sees, by pictures and rays from where cameras may be. Source: own.

#include <foredraw/base/parallel.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace foredraw {

namespace processors::hidden {

/// What goes or stays as one.
enum class Unit {
  component,  ///< what hangs together
  triangle,   ///< single triangles, but for two rings around what is seen
};

/// Where cameras are.
enum class SeenFrom {
  outside,  ///< anywhere outside
  above,    ///< outside, and no lower than the middle
  box,      ///< in boxes alone
  points,   ///< at points alone
};

/// Pixels of some pictures.
struct Pixels {
  std::uint64_t asked = 0;  ///< that show what was asked for
  std::uint64_t shown = 0;  ///< that show anything

  Pixels& operator+=(const Pixels& other) {
    asked += other.asked;
    shown += other.shown;
    return *this;
  }
};

/// Called between steps; may throw to end the search.
using BetweenSteps = std::function<void()>;

}  // namespace processors::hidden

struct HiddenOptions {
  processors::hidden::Unit unit = processors::hidden::Unit::component;
  int views = 642;   ///< pictures without perspective; a quarter as many are taken from a distance of 1.3 radii
  int size = 512;    ///< pixels along each edge of them
  int rays = 1024;   ///< of a triangle that no picture shows
  int checks = 300;  ///< pictures, from views that decided nothing, that the rest is checked with, again and again
  std::uint64_t seed = 0;
};

/// A draw where it stands; front faces turn counter-clockwise.
struct OpaqueOrNot {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;  ///< three a triangle, each below the number of positions
  bool is_double_sided = false;
  bool is_opaque = true;  ///< else it hides nothing
};

struct HiddenTriangles {
  std::vector<std::vector<std::uint8_t>> is_hidden;  ///< [draw][triangle] 0 or 1
  std::vector<std::vector<std::uint8_t>> is_proved;  ///< the same of those that lie within something closed: no sample
  processors::hidden::Pixels
      last_check;  ///< pixels of the last check that still showed something hidden: what was put back then
};

/// The triangles of things that stand together which no camera outside sees: no picture shows them, no ray gets from
/// them to the outside. No number of samples is a proof. Triangles that are not finite stay. The same at any number of
/// threads. O((views + checks) * (triangles + pixels) + rays * hidden triangles * log triangles).
HiddenTriangles hidden_triangles(std::span<const OpaqueOrNot> draws, const HiddenOptions& options,
                                 const Executor& executor);

struct Plugin;
Plugin hidden_plugin();

}  // namespace foredraw
