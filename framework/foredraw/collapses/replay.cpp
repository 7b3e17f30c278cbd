#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/replay.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw {

namespace {

bool are_finite(std::span<const float> values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

/// The points of a mesh and the triangles at each, while edges collapse.
class Player {
 public:
  Player(const CollapseSequence& sequence, std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
         std::span<const std::uint32_t> part)
      : sequence_(sequence),
        part_(part),
        point_of_(welded(positions)),
        corners_(indices.begin(), indices.end()),
        triangles_at_(positions.size()),
        is_gone_(positions.size(), false) {
    for (std::size_t i = 0; i + 2 < corners_.size(); i += 3) {
      const auto t = static_cast<std::uint32_t>(i / 3);
      const std::array<std::uint32_t, 3> points{point(i), point(i + 1), point(i + 2)};
      if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) continue;
      for (const std::uint32_t p : points) triangles_at_[p].push_back(t);
      ++left_;
    }
    alive_.assign(corners_.size() / 3, true);
  }

  Replay play() {
    Replay answer;
    answer.mistake = mistake_of_sizes();
    if (!answer.mistake.empty()) return answer;
    answer.triangles.push_back(left_);
    // What an honest sequence looks at: the few triangles around each point that goes.
    std::uint64_t budget = 64 * (corners_.size() + sequence_.collapses.size() + 1024);
    float error = 0;
    for (std::size_t k = 0; k < sequence_.collapses.size(); ++k) {
      const Collapse& collapse = sequence_.collapses[k];
      std::string mistake = mistake_of(k, error);
      if (mistake.empty() && triangles_at_[collapse.removed].size() > budget) {
        mistake = "gathers too many triangles at one point";
      }
      if (mistake.empty()) {
        budget -= triangles_at_[collapse.removed].size();
        mistake = move_triangles(k);
      }
      if (!mistake.empty()) return {"collapse " + std::to_string(k) + " " + mistake, {}};
      error = collapse.error;
      answer.triangles.push_back(left_);
    }
    return answer;
  }

 private:
  std::uint32_t point(std::size_t corner) const { return point_of_[corners_[corner]]; }

  std::string mistake_of_sizes() const {
    const std::size_t collapses = sequence_.collapses.size(), pairs = sequence_.pairs.size();
    if (sequence_.first_pair.size() != collapses + 1 || sequence_.first_pair.front() != 0 ||
        sequence_.first_pair.back() != pairs || !std::ranges::is_sorted(sequence_.first_pair)) {
      return "its pairs of vertices do not belong to its collapses";
    }
    if (!sequence_.places.empty() && sequence_.places.size() != 3 * collapses) return "it lacks places";
    if (!are_finite(sequence_.places)) return "its places are not finite";
    return {};
  }

  std::string mistake_of(std::size_t k, float error) const {
    const Collapse& collapse = sequence_.collapses[k];
    const auto is_point = [&](std::uint32_t p) { return p < point_of_.size() && point_of_[p] == p && !is_gone_[p]; };
    if (!is_point(collapse.removed) || !is_point(collapse.kept)) return "names a point that is not there";
    if (collapse.removed == collapse.kept) return "names one point twice";
    if (!(collapse.error >= error) || !std::isfinite(collapse.error)) return "has an error less than those before";
    if (!(collapse.blend >= 0 && collapse.blend <= 1)) return "has a blend that is not from 0 to 1";
    for (const VertexPair& pair : pairs_of(k)) {
      const bool is_vertex = pair.removed < point_of_.size() && pair.kept < point_of_.size();
      if (!is_vertex || point_of_[pair.removed] != collapse.removed || point_of_[pair.kept] != collapse.kept) {
        return "pairs vertices of other points";
      }
      if (!part_.empty() && part_[pair.removed] != part_[pair.kept]) return "pairs vertices of different draws";
    }
    return {};
  }

  std::span<const VertexPair> pairs_of(std::size_t k) const {
    return std::span(sequence_.pairs)
        .subspan(sequence_.first_pair[k], sequence_.first_pair[k + 1] - sequence_.first_pair[k]);
  }

  std::string move_triangles(std::size_t k) {
    const auto [removed, kept] = std::pair(sequence_.collapses[k].removed, sequence_.collapses[k].kept);
    for (const std::uint32_t t : triangles_at_[removed]) {
      if (!alive_[t]) continue;
      const std::size_t first = std::size_t{3} * t;
      if (point(first) == kept || point(first + 1) == kept || point(first + 2) == kept) {
        alive_[t] = false;
        --left_;
        continue;
      }
      for (std::size_t i = first; i < first + 3; ++i) {
        if (point(i) != removed) continue;
        const auto pairs = pairs_of(k);
        const auto pair = std::ranges::find(pairs, corners_[i], &VertexPair::removed);
        if (pair == pairs.end()) return "leaves a corner without a vertex";
        corners_[i] = pair->kept;
      }
      triangles_at_[kept].push_back(t);
    }
    std::vector<std::uint32_t>().swap(triangles_at_[removed]);
    is_gone_[removed] = true;
    return {};
  }

  const CollapseSequence& sequence_;
  std::span<const std::uint32_t> part_;
  std::vector<std::uint32_t> point_of_, corners_;
  std::vector<std::vector<std::uint32_t>> triangles_at_;
  std::vector<bool> is_gone_, alive_;
  std::uint32_t left_ = 0;
};

}  // namespace

Replay replay(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
              std::span<const std::uint32_t> indices, std::span<const std::uint32_t> part) {
  return Player(sequence, positions, indices, part).play();
}

Collapsed collapsed(const CollapseSequence& sequence, std::size_t collapses, std::span<const glm::vec3> positions,
                    std::span<const std::uint32_t> indices) {
  const std::vector<std::uint32_t> point_of = welded(positions);
  Collapsed after;
  after.places.assign(positions.begin(), positions.end());
  std::vector<std::uint32_t> point(point_of);  // [point] = the one that stands for it
  after.vertex.resize(positions.size());
  for (std::uint32_t v = 0; v < after.vertex.size(); ++v) after.vertex[v] = v;
  for (std::size_t k = 0; k < collapses; ++k) {
    if (sequence.places.empty()) break;
    const float* place = sequence.places.data() + 3 * k;
    after.places[sequence.collapses[k].kept] = {place[0], place[1], place[2]};
  }
  // Backwards, what stands for the kept one is known already.
  for (std::size_t k = collapses; k-- > 0;) {
    const Collapse& collapse = sequence.collapses[k];
    point[collapse.removed] = point[collapse.kept];
    for (std::uint32_t i = sequence.first_pair[k]; i < sequence.first_pair[k + 1]; ++i) {
      after.vertex[sequence.pairs[i].removed] = after.vertex[sequence.pairs[i].kept];
    }
  }
  for (std::size_t v = 0; v < after.places.size(); ++v) after.places[v] = after.places[point_of[v]];
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto now_at = [&](std::size_t corner) { return point[point_of[indices[corner]]]; };
    const std::array<std::uint32_t, 3> now{now_at(i), now_at(i + 1), now_at(i + 2)};
    if (now[0] == now[1] || now[1] == now[2] || now[2] == now[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) after.indices.push_back(after.vertex[indices[i + k]]);
    after.origin.push_back(static_cast<std::uint32_t>(i / 3));
  }
  return after;
}

}  // namespace foredraw
