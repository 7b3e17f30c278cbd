#pragma once
#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/mesh_facts.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/scene.h>

#include <vector>

namespace foredraw {

/// [draw] what is unusual about its full detail; nothing where it does not draw triangles. Draws may share vertices:
/// these are counted with the first of them, and count as unreferenced where none of the indices of any draw, level or
/// order names them.
std::vector<MeshFacts> facts_of_draws(const Scene& scene, Analyses& analyses, const Executor& executor);

/// How many vertices the draws have in full detail; those that several draws share once.
std::size_t count_vertices(const Scene& scene);

}  // namespace foredraw
