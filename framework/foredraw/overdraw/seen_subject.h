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

/// A node is a pose seen from a direction.
struct SeenSubject {
  std::vector<AtomicDraw> draws;
  std::vector<LayerOwner> owners;      ///< of the layers: the atoms of each part, part by part as they are drawn
  Layers layers;                       ///< [node] in place of views
  std::vector<glm::dvec3> directions;  ///< [node] to the camera
  std::vector<double> weights;         ///< [node]
};

/// [draw][place] = atom: the order that there is.
std::vector<std::vector<std::uint32_t>> as_it_came(const SeenSubject& subject);

/// What the nodes count, drawn in one order: [draw][place] = atom.
std::vector<OverdrawCount> counts_of(const SeenSubject& subject, std::span<const std::vector<std::uint32_t>> atoms);

/// The sum over all nodes, each as heavy as it is.
ViewTally tally_of(const SeenSubject& subject, std::span<const OverdrawCount> counts);

}  // namespace foredraw
