#pragma once
// Meshes of which is known what in them is a wire: labelled by hand, or made.

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::bench {

/// What somebody who knows would say of a triangle, beside the number of a wire.
inline constexpr std::uint32_t no_wire = ~std::uint32_t{0};
inline constexpr std::uint32_t either_way = no_wire - 1;

struct KnownMesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> wire_of;  ///< [triangle] its wire, no_wire or either_way
  std::vector<double> length;          ///< [wire]
  // Of made ones alone:
  std::vector<glm::dvec3> centre;  ///< [vertex]
  std::vector<double> half_width;  ///< [vertex] the least; 0: not asked for, as at joints
};

/// The meshes that the list of labels names, of files below the folder; those that are not there are left out.
/// Throws std::runtime_error where the list is wrong.
std::vector<KnownMesh> labelled_meshes(const std::filesystem::path& labels, const std::filesystem::path& folder);

/// Wires of many kinds, and what looks like one and is none, made from a seed.
std::vector<KnownMesh> made_meshes(std::uint64_t seed);

/// A tube of a straight line, of about so many triangles: for times.
KnownMesh fine_tubes(std::uint32_t triangles);
/// Bodies as a lathe makes them, of about so many triangles: each ring may begin a wire, and none is one.
KnownMesh turned_bodies(std::uint32_t triangles);
/// So many hairs, which are ribbons of four quads.
KnownMesh hairs(std::uint32_t count);

}  // namespace foredraw::bench
