#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/attribute_walk.h>

#include <algorithm>

namespace foredraw {

AttributeWalk::AttributeWalk(const CollapseSequence& sequence, std::span<const glm::vec3> positions,
                             std::span<const std::uint32_t> indices)
    : sequence_(sequence) {
  if (!sequence.solves || sequence.places.empty() || indices.empty()) return;
  point_of_ = welded(positions);
  places_.assign(positions.begin(), positions.end());
  corners_.assign(indices.begin(), indices.end() - static_cast<std::ptrdiff_t>(indices.size() % 3));
  first_.resize(positions.size(), none);
  last_ = first_;
  next_.resize(corners_.size(), none);
  for (auto i = static_cast<std::uint32_t>(corners_.size()); i-- > 0;) {
    const std::uint32_t first = i - i % 3, point = point_of_[corners_[i]];
    const std::uint32_t a = point_of_[corners_[first]], b = point_of_[corners_[first + 1]],
                        c = point_of_[corners_[first + 2]];
    if (a == b || b == c || c == a) continue;
    next_[i] = first_[point];
    first_[point] = i;
    if (last_[point] == none) last_[point] = i;
  }
}

std::span<const VertexPair> AttributeWalk::pairs() const {
  return std::span(sequence_.pairs).first(sequence_.first_pair[at_ + 1]).subspan(sequence_.first_pair[at_]);
}

glm::vec3 AttributeWalk::place() const {
  const float* place = sequence_.places.data() + 3 * at_;
  return {place[0], place[1], place[2]};
}

bool AttributeWalk::has(std::uint32_t corner, std::uint32_t point) const {
  const std::uint32_t first = corner - corner % 3;
  return point_of_[corners_[first]] == point || point_of_[corners_[first + 1]] == point ||
         point_of_[corners_[first + 2]] == point;
}

void AttributeWalk::put(std::uint32_t vertex, std::uint32_t removed) {
  if (count_ == joined_.size()) joined_.emplace_back();
  JoinedVertex& added = joined_[count_++];
  added.vertex = vertex;
  added.removed = removed;
  added.shares.clear();
}

std::span<const JoinedVertex> AttributeWalk::next() {
  count_ = 0;
  for (const VertexPair& pair : pairs()) {
    const auto known = std::span(joined_).first(count_);
    if (std::ranges::find(known, pair.kept, &JoinedVertex::vertex) == known.end()) put(pair.kept, pair.removed);
  }
  if (!point_of_.empty()) {
    const Collapse& collapse = sequence_.collapses[at_];
    if (place() != places_[collapse.kept] && place() != places_[collapse.removed]) find_shares();
    join();
  }
  ++at_;
  return std::span(joined_).first(count_);
}

/// Each wedge looks at its own faces, so that nothing comes across a seam.
void AttributeWalk::find_shares() {
  const std::uint32_t removed = sequence_.collapses[at_].removed, kept = sequence_.collapses[at_].kept;
  faces_.clear();
  for (std::uint32_t i = first_[kept]; i != none; i = next_[i]) {
    if (!has(i, removed)) faces_.push_back({i / 3, corners_[i]});
  }
  for (std::uint32_t i = first_[removed]; i != none; i = next_[i]) {
    const auto pair = std::ranges::find(pairs(), corners_[i], &VertexPair::removed);
    if (pair != pairs().end()) faces_.push_back({i / 3, pair->kept});
  }
  if (faces_.size() > WedgeShares::most_faces) return;
  for (const WedgeFace& face : faces_) {
    const auto known = std::span(joined_).first(count_);
    if (std::ranges::find(known, face.wedge, &JoinedVertex::vertex) == known.end()) put(face.wedge, none);
  }
  for (std::size_t w = 0; w < count_; ++w) {
    shares_.start(place());
    for (const WedgeFace& face : faces_) {
      if (face.wedge != joined_[w].vertex) continue;
      const std::array vertices{corners_[3 * face.triangle], corners_[3 * face.triangle + 1],
                                corners_[3 * face.triangle + 2]};
      const auto place_of = [&](std::uint32_t vertex) { return places_[point_of_[vertex]]; };
      shares_.add({place_of(vertices[0]), place_of(vertices[1]), place_of(vertices[2])}, vertices);
    }
    const std::span<const WedgeShare> shares = shares_.finish();
    joined_[w].shares.assign(shares.begin(), shares.end());
  }
}

/// Triangles with both points leave the lists of all three.
void AttributeWalk::join() {
  const std::uint32_t removed = sequence_.collapses[at_].removed, kept = sequence_.collapses[at_].kept;
  const auto drop = [&](std::uint32_t point, const auto& leaves) {
    std::uint32_t before = none;
    for (std::uint32_t i = first_[point]; i != none; i = next_[i]) {
      if (!leaves(i)) {
        before = i;
        continue;
      }
      (before == none ? first_[point] : next_[before]) = next_[i];
      if (last_[point] == i) last_[point] = before;
    }
  };
  for (std::uint32_t i = first_[removed]; i != none; i = next_[i]) {
    if (!has(i, kept)) continue;
    for (std::uint32_t corner = i - i % 3; corner < i - i % 3 + 3; ++corner) {
      const std::uint32_t point = point_of_[corners_[corner]];
      if (point != removed && point != kept) drop(point, [&](std::uint32_t at) { return at == corner; });
    }
  }
  drop(kept, [&](std::uint32_t i) { return has(i, removed); });
  drop(removed, [&](std::uint32_t i) { return has(i, kept); });
  for (std::uint32_t i = first_[removed]; i != none; i = next_[i]) {
    const auto pair = std::ranges::find(pairs(), corners_[i], &VertexPair::removed);
    if (pair != pairs().end()) corners_[i] = pair->kept;
  }
  if (first_[removed] != none) {
    (last_[kept] == none ? first_[kept] : next_[last_[kept]]) = first_[removed];
    last_[kept] = last_[removed];
  }
  first_[removed] = last_[removed] = none;
  places_[kept] = place();
}

}  // namespace foredraw
