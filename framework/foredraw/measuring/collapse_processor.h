#pragma once
// Simplifiers answer with a sequence of collapses; the framework runs it to see that it may, and keeps it as a product.

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/technique/plugin.h>

#include <functional>

namespace foredraw {

/// Draws that lie in one space, as one mesh.
struct MeshInScene {
  const JoinedMesh& mesh;
  const Scene& scene;
  std::span<const DrawId> draws;  ///< those that it was joined of
};

/// The sequence of collapses of a mesh, until no more than `least` triangles are left. Called for many meshes at once.
using Simplifier = std::function<CollapseSequence(const MeshInScene& of, std::size_t least, Run& run)>;

struct CollapseProcessorOptions {
  double until = 0.01;  ///< share of a mesh's triangles that simplifiers may stop at
};

/// The processor that a simplifier is: asks it for each mesh, and fails where what it answers does not run cleanly.
/// Draws that have levels, and meshes of few triangles, stay as they are.
std::unique_ptr<Processor> collapse_processor(Simplifier simplifier, CollapseProcessorOptions options = {});

/// What cards of simplifiers have in common: what they act on, make and measure; the name, summary and reference are
/// theirs.
Plugin simplifier_plugin(std::string name, std::string summary, std::string reference);

}  // namespace foredraw
