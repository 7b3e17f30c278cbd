#include <foredraw/analysis/farthest_distance.h>

#include <foredraw/analysis/convex_piece.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace foredraw {

namespace {

constexpr double precision_of_floats = 0x1p-23;

/// A piece that lies within the bound of the surface.
struct BoundPiece {
  ConvexPiece shape;
  double bound = 0;
  std::uint32_t by = no_triangle;  ///< the triangle that proves it
};

/// What a task found out. Tasks of a round know what the rounds before found, and nothing of each other.
struct FarthestShare {
  Farthest result;
  std::uint64_t most_questions = 0;

  void find(double distance, const glm::dvec3& at) {
    if (distance <= result.found) return;
    result.found = distance;
    result.at = at;
  }
};

class FarthestSearch {
 public:
  FarthestSearch(const Surface& of, const ClosestPoints& to, const FarthestOptions& options, const Executor& executor)
      : of_(of), to_(to), options_(options), executor_(executor), nearest_(of.positions.size()) {
    for (std::size_t i = 0; i + 3 <= of.indices.size(); i += 3) {
      const TriangleCorners corners = corners_at(i);
      bool is_finite = true;
      for (const glm::dvec3& p : corners) {
        const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        is_finite = is_finite && std::isfinite(p.x + p.y + p.z);
        if (std::isfinite(most)) extent_ = std::max(extent_, most);
      }
      if (is_finite) starts_.push_back(static_cast<std::uint32_t>(i));
    }
    extent_ = std::max(extent_, to.extent());
  }

  bool empty() const { return starts_.empty(); }
  /// What is known to be so far need not be found again.
  void start_from(const Farthest& known) {
    whole_.found = known.found;
    whole_.at = known.at;
    whole_.questions = known.questions;
  }
  /// Nothing but whether it is farther than that is asked.
  void ask_for(double distance) { asked_ = distance; }

  Farthest run() {
    if (starts_.empty()) return whole_;
    ask_for_vertices();
    if (!is_answered()) prove(bound_all());
    whole_.bound = std::max(whole_.bound, whole_.found);
    whole_.is_within_tolerance = whole_.bound <= limit(whole_.found);
    return whole_;
  }

  double slack() const { return extent_ * precision_of_floats; }

 private:
  TriangleCorners corners_at(std::size_t start) const {
    TriangleCorners corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = glm::dvec3(of_.positions[of_.indices[start + c]]);
    return corners;
  }

  /// What a piece needs to be within to be of no more interest.
  double limit(double found) const { return (asked_ ? *asked_ : found * (1 + options_.tolerance)) + slack(); }
  bool is_answered() const { return asked_ && whole_.found > *asked_ + slack(); }

  /// Calls task(i, share) for each i below `count`, in rounds that grow, so that all but the first tasks know of a
  /// large distance. Ends early where the answer is known; then a bound that is not proved stands for the rest.
  template <class Task>
  void in_rounds(std::size_t count, std::size_t first_round, std::uint64_t most_questions, Task task) {
    const std::uint64_t asked_before = whole_.questions;
    for (std::size_t begin = 0, round = first_round; begin < count && !is_answered(); begin += round, round *= 2) {
      const std::size_t tasks = std::min(round, count - begin);
      const std::uint64_t left = most_questions - std::min(most_questions, whole_.questions - asked_before);
      std::vector<FarthestShare> shares(tasks);
      for (FarthestShare& share : shares) {
        share.result.found = whole_.found;
        share.result.at = whole_.at;
        share.most_questions = left / (2 * tasks);
      }
      executor_.for_each(tasks, [&](std::size_t i) { task(begin + i, shares[i]); });
      for (const FarthestShare& share : shares) {
        if (share.result.found > whole_.found) {
          whole_.found = share.result.found;
          whole_.at = share.result.at;
        }
        whole_.bound = std::max(whole_.bound, share.result.bound);
        whole_.questions += share.result.questions;
      }
    }
  }

  /// In the sequence in which triangles use them, so that each is near the one before.
  void ask_for_vertices() {
    constexpr std::size_t at_a_time = 512;
    std::vector<std::uint32_t> used;
    std::vector<bool> is_used(of_.positions.size(), false);
    for (const std::uint32_t start : starts_) {
      for (const std::uint32_t v : of_.indices.subspan(start, 3)) {
        if (!is_used[v]) used.push_back(v);
        is_used[v] = true;
      }
    }
    const std::size_t tasks = (used.size() + at_a_time - 1) / at_a_time;
    in_rounds(tasks, asked_ ? 4 : tasks, 0, [&](std::size_t task, FarthestShare& share) {
      std::uint32_t hint = no_triangle;
      const std::size_t end = std::min(used.size(), (task + 1) * at_a_time);
      for (std::size_t i = task * at_a_time; i < end; ++i) {
        const glm::dvec3 point(of_.positions[used[i]]);
        const Closest closest = to_.nearest(point, hint);
        hint = nearest_[used[i]] = closest.triangle;
        share.find(closest.distance, point);
      }
      share.result.questions += end - task * at_a_time;
    });
  }

