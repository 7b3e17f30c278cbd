#include "quadric_collapse.h"

#include "cost_queue.h"
#include "edge_cost.h"
#include "legal_collapse.h"
#include "local_distance.h"
#include "whole_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace foredraw {

namespace {

using namespace collapsing;

/// How far the place lies from the one that is kept towards the one that goes.
float blend_of(glm::vec3 kept, glm::vec3 removed, glm::vec3 place) {
  const glm::dvec3 edge = glm::dvec3(removed) - glm::dvec3(kept), to = glm::dvec3(place) - glm::dvec3(kept);
  const double length = dot(edge, edge);
  return length > 0 ? static_cast<float>(std::clamp(dot(to, edge) / length, 0.0, 1.0)) : 0.0f;
}

class Collapser {
 public:
  Collapser(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
            const QuadricCollapseOptions& options, AttributeRows attributes, std::span<const std::uint32_t> stream)
      : options_(options),
        mesh_(positions, indices),
        attributes_(mesh_, std::move(attributes)),
        costs_(mesh_, {options.memory, options.border, options.seam}, attributes_),
        legal_(mesh_),
        parts_(mesh_, options.parts, stream) {}

  CollapseSequence run() {
    costs_.begin();
    enter_parts();
    for (std::size_t before = ~std::size_t{0}; mesh_.face_count() > options_.least && mesh_.face_count() < before;) {
      before = mesh_.face_count();
      enter_all();
      while (mesh_.face_count() > options_.least && !is_cancelled()) {
        const auto edge = queue_.pop();
        if (!edge) break;
        if (edge->q == whole) {
          remove_part(edge->p, edge->cost);
        } else if (moves(edge->p, edge->q) == edge->moves) {
          consider(*edge);
        }
      }
    }
    sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
    return std::move(sequence_);
  }

 private:
  bool is_cancelled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }

  /// A part is entered as if it were an edge to nowhere.
  void enter_parts() {
    for (std::uint32_t part = 0; part < parts_.count(); ++part) {
      const double cost = parts_.cost(part);
      queue_.push(cost, {cost, {}, part, whole, 0, 0, false});
    }
  }

  void remove_part(std::uint32_t part, double cost) {
    if (parts_.is_all(part)) return;
    while (mesh_.face_count() > options_.least) {
      const auto step = parts_.next(part, pairs_);
      if (!step) break;
      collapse(step->removed, step->kept, {cost, mesh_.point(step->kept).place});
    }
  }

  void enter_all() {
    for (std::uint32_t p = 0; p < mesh_.points().size(); ++p) {
      if (mesh_.point(p).is_gone) continue;
      const std::span<const Neighbour> around = mesh_.neighbours(p);
      neighbours_.clear();
      std::ranges::copy_if(around, std::back_inserter(neighbours_),
                           [&](const Neighbour& one) { return p < one.point; });
      enter_neighbours(p);
    }
    costs_.end_of_first();
  }

  EdgeCost cost_of(std::uint32_t p, std::uint32_t q) {
    if (options_.placement == CollapsePlacement::optimal) return costs_.optimal(p, q);
    const double at_p = costs_.at(p, q), at_q = costs_.at(q, p);
    return at_p <= at_q ? EdgeCost{at_p, mesh_.point(p).place} : EdgeCost{at_q, mesh_.point(q).place};
  }

  /// Edges of which a point has very many faces wait until there are fewer: each look at one is a look at all of them.
  void enter_neighbours(std::uint32_t p) {
    std::erase_if(neighbours_, [&](const Neighbour& one) {
      return mesh_.ring(p).size() + mesh_.ring(one.point).size() > EdgeCosts::most_faces;
    });
    found_.resize(neighbours_.size());
    if (options_.placement == CollapsePlacement::optimal) {
      costs_.optimal(p, neighbours_, found_);
    } else {
      for (std::size_t i = 0; i < found_.size(); ++i) found_[i] = cost_of(p, neighbours_[i].point);
    }
    for (std::size_t i = 0; i < found_.size(); ++i) enter(p, neighbours_[i].point, found_[i]);
  }
  void enter(std::uint32_t p, std::uint32_t q, const EdgeCost& found) { enter(p, q, found, found.cost, false); }
  void enter(std::uint32_t p, std::uint32_t q, const EdgeCost& found, double cost, bool is_checked) {
    queue_.push(cost, {found.cost, found.place, p, q, moves(p, q), changes(p, q), is_checked});
  }

