#include "enclosing_polygon.h"

#include "hop_table.h"
#include "plane.h"
#include "reduced_hull.h"

#include <algorithm>

namespace foredraw::processors::particle_trim {

namespace {

Enclosing whole(std::span<const Point> hull, const Pockets& pockets) {
  Enclosing polygon{{}, pockets.hull_area()};
  for (const Point& point : hull) polygon.corners.emplace_back(point.x, point.y);
  return polygon;
}

/// What the pockets of some polygon cost: one that comes close to the best.
double bound_of(const Pockets& pockets, std::size_t corners) {
  const std::vector<std::size_t> edges = reduced_hull(pockets, corners);
  if (edges.size() > corners) return infinity;
  double cost = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) cost += pockets.between(edges[k], edges[(k + 1) % edges.size()]);
  return cost * (1 + 1e-9);
}

/// Costs of single hops up to `most`: all pockets between two edges that lie on the hull.
std::vector<std::vector<double>> hops(const Pockets& pockets, double most) {
  std::vector<std::vector<double>> costs(pockets.edges());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    costs[i].push_back(infinity);
    for (std::size_t steps = 1; steps < costs.size(); ++steps) {
      const double area = pockets.area(i, steps);
      if (area == infinity || !(area <= most)) break;
      costs[i].push_back(pockets.is_allowed(i, steps) ? area : infinity);
    }
  }
  return costs;
}

/// `power` hops, by doubling.
std::shared_ptr<const HopTable> power_of(std::shared_ptr<const HopTable> base, int power, double most) {
  std::shared_ptr<const HopTable> result;
  for (; power > 0; power /= 2) {
    if (power % 2 == 1) result = result ? HopTable::joined(result, base, most) : base;
    if (power > 1) base = HopTable::joined(base, base, most);
  }
  return result;
}

/// A way round the hull: n - 2 hops from `start` and one of two that closes it, over an edge on the hull or a free one.
struct Way {
  double cost = infinity;
  std::size_t start = 0;
  std::size_t steps = 0;  ///< of the n - 2 hops
  std::optional<Pockets::Free> free;
};

}  // namespace

std::optional<Enclosing> smallest_enclosing(std::span<const Point> hull, int n, const Allowed& allowed,
                                            double most_area) {
  const Pockets pockets(hull, allowed);
  const std::size_t edges = hull.size();
  if (edges <= static_cast<std::size_t>(n)) return whole(hull, pockets);

  const double bound = std::min(bound_of(pockets, static_cast<std::size_t>(n)), most_area - pockets.hull_area());
  const auto single = HopTable::single(hops(pockets, bound));
  const auto pair = HopTable::joined(single, single, bound);
  const auto most_hops = power_of(single, n - 2, bound);
  Way best;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::vector<double>& costs = most_hops->from(i);
    for (std::size_t steps = 1; steps < std::min(costs.size(), edges); ++steps) {
      const double cost = costs[steps] + pair->cost(i + steps, edges - steps);
      if (cost < best.cost) best = {cost, i, steps, std::nullopt};
    }
  }
  double most = std::min(bound, best.cost);
  for (std::size_t last = 0; last < edges; ++last) {
    for (std::size_t back = 2; back < edges; ++back) {
      const std::size_t start = (last + back) % edges;
      const auto free = pockets.free(last, back);
      if (!free) continue;
      if (free->area >= most) break;  // it grows with the steps
      const double cost = most_hops->cost(start, edges - back) + free->area;
      if (cost >= most || !pockets.is_allowed(last, back, *free)) continue;
      best = {cost, start, edges - back, free};
      most = cost;
    }
  }
  if (best.cost == infinity || best.cost > bound) return std::nullopt;

  std::vector<std::size_t> steps;
  most_hops->trace(best.start, best.steps, steps);
  if (!best.free) pair->trace(best.start + best.steps, edges - best.steps, steps);
  Enclosing polygon{{}, pockets.hull_area() + best.cost};
  std::size_t edge = best.start;
  for (const std::size_t step : steps) {
    polygon.corners.push_back(pockets.corner(edge % edges, step));
    edge += step;
  }
  if (best.free) polygon.corners.insert(polygon.corners.end(), {best.free->from, best.free->to});
  return polygon;
}

namespace {

/// Tries all sets of n edges out of some.
class Sets {
 public:
  Sets(const Pockets& pockets, std::vector<std::size_t> edges, std::size_t n)
      : pockets_(pockets), edges_(std::move(edges)), n_(n), costs_(edges_.size() * edges_.size()) {
    for (std::size_t a = 0; a < edges_.size(); ++a) {
      for (std::size_t b = 0; b < edges_.size(); ++b) {
        if (a != b) costs_[a * edges_.size() + b] = pockets.between(edges_[a], edges_[b]);
      }
    }
  }

  std::optional<Enclosing> best() {
    for (std::size_t first = 0; first + n_ <= edges_.size(); ++first) {
      set_ = {first};
      go_on(0);
    }
    if (best_cost_ == infinity) return std::nullopt;
    Enclosing polygon{{}, pockets_.hull_area() + best_cost_};
    for (std::size_t k = 0; k < n_; ++k) {
      const std::size_t from = edges_[best_[k]], to = edges_[best_[(k + 1) % n_]];
      polygon.corners.push_back(pockets_.corner(from, pockets_.steps(from, to)));
    }
    return polygon;
  }

 private:
  double cost(std::size_t a, std::size_t b) const { return costs_[a * edges_.size() + b]; }

  void go_on(double so_far) {
    if (set_.size() == n_) {
      const double all = so_far + cost(set_.back(), set_.front());
      if (all < best_cost_) {
        best_cost_ = all;
        best_ = set_;
      }
      return;
    }
    const std::size_t last = set_.back();
    for (std::size_t next = last + 1; next + (n_ - set_.size()) <= edges_.size(); ++next) {
      const double with = so_far + cost(last, next);
      if (with == infinity) continue;
      set_.push_back(next);
      go_on(with);
      set_.pop_back();
    }
  }

  const Pockets& pockets_;
  std::vector<std::size_t> edges_;
  std::size_t n_;
  std::vector<double> costs_;
  std::vector<std::size_t> set_, best_;
  double best_cost_ = infinity;
};

}  // namespace

std::optional<Enclosing> reduced_enclosing(std::span<const Point> hull, int n, int most_edges, const Allowed& allowed) {
  const Pockets pockets(hull, allowed);
  const auto corners = static_cast<std::size_t>(n);
  if (hull.size() <= corners) return whole(hull, pockets);
  std::vector<std::size_t> edges =
      reduced_hull(Pockets(hull, {}), std::max(corners, static_cast<std::size_t>(most_edges)));
  return Sets(pockets, std::move(edges), corners).best();
}

}  // namespace foredraw::processors::particle_trim