  /// The largest distance of the piece's corners from that triangle: no point of the piece is farther.
  double bound_by(std::uint32_t triangle, const ConvexPiece& piece) const {
    const TriangleCorners corners = to_.corners(triangle);
    double most = 0;
    for (const glm::dvec3& corner : piece.corners()) most = std::max(most, squared_distance(corners, corner));
    return std::sqrt(most);
  }

  void tighten(BoundPiece& piece, std::uint32_t by) const {
    if (by == piece.by) return;
    const double bound = bound_by(by, piece.shape);
    if (bound >= piece.bound) return;
    piece.bound = bound;
    piece.by = by;
  }

  BoundPiece whole_triangle(std::uint32_t start) const {
    BoundPiece piece{ConvexPiece(corners_at(start)), std::numeric_limits<double>::infinity()};
    for (const std::uint32_t v : of_.indices.subspan(start, 3)) tighten(piece, nearest_[v]);
    return piece;
  }

  /// Those whose vertices' nearest triangles do not prove enough, the farthest first.
  std::vector<std::uint32_t> bound_all() {
    constexpr std::size_t at_a_time = 1024;
    std::vector<double> bounds(starts_.size());
    executor_.for_each((starts_.size() + at_a_time - 1) / at_a_time, [&](std::size_t part) {
      const std::size_t end = std::min(starts_.size(), (part + 1) * at_a_time);
      for (std::size_t i = part * at_a_time; i < end; ++i) bounds[i] = whole_triangle(starts_[i]).bound;
    });
    std::vector<std::uint32_t> open;
    const double enough = limit(whole_.found);
    for (std::uint32_t i = 0; i < starts_.size(); ++i) {
      if (bounds[i] > enough) open.push_back(i);
      if (bounds[i] <= enough) whole_.bound = std::max(whole_.bound, bounds[i]);
    }
    std::stable_sort(open.begin(), open.end(), [&](std::uint32_t a, std::uint32_t b) { return bounds[a] > bounds[b]; });
    for (std::uint32_t& i : open) i = starts_[i];
    return open;
  }

  void prove(const std::vector<std::uint32_t>& open) {
    constexpr std::size_t at_a_time = 16;
    const std::uint64_t triangles = starts_.size() + to_.size();
    const std::uint64_t most = options_.most_questions.value_or((std::uint64_t{1} << 22) + 64 * triangles);
    in_rounds((open.size() + at_a_time - 1) / at_a_time, 1, most, [&](std::size_t task, FarthestShare& share) {
      const std::size_t end = std::min(open.size(), (task + 1) * at_a_time);
      std::vector<BoundPiece> pieces;
      for (std::size_t i = end; i-- > task * at_a_time;) pieces.push_back(whole_triangle(open[i]));
      while (!pieces.empty()) {
        BoundPiece piece = pieces.back();
        pieces.pop_back();
        const bool is_over =
            share.result.questions >= share.most_questions || (asked_ && share.result.found > *asked_ + slack());
        if (piece.bound <= limit(share.result.found) || is_over) {
          share.result.bound = std::max(share.result.bound, piece.bound);
        } else {
          open_up(std::move(piece), share, pieces);
        }
      }
    });
  }

  /// Proves more of a piece, or parts it.
  void open_up(BoundPiece piece, FarthestShare& share, std::vector<BoundPiece>& pieces) const {
    const glm::dvec3 middle = piece.shape.middle();
    const Closest closest = ask(middle, piece.by, share);
    tighten(piece, closest.triangle);
    // No point is farther than the middle by more than its way from there, so what is small enough is always proved.
    piece.bound = std::min(piece.bound, closest.distance + piece.shape.reach_from(middle));
    if (piece.bound <= limit(share.result.found)) return pieces.push_back(std::move(piece));
    if (piece.shape.size() + 3 > ConvexPiece::most_corners) return fan_out(piece, pieces);
    if (!cut_out(piece, closest.triangle, share, pieces)) halve(piece, closest.triangle, middle, pieces);
  }

  Closest ask(const glm::dvec3& point, std::uint32_t hint, FarthestShare& share) const {
    const Closest closest = to_.nearest(point, hint);
    ++share.result.questions;
    share.find(closest.distance, point);
    return closest;
  }

