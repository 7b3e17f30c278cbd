#include "collapser.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::quadric_collapse {

namespace {

constexpr double refused = std::numeric_limits<double>::infinity();

/// How far the place lies from the one that is kept towards the one that goes.
float blend_of(glm::vec3 kept, glm::vec3 removed, glm::vec3 place) {
  const glm::dvec3 edge = glm::dvec3(removed) - glm::dvec3(kept), to = glm::dvec3(place) - glm::dvec3(kept);
  const double length = dot(edge, edge);
  return length > 0 ? static_cast<float>(std::clamp(dot(to, edge) / length, 0.0, 1.0)) : 0.0f;
}

}  // namespace

void Collapser::begin() {
  const std::uint32_t first = mesh_.first_point(piece_), end = mesh_.first_point(piece_ + 1);
  mesh_.find_rim(piece_);
  for (std::uint32_t p = first; p < end; ++p) {
    for (const std::uint32_t f : mesh_.ring(p)) {
      if (mesh_.face(f).point[0] != p) continue;  // each face once, by one piece
      all_.attributes.measure(f);
      all_.poses.measure(f);
    }
  }
  costs_.begin(first, end);
  points_ = end - first;
}

void Collapser::enter_edges() {
  const bool is_between = piece_ == between && mesh_.piece_count() > 1;
  const std::uint32_t first = piece_ == between ? 0 : mesh_.first_point(piece_);
  const std::uint32_t end = mesh_.first_point(piece_ == between ? mesh_.piece_count() : piece_ + 1);
  for (std::uint32_t p = first; p < end; ++p) {
    if (mesh_.point(p).is_gone || (is_between && mesh_.is_inside(p, p))) continue;
    neighbours_.clear();
    for (const Neighbour& one : editor_.neighbours(p, !is_between)) {
      if (p < one.point && (!is_between || mesh_.piece_of(one.point) != mesh_.piece_of(p))) neighbours_.push_back(one);
    }
    enter_neighbours(p);
  }
  costs_.end_of_first();
}

void Collapser::enter_parts() {
  for (std::uint32_t part = 0; part < all_.parts.count(); ++part) {
    const double cost = all_.parts.cost(part);
    queue_.push(CostQueue::rank_of(cost), {cost, {}, part, whole, 0, 0, false});
  }
}

void Collapser::run(std::size_t most_rank, std::size_t faces, std::size_t least) {
  faces_ = faces;
  while (faces_ > least && !is_cancelled()) {
    const auto edge = queue_.pop(most_rank);
    if (!edge) break;
    take_up(*edge, least);
  }
}

void Collapser::run_inside(std::size_t most_rank, std::size_t share) {
  const std::size_t least = points_ - std::max<std::size_t>(points_ / share, 1);
  while (points_ > least && !is_cancelled()) {
    const auto edge = queue_.pop(most_rank);
    if (!edge) break;
    take_up(*edge, 0);
  }
}

void Collapser::take_up(const EdgeEntry& edge, std::size_t least) {
  if (!is_current(edge)) return;
  if (edge.q == whole) {
    remove_part(edge.p, edge.cost, least);
  } else if (is_mine(edge.p, edge.q)) {
    consider(edge);
  } else {
    elsewhere_.push_back({queue_.lowest(), edge});
  }
}

void Collapser::join(Collapser& other) {
  piece_ /= 2;
  mesh_.find_rim(piece_);
  points_ += other.points_;
  take(other);
}

void Collapser::take(Collapser& other) {
  while (const auto edge = other.queue_.pop()) {
    if (is_current(*edge)) queue_.push(other.queue_.lowest(), *edge);
  }
}

void Collapser::remove_part(std::uint32_t part, double cost, std::size_t least) {
  if (all_.parts.is_all(part, faces_)) return;
  while (faces_ > least) {
    const auto step = all_.parts.next(part, joined_.pairs);
    if (!step) break;
    collapse(step->removed, step->kept, {cost, mesh_.point(step->kept).place});
  }
}

/// Edges of which a point has very many faces wait until there are fewer: each look at one is a look at all of them.
void Collapser::enter_neighbours(std::uint32_t p) {
  std::erase_if(neighbours_, [&](const Neighbour& one) {
    return mesh_.ring(p).size() + mesh_.ring(one.point).size() > EdgeCosts::most_faces;
  });
  found_.resize(neighbours_.size());
  costs_.least(p, neighbours_, found_);
  for (std::size_t i = 0; i < found_.size(); ++i) enter(p, neighbours_[i].point, found_[i], found_[i].cost, false);
}

void Collapser::enter(std::uint32_t p, std::uint32_t q, const EdgeCost& found, double cost, bool is_checked) {
  const std::size_t rank = CostQueue::rank_of(cost);
  const EdgeEntry entry{found.cost, found.place, p, q, moves(p, q), changes(p, q), is_checked};
  if (is_mine(p, q)) {
    queue_.push(rank, entry);
  } else {
    elsewhere_.push_back({rank, entry});
  }
}

