#pragma once
// What tests of simplifiers ask of a mesh and of the sequence that was found for it.

#include "support/meshes.h"

#include <foredraw/collapses/replay.h>

#include <functional>
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
TestMesh spokes(std::uint32_t around);                             ///< a cone whose triangles all have vertex 0
TestMesh moebius_strip(std::uint32_t around);
TestMesh box_of_sides(std::uint32_t cells);  ///< six flat sides, each with vertices of its own

/// Nothing, single triangles, the same ones again, lines, fans around one edge or without area, soups, points that are
/// not finite, sizes and places at the ends of what floats hold, surfaces that only touch or nearly touch, vertices
/// that no triangle uses, and a Moebius strip.
std::vector<TestMesh> odd_meshes();

/// What a simplifier makes of a mesh, until no more than so many triangles are left.
using Simplify = std::function<CollapseSequence(const TestMesh& mesh, std::size_t least)>;

/// A torus stays a torus, both rims of a ring stay, and a plate stays one.
void expect_topology_stays(const Simplify& simplify);
/// The seams of a box stay closed, and no triangle takes a vertex of another side.
void expect_seams_stay(const Simplify& simplify);
/// What it answers for odd_meshes() runs cleanly.
void expect_odd_meshes_run(const Simplify& simplify);
void expect_it_stops(const Simplify& simplify);

}  // namespace foredraw::testing