  std::uint32_t moves(std::uint32_t p, std::uint32_t q) const {
    return mesh_.changes(p).moves + mesh_.changes(q).moves;
  }
  std::uint32_t changes(std::uint32_t p, std::uint32_t q) const {
    return (mesh_.changes(p).faces + mesh_.changes(q).faces) & (~std::uint32_t{0} >> 1);
  }

  void consider(const EdgeEntry& edge) {
    const auto [p, q] = std::pair(edge.p, edge.q);
    const bool has_changed = changes(p, q) != edge.changes;
    const EdgeCost best = has_changed ? cost_of(p, q) : EdgeCost{edge.cost, edge.place};
    if (has_changed && CostQueue::rank_of(best.cost) > queue_.lowest()) return enter(p, q, best);
    if (!legal_.keeps_topology(p, q)) return;
    if ((has_changed || !edge.is_checked) && is_too_far(p, q, best)) return;
    const bool stays_at_q = best.place == mesh_.point(q).place;
    const std::uint32_t first = stays_at_q ? q : p, second = stays_at_q ? p : q;
    const bool may_turn = options_.placement == CollapsePlacement::optimal;
    const bool is_first_kept = legal_.pair_vertices(second, first, pairs_);
    if (!is_first_kept && !(may_turn && legal_.pair_vertices(first, second, pairs_))) return;
    if (!legal_.keeps_sides(p, q, best.place)) return;
    collapse(is_first_kept ? second : first, is_first_kept ? first : second, best);
  }

  /// A quadric does not see where faces end: at a crease the least place may lie far from all of them. Where an edge
  /// moves the surface farther than its cost says, it waits until that is the cost.
  bool is_too_far(std::uint32_t p, std::uint32_t q, const EdgeCost& best) {
    constexpr std::size_t slack = 6;  // ranks; to be stricter gains nothing
    const double weight = options_.deviation * area_around(p, q);
    if (!(weight > 0)) return false;
    const double cost = best.cost + weight * distance_.squared(mesh_, p, q, best.place);
    if (CostQueue::rank_of(cost) <= queue_.lowest() + slack) return false;
    enter(p, q, best, cost, true);
    return true;
  }

  double area_around(std::uint32_t p, std::uint32_t q) const {
    double area = 0;
    for (const std::uint32_t one : {p, q}) {
      for (const std::uint32_t f : mesh_.ring(one)) area += mesh_.plane(f).area();
    }
    return area;
  }

  void collapse(std::uint32_t removed, std::uint32_t kept, const EdgeCost& best) {
    const double area = area_around(removed, kept);
    constexpr double most = std::numeric_limits<float>::max();
    const double cost = attributes_.empty() ? best.cost : costs_.distances(removed, kept, best.place);
    if (area > 0) error_ = std::min(std::max(error_, std::sqrt(std::max(cost, 0.0) / area)), most);
    const float blend = blend_of(mesh_.point(kept).place, mesh_.point(removed).place, best.place);
    const Quadric memory = costs_.joined_memory(removed, kept, best.place);
    Point& point = mesh_.point(kept);
    point.is_sharp = point.is_sharp || mesh_.point(removed).is_sharp;
    mesh_.collapse(removed, kept, best.place,
                   [&](std::uint32_t vertex) { return std::ranges::find(pairs_, vertex, &VertexPair::removed)->kept; });
    point.memory = memory;
    attributes_.blend(pairs_, blend);
    sequence_.collapses.push_back({mesh_.name_of(removed), mesh_.name_of(kept), blend, static_cast<float>(error_)});
    sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
    sequence_.pairs.insert(sequence_.pairs.end(), pairs_.begin(), pairs_.end());
    for (int k = 0; k < 3; ++k) sequence_.places.push_back(best.place[k]);
    const std::span<const Neighbour> around = mesh_.neighbours(kept);
    neighbours_.assign(around.begin(), around.end());
    enter_neighbours(kept);
  }

  static constexpr std::uint32_t whole = ~std::uint32_t{0};

  QuadricCollapseOptions options_;
  CollapsingMesh mesh_;
  AttributeCosts attributes_;
  EdgeCosts costs_;
  LegalCollapses legal_;
  WholeParts parts_;
  LocalDistance distance_;
  CostQueue queue_;
  std::vector<VertexPair> pairs_;
  std::vector<Neighbour> neighbours_;
  std::vector<EdgeCost> found_;
  CollapseSequence sequence_;
  double error_ = 0;
};

}  // namespace

CollapseSequence quadric_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                  const QuadricCollapseOptions& options, AttributeRows attributes,
                                  std::span<const std::uint32_t> stream) {
  return Collapser(positions, indices, options, std::move(attributes), stream).run();
}

}  // namespace foredraw
