#pragma once
// A subject as it was seen: what hides what, for those who sort pieces of its draws.

#include <foredraw/overdraw/layers.h>
#include <foredraw/overdraw/overdraw_figures.h>
#include <foredraw/scene/clusters.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// One draw that is to be ordered.
struct AtomicDraw {
  std::span<const std::uint32_t> indices;  ///< three a triangle, each below `vertex_count`
  std::size_t vertex_count = 0;
  Clusters atoms;  ///< what is moved as one
};

/// An owner of layers as a piece of the draw that is ordered. A draw that is seen twice has two owners for a piece.
struct LayerOwner {
  std::uint32_t part = 0;  ///< in the sequence in which parts are drawn
  std::uint32_t draw = 0;
  std::uint32_t piece = 0;  ///< of the draw
};

/// A look is a pose seen from a direction.
struct SubjectLayers {
  std::vector<AtomicDraw> draws;
  std::vector<LayerOwner> owners;      ///< of the layers: the atoms of each part, part by part as they are drawn
  Layers layers;                       ///< [look] in place of views
  std::vector<glm::dvec3> directions;  ///< [look] to the camera
  std::vector<double> weights;         ///< [look]
  std::vector<std::uint32_t> poses;    ///< [look] rising numbers; empty: all show the same pose
};

/// [draw][rank] = atom: the order that there is.
std::vector<std::vector<std::uint32_t>> as_it_came(const SubjectLayers& subject);

/// What the looks count, drawn in one order: [draw][rank] = atom. `sequence`: [rank] = part; none: as they came.
std::vector<OverdrawCount> counts_of(const SubjectLayers& subject, std::span<const std::vector<std::uint32_t>> atoms,
                                     std::span<const std::uint32_t> sequence = {});

/// The owners with their parts numbered as they are drawn in the sequence; none: as they came.
std::vector<LayerOwner> owners_in(const SubjectLayers& subject, std::span<const std::uint32_t> sequence);

/// [look] which of k groups it is in to begin with: that of the nearest of k even directions, turned at random.
std::vector<std::uint8_t> parted_by_direction(const SubjectLayers& subject, std::size_t k, std::uint64_t seed);

/// The sum over all looks, each as heavy as it is.
ViewTally tally_of(const SubjectLayers& subject, std::span<const OverdrawCount> counts);

}  // namespace foredraw
