#pragma once
// What tests of simplifiers ask of a mesh and of the sequence that was found for it.

#include "support/meshes.h"

#include <foredraw/collapses/replay.h>

#include <map>

namespace foredraw::testing {

/// The mesh where the sequence has come down to so many triangles, or has ended. The test fails if it does not run
/// cleanly.
TestMesh coarse(const TestMesh& mesh, const CollapseSequence& sequence, std::size_t triangles);

/// How far the surfaces come apart, proved.
double distance(const TestMesh& a, const TestMesh& b);

/// Edges between places, by how many triangles have them.
std::map<int, int> edges(const TestMesh& mesh);
/// Points less edges plus triangles, by place.
int euler(const TestMesh& mesh);

TestMesh moved(TestMesh mesh, glm::vec3 by);
TestMesh closed_torus(std::uint32_t slices, std::uint32_t sides);  ///< whose ends share vertices
TestMesh flat_ring(std::uint32_t around, std::uint32_t across);    ///< from radius 1 to 2
TestMesh moebius_strip(std::uint32_t around);
TestMesh box_of_sides(std::uint32_t cells);  ///< six flat sides, each with vertices of its own

/// Nothing, single triangles, the same ones again, lines, fans around one edge, soups, points that are not finite,
/// sizes at the ends of what floats hold, surfaces that only touch, and a Moebius strip.
std::vector<TestMesh> odd_meshes();

}  // namespace foredraw::testing
