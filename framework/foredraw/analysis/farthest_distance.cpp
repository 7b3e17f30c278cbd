#include <foredraw/analysis/farthest_distance.h>

#include <foredraw/analysis/piece_proof.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace foredraw {

namespace {

constexpr double precision_of_floats = 0x1p-23;

class FarthestSearch {
 public:
  FarthestSearch(const Surface& of, const ClosestPoints& to, const FarthestOptions& options, const Executor& executor)
      : of_(of), to_(to), options_(options), executor_(executor), nearest_(of.positions.size()) {
    double extent = to.extent();
    for (std::uint32_t i = 0; i + 3 <= of.indices.size(); i += 3) {
      double most = 0;
      bool has_numbers = true;
      for (const glm::dvec3& p : corners_at(i)) {
        has_numbers = has_numbers && is_finite(p);
        most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
      if (!has_numbers) continue;
      starts_.push_back(i);
      extent = std::max(extent, most);
    }
    goal_ = {options.tolerance, extent * precision_of_floats};
  }

  bool empty() const { return starts_.empty(); }
  /// What is known to be so far need not be found again.
  void start_from(const Farthest& known) {
    whole_.found = known.found;
    whole_.at = known.at;
    whole_.questions = known.questions;
  }
  /// Nothing but whether it is farther than that is asked.
  void ask_for(double distance) { goal_.asked = distance; }

  Farthest run() {
    if (starts_.empty()) return whole_;
    ask_for_vertices();
    if (is_cancelled()) {
      whole_.bound = std::numeric_limits<double>::infinity();
    } else if (!is_answered()) {
      prove(bound_all());
    }
    whole_.bound = std::max(whole_.bound, whole_.found);
    whole_.is_within_tolerance = whole_.bound <= goal_.limit(whole_.found);
    return whole_;
  }

  const FarthestGoal& goal() const { return goal_; }

 private:
  TriangleCorners corners_at(std::size_t start) const {
    TriangleCorners corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = glm::dvec3(of_.positions[of_.indices[start + c]]);
    return corners;
  }

  bool is_cancelled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }
  bool is_answered() const { return goal_.is_beyond(whole_.found); }

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
    in_rounds(tasks, goal_.asked ? 4 : tasks, 0, [&](std::size_t task, FarthestShare& share) {
      if (is_cancelled()) return;
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

  BoundPiece whole_triangle(std::uint32_t start) const {
    BoundPiece piece{ConvexPiece(corners_at(start))};
    for (const std::uint32_t v : of_.indices.subspan(start, 3)) proof_.tighten(piece, nearest_[v]);
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
    const double enough = goal_.limit(whole_.found);
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
        const Farthest& known = share.result;
        const bool is_over = known.questions >= share.most_questions || goal_.is_beyond(known.found) || is_cancelled();
        if (piece.bound <= goal_.limit(known.found) || is_over) {
          share.result.bound = std::max(share.result.bound, piece.bound);
        } else {
          proof_.open_up(std::move(piece), share, pieces);
        }
      }
    });
  }

  const Surface& of_;
  const ClosestPoints& to_;
  const FarthestOptions& options_;
  const Executor& executor_;
  std::vector<std::uint32_t> starts_;   ///< in the indices, of triangles that are finite
  std::vector<std::uint32_t> nearest_;  ///< [vertex] the triangle nearest to it
  FarthestGoal goal_;
  PieceProof proof_{to_, goal_};
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
  if (search.goal().is_beyond(answer.found)) return false;
  if (answer.bound <= search.goal().limit(answer.found)) return true;
  return std::nullopt;
}

}  // namespace foredraw
