#include "energy_collapse.h"

#include "energy_mesh.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace foredraw {

namespace {

using namespace energy;

/// An edge, the lower point first, and what it came to when so much had happened to both points.
struct Entry {
  std::uint32_t p = 0, q = 0;
  std::uint32_t moves = 0, changes = 0;
  Joined joined;
};

struct IsLater {
  bool operator()(const Entry& a, const Entry& b) const {
    return std::tie(a.joined.cost, a.p, a.q, a.changes) > std::tie(b.joined.cost, b.p, b.q, b.changes);
  }
};

class Collapser {
 public:
  Collapser(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, const VertexScalars& scalars,
            const EnergyCollapseOptions& options)
      : options_(options), mesh_(positions, indices, scalars, options), moves_(positions.size(), 0) {}

  CollapseSequence run() {
    for (std::size_t before = mesh_.triangle_count() + 1; is_wanted() && mesh_.triangle_count() < before;) {
      before = mesh_.triangle_count();
      for (std::uint32_t p = 0; p < mesh_.point_count(); ++p) {
        for (const std::uint32_t q : mesh_.neighbours(p)) {
          if (p < q && is_wanted()) enter(p, q);
        }
      }
      while (!queue_.empty() && is_wanted()) take_next();
    }
    return mesh_.take();
  }

 private:
  bool is_wanted() const {
    const bool is_cancelled = options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    return !is_cancelled && mesh_.triangle_count() > options_.least;
  }

  std::uint32_t changes(std::uint32_t p, std::uint32_t q) const { return mesh_.changes(p) + mesh_.changes(q); }

  void enter(std::uint32_t p, std::uint32_t q) {
    if (p > q) std::swap(p, q);
    if (const auto joined = mesh_.best(p, q)) queue_.push({p, q, moves_[p] + moves_[q], changes(p, q), *joined});
  }

  /// Edges whose point moved were entered anew then. Those with other changes beside them are looked at again now.
  void take_next() {
    const Entry entry = queue_.top();
    queue_.pop();
    if (entry.moves != moves_[entry.p] + moves_[entry.q] || !mesh_.has_edge(entry.p, entry.q)) return;
    if (entry.changes != changes(entry.p, entry.q)) return enter(entry.p, entry.q);
    mesh_.collapse(entry.joined);
    ++moves_[entry.p];
    ++moves_[entry.q];
    for (const std::uint32_t one : mesh_.neighbours(entry.joined.kept)) enter(one, entry.joined.kept);
  }

  EnergyCollapseOptions options_;
  EnergyMesh mesh_;
  std::vector<std::uint32_t> moves_;  // [point] how often it took another's place, or went
  std::priority_queue<Entry, std::vector<Entry>, IsLater> queue_;
};

}  // namespace

CollapseSequence energy_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                 const VertexScalars& scalars, const EnergyCollapseOptions& options) {
  return Collapser(positions, indices, scalars, options).run();
}

}  // namespace foredraw
