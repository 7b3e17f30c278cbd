#include "energy_collapse.h"

#include "energy_mesh.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace foredraw {

namespace {

using namespace processors::energy_collapse;

/// An edge, the lower point first, and what it came to when so much had happened to both points.
struct Entry {
  std::uint32_t p = 0, q = 0;
  std::uint32_t changes = 0;
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
      : options_(options), mesh_(positions, indices, scalars, options) {}

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
    if (const auto joined = mesh_.best(p, q)) queue_.push({p, q, changes(p, q), *joined});
  }

  /// Edges beside which something changed were entered anew then.
  void take_next() {
    const Entry entry = queue_.top();
    queue_.pop();
    if (entry.changes != changes(entry.p, entry.q) || !mesh_.has_edge(entry.p, entry.q)) return;
    mesh_.collapse(entry.joined);
    edges_.clear();
    const std::vector<std::uint32_t> around = mesh_.neighbours(entry.joined.kept);
    for (const std::uint32_t one : around) {
      for (const std::uint32_t other : mesh_.neighbours(one)) edges_.push_back(std::minmax(one, other));
    }
    std::ranges::sort(edges_);
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    for (const auto& [p, q] : edges_) enter(p, q);
  }

  EnergyCollapseOptions options_;
  EnergyMesh mesh_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::priority_queue<Entry, std::vector<Entry>, IsLater> queue_;
};

}  // namespace

CollapseSequence energy_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                 const VertexScalars& scalars, const EnergyCollapseOptions& options) {
  return Collapser(positions, indices, scalars, options).run();
}

}  // namespace foredraw