void Collapser::consider(const EdgeEntry& edge) {
  const auto [p, q] = std::pair(edge.p, edge.q);
  const bool has_changed = changes(p, q) != edge.changes;
  const EdgeCost best = has_changed ? costs_.least(p, q) : EdgeCost{edge.cost, edge.place};
  if (has_changed && CostQueue::rank_of(best.cost) > queue_.lowest()) return enter(p, q, best, best.cost, false);
  if (!legal_.keeps_topology(p, q)) return;
  if ((has_changed || !edge.is_checked) && is_too_far(p, q, best, 0)) return;
  const bool stays_at_q = best.place == mesh_.point(q).place;
  std::uint32_t kept = stays_at_q ? q : p, removed = stays_at_q ? p : q;
  double jumps = pair_up(removed, kept, best.place, joined_);
  if (jumps > 0 && all_.options.placement == CollapsePlacement::optimal) {
    if (const double other = pair_up(kept, removed, best.place, turned_); other < jumps) {
      jumps = other;
      std::swap(kept, removed);
      std::swap(joined_, turned_);
    }
  }
  if (jumps == refused || !legal_.keeps_sides(p, q, best.place)) return;
  if (jumps > 0 && is_too_far(p, q, best, jumps)) return;
  collapse(removed, kept, best);
}

/// What the edge's cost lacks if vertices jump, or `refused`.
double Collapser::pair_up(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, JoinedVertices& joined) {
  if (!legal_.pair_vertices(removed, kept, joined)) return refused;
  const float blend = blend_of(mesh_.point(kept).place, mesh_.point(removed).place, place);
  return all_.attributes.jumps(removed, kept, place, blend, joined);
}

/// A quadric does not see where faces end: at a crease the least place may lie far from all of them. Where an edge
/// moves the surface farther than its cost says, or vertices jump, it waits until that is the cost.
bool Collapser::is_too_far(std::uint32_t p, std::uint32_t q, const EdgeCost& best, double jumps) {
  constexpr std::size_t slack = 6;  // ranks; to be stricter gains nothing
  const double weight = all_.options.deviation * area_around(p, q);
  const double moved = weight > 0 ? weight * distance_.squared(mesh_, p, q, best.place) : 0;
  const double cost = best.cost + moved + jumps;
  if (!(cost > best.cost) || CostQueue::rank_of(cost) <= queue_.lowest() + slack) return false;
  enter(p, q, best, cost, true);
  return true;
}

double Collapser::area_around(std::uint32_t p, std::uint32_t q) const {
  double area = 0;
  for (const std::uint32_t one : {p, q}) {
    for (const std::uint32_t f : mesh_.ring(one)) area += mesh_.plane(f).area();
  }
  return area;
}

void Collapser::collapse(std::uint32_t removed, std::uint32_t kept, const EdgeCost& best) {
  const double area = area_around(removed, kept);
  constexpr double most = std::numeric_limits<float>::max();
  const bool is_distance = all_.attributes.empty() && all_.poses.empty();
  const double cost = is_distance ? best.cost : costs_.distances(removed, kept, best.place);
  const double error = area > 0 ? std::min(std::sqrt(std::max(cost, 0.0) / area), most) : 0;
  const float blend = blend_of(mesh_.point(kept).place, mesh_.point(removed).place, best.place);
  const Quadric memory = costs_.joined_memory(removed, kept, best.place);
  all_.poses.join(removed, kept, blend, best.place);
  all_.attributes.join(removed, kept, best.place, blend, joined_.pairs, joining_);
  Point& point = mesh_.point(kept);
  point.is_sharp = point.is_sharp || mesh_.point(removed).is_sharp;
  point.is_seam = point.is_seam || mesh_.point(removed).is_seam;
  const std::size_t gone = editor_.collapse(removed, kept, best.place, [&](std::uint32_t vertex) {
    return std::ranges::find(joined_.pairs, vertex, &VertexPair::removed)->kept;
  });
  faces_ -= gone;
  --points_;
  point.memory = memory;
  for (const std::uint32_t f : mesh_.ring(kept)) {
    all_.attributes.measure(f);
    all_.poses.measure(f);
  }
  steps_.pairs.insert(steps_.pairs.end(), joined_.pairs.begin(), joined_.pairs.end());
  const auto rank = static_cast<std::uint32_t>(queue_.lowest());
  steps_.steps.push_back({
      .collapse = {mesh_.name_of(removed), mesh_.name_of(kept), blend, static_cast<float>(error)},
      .place = best.place,
      .rank = steps_.steps.empty() ? rank : std::max(rank, steps_.steps.back().rank),
      .faces = static_cast<std::uint32_t>(gone),
      .end = static_cast<std::uint32_t>(steps_.pairs.size()),
  });
  const std::span<const Neighbour> around = editor_.neighbours(kept);
  neighbours_.assign(around.begin(), around.end());
  enter_neighbours(kept);
}

}  // namespace foredraw::processors::quadric_collapse
