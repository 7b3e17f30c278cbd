#pragma once
// The DotRule: clusters that face outwards are drawn first, for they hide others and are hidden by few.
// Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007, "The
// DotRule".

#include <foredraw/scene/clusters.h>
#include <foredraw/scene/strided.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The sequence of the clusters ([new] = old) by falling (centroid of the cluster - centroid of the mesh) . (unit
/// normal of the cluster), all weighted by area. Those that are equal to 1/1024 of the largest value keep their
/// sequence, and so what they share in the vertex cache. Triangles with positions that are not finite are left out of
/// the sums; a cluster without area goes last. O(triangles + clusters log clusters).
std::vector<std::uint32_t> dot_rule(Strided<glm::vec3> positions, std::span<const std::uint32_t> indices,
                                    const Clusters& clusters);

struct Plugin;
Plugin dot_rule_plugin();

}  // namespace foredraw
