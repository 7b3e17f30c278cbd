#pragma once
// The product that simplifiers make: how the draws of each mesh become coarser.

#include <foredraw/collapses/collapse_sequence.h>
#include <foredraw/scene/scene.h>

#include <memory>
#include <span>
#include <string_view>

namespace foredraw {

/// Of draws that lie in one space and become coarser in step. Vertices are numbered through: those of the first draw's
/// VertexStreams, then those of the next draw that has others, as joined_mesh() has them.
struct DrawsCollapse {
  std::vector<DrawId> draws;
  std::shared_ptr<const CollapseSequence> sequence;

  friend bool operator==(const DrawsCollapse& a, const DrawsCollapse& b) {
    return a.draws == b.draws && (a.sequence == b.sequence || *a.sequence == *b.sequence);
  }
};

struct CollapseSequences {
  static constexpr std::string_view product = "collapse-sequences";
  std::vector<DrawsCollapse> meshes;  ///< a draw is in one of them at most
  friend bool operator==(const CollapseSequences&, const CollapseSequences&) = default;
};

/// The scene's sequences of draws that are all among these, which rise.
std::vector<DrawsCollapse> sequences_of(const Scene& scene, std::span<const DrawId> draws);

/// Takes these out of the scene: they are used up.
void remove_sequences(Scene& scene, std::span<const DrawsCollapse> used_up);

}  // namespace foredraw
