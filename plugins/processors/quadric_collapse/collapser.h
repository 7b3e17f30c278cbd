#pragma once
// Collapses the edges of one piece of a mesh, the cheapest first; or those that no piece has for itself.

#include "cost_queue.h"
#include "edge_cost.h"
#include "legal_collapse.h"
#include "local_distance.h"
#include "quadric_collapse.h"
#include "whole_parts.h"

#include <limits>

namespace foredraw::processors::quadric_collapse {

/// What collapsers work on together.
struct Collapsing {
  const QuadricCollapseOptions& options;
  CollapsingMesh& mesh;
  AttributeCosts& attributes;
  PosedPlanes& poses;
  WholeParts& parts;
};

/// Collapses, in their sequence.
struct Steps {
  struct Step {
    Collapse collapse;
    glm::vec3 place{0};
    std::uint32_t rank = 0;   ///< of the costs so far the highest
    std::uint32_t faces = 0;  ///< that went
    std::uint32_t end = 0;    ///< of its pairs
  };
  std::vector<Step> steps;
  std::vector<VertexPair> pairs;

  void clear() { steps.clear(), pairs.clear(); }
};

class Collapser {
 public:
  static constexpr std::size_t between = ~std::size_t{0};

  /// Of that piece, or of all edges that lie in none, `between` them. `number`: of this one among so many.
  Collapser(const Collapsing& all, std::size_t piece, std::size_t number, std::size_t count)
      : all_(all),
        mesh_(all.mesh),
        piece_(piece),
        editor_(mesh_, number, count),
        costs_(mesh_,
               {all.options.memory, all.options.border, all.options.seam,
                all.options.placement == CollapsePlacement::endpoint},
               all.attributes, all.poses),
        legal_(mesh_, editor_, all_.attributes) {}

  /// Prepares the points of the piece.
  void begin();
  /// Enters edges: of the piece; or those between pieces.
  void enter_edges();
  /// Whole parts may go at a cost.
  void enter_parts();
  /// Collapses while costs have at most that rank, until of `faces` no more than `least` are left.
  void run(std::size_t most_rank, std::size_t faces, std::size_t least);
  /// The same inside the piece, until one of `share` points has gone.
  void run_inside(std::size_t most_rank, std::size_t share);
  /// Goes on with the edges of both, in a piece that is both.
  void join(Collapser& other);
  /// Goes on with the other one's edges.
  void take(Collapser& other);

  /// What run() did since this was cleared.
  Steps& steps() { return steps_; }
  CostQueue& queue() { return queue_; }
  const CostQueue& queue() const { return queue_; }

  /// Edges that came up here and belong elsewhere.
  struct Elsewhere {
    std::size_t rank;
    EdgeEntry entry;
  };
  std::vector<Elsewhere>& elsewhere() { return elsewhere_; }

 private:
  static constexpr std::uint32_t whole = ~std::uint32_t{0};

  /// Not if one of its points moved since.
  bool is_current(const EdgeEntry& edge) const { return edge.q == whole || moves(edge.p, edge.q) == edge.moves; }
  bool is_mine(std::uint32_t p, std::uint32_t q) const { return mesh_.is_inside(p, q) == (piece_ != between); }
  bool is_cancelled() const {
    return all_.options.cancel != nullptr && all_.options.cancel->load(std::memory_order_relaxed);
  }
  std::uint32_t moves(std::uint32_t p, std::uint32_t q) const {
    return mesh_.changes(p).moves + mesh_.changes(q).moves;
  }
  std::uint32_t changes(std::uint32_t p, std::uint32_t q) const {
    return (mesh_.changes(p).faces + mesh_.changes(q).faces) & (~std::uint32_t{0} >> 1);
  }

  void enter_neighbours(std::uint32_t p);
  void enter(std::uint32_t p, std::uint32_t q, const EdgeCost& found, double cost, bool is_checked);
  void take_up(const EdgeEntry& edge, std::size_t least);
  void remove_part(std::uint32_t part, double cost, std::size_t least);
  void consider(const EdgeEntry& edge);
  bool is_too_far(std::uint32_t p, std::uint32_t q, const EdgeCost& best, double jumps);
  double pair_up(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, JoinedVertices& joined);
  double area_around(std::uint32_t p, std::uint32_t q) const;
  void collapse(std::uint32_t removed, std::uint32_t kept, const EdgeCost& best);

  Collapsing all_;
  CollapsingMesh& mesh_;
  std::size_t piece_;
  MeshEditor editor_;
  EdgeCosts costs_;
  LegalCollapses legal_;
  LocalDistance distance_;
  CostQueue queue_;
  std::vector<Elsewhere> elsewhere_;
  JoinedVertices joined_, turned_;
  AttributeCosts::Room joining_;
  std::vector<Neighbour> neighbours_;
  std::vector<EdgeCost> found_;
  Steps steps_;
  std::size_t points_ = 0, faces_ = 0;  // that are left
};

}  // namespace foredraw::processors::quadric_collapse