  /// Cuts along the triangle's outline, at right angles to it, where the piece is not much larger.
  bool cut_out(const BoundPiece& piece, std::uint32_t near, FarthestShare& share,
               std::vector<BoundPiece>& pieces) const {
    constexpr double much_larger = 16;
    const TriangleCorners t = to_.corners(near);
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    if (piece.shape.area() > much_larger * glm::length(normal)) return false;
    std::array<ConvexPiece, 3> outside;
    ConvexPiece inside = piece.shape;
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::dvec3 outwards = glm::cross(t[(e + 1) % 3] - t[e], normal);
      CutPiece parts = cut(inside, outwards, glm::dot(outwards, t[e]), slack_of_cuts());
      if (parts.behind.size() == 0) return false;
      inside = parts.behind;
      outside[e] = parts.before;
    }
    bool is_cut = false;
    for (const ConvexPiece& part : outside) {
      if (part.size() == 0) continue;
      is_cut = true;
      pieces.push_back(part_of(piece, part, near));
    }
    if (!is_cut) return false;
    BoundPiece rest = part_of(piece, inside, near);
    if (rest.bound > limit(share.result.found)) {
      // Whether it is the triangle that is nearest to its farthest corner is then known.
      const TriangleCorners by = to_.corners(rest.by);
      const auto corners = rest.shape.corners();
      const auto farthest =
          std::ranges::max_element(corners, {}, [&](const glm::dvec3& corner) { return squared_distance(by, corner); });
      tighten(rest, ask(*farthest, rest.by, share).triangle);
      if (rest.bound > limit(share.result.found)) {
        halve(rest, near, rest.shape.middle(), pieces);
        return true;
      }
    }
    pieces.push_back(std::move(rest));
    return true;
  }

  void halve(const BoundPiece& piece, std::uint32_t near, const glm::dvec3& middle,
             std::vector<BoundPiece>& pieces) const {
    const glm::dvec3 across = piece.shape.longest();
    const CutPiece halves = cut(piece.shape, across, glm::dot(across, middle), slack_of_cuts());
    if (halves.behind.size() == 0 || halves.before.size() == 0) return fan_out(piece, pieces);
    for (const ConvexPiece& half : {halves.before, halves.behind}) pieces.push_back(part_of(piece, half, near));
  }

  void fan_out(const BoundPiece& piece, std::vector<BoundPiece>& pieces) const {
    const auto corners = piece.shape.corners();
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const TriangleCorners part{corners[0], corners[i - 1], corners[i]};
      pieces.push_back(part_of(piece, ConvexPiece(part), piece.by));
    }
  }

  BoundPiece part_of(const BoundPiece& piece, const ConvexPiece& shape, std::uint32_t near) const {
    BoundPiece part{shape, piece.bound, no_triangle};
    tighten(part, piece.by);
    tighten(part, near);
    if (part.by == no_triangle) part.by = piece.by;
    return part;
  }

  double slack_of_cuts() const { return extent_ * 0x1p-44; }

  const Surface& of_;
  const ClosestPoints& to_;
  const FarthestOptions& options_;
  const Executor& executor_;
  std::vector<std::uint32_t> starts_;   ///< in the indices, of triangles that are finite
  std::vector<std::uint32_t> nearest_;  ///< [vertex] the triangle nearest to it
  std::optional<double> asked_;
  double extent_ = 0;
  Farthest whole_;
};

}  // namespace

std::optional<Farthest> farthest_distance(const Surface& of, const ClosestPoints& to, const FarthestOptions& options,
                                          const Executor& executor) {
  FarthestSearch search(of, to, options, executor);
  if (to.empty() && !search.empty()) return std::nullopt;
  return search.run();
}

std::optional<Farthest> hausdorff_distance(const SearchedSurface& a, const SearchedSurface& b,
                                           const FarthestOptions& options, const Executor& executor) {
  const auto there = farthest_distance(a.surface, b.points, options, executor);
  if (!there || a.points.empty() != b.points.empty()) return std::nullopt;
  FarthestSearch search(b.surface, a.points, options, executor);
  search.start_from(*there);
  Farthest both = search.run();
  both.bound = std::max(both.bound, there->bound);
  both.is_within_tolerance = both.is_within_tolerance && there->is_within_tolerance;
  return both;
}

std::optional<bool> is_within(const Surface& of, const ClosestPoints& to, double distance,
                              const FarthestOptions& options, const Executor& executor) {
  FarthestSearch search(of, to, options, executor);
  if (to.empty() && !search.empty()) return std::nullopt;
  search.ask_for(distance);
  const Farthest answer = search.run();
  if (answer.found > distance + search.slack()) return false;
  if (answer.bound <= distance + search.slack()) return true;
  return std::nullopt;
}

}  // namespace foredraw
