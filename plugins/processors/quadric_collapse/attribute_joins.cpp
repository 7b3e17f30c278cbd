// What a vertex carries that became of two: what its faces say at its place, or a blend.

#include "attribute_cost.h"

#include <algorithm>
#include <cmath>

namespace foredraw::processors::quadric_collapse {

/// As AttributeWalk and level_vertices() say it.
void AttributeCosts::solve(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend,
                           std::span<const VertexPair> pairs, Room& room) {
  using WedgeFace = Room::WedgeFace;
  auto& [faces, shares, solved] = room;
  faces.clear();
  const auto becomes = [&](const Face& face) {
    const std::uint32_t vertex = face.vertex[face.corner_of(removed)];
    return std::ranges::find(pairs, vertex, &VertexPair::removed)->kept;
  };
  for (const std::uint32_t f : mesh_.ring(kept)) {
    const Face& face = mesh_.face(f);
    faces.push_back({f, face.has(removed) ? becomes(face) : face.vertex[face.corner_of(kept)]});
  }
  for (const std::uint32_t f : mesh_.ring(removed)) {
    const Face& face = mesh_.face(f);
    if (!face.has(kept)) faces.push_back({f, becomes(face)});
  }
  for (std::size_t first = 0; first < faces.size(); ++first) {
    const std::uint32_t wedge = faces[first].wedge;
    if (std::ranges::find(faces, wedge, &WedgeFace::wedge) != faces.begin() + static_cast<std::ptrdiff_t>(first)) {
      continue;
    }
    shares.start(place);
    for (std::size_t i = first; i < faces.size(); ++i) {
      if (faces[i].wedge != wedge) continue;
      const Face& face = mesh_.face(faces[i].face);
      shares.add({mesh_.point(face.point[0]).place, mesh_.point(face.point[1]).place, mesh_.point(face.point[2]).place},
                 face.vertex);
    }
    const std::span<const WedgeShare> found = shares.finish();
    const auto pair = std::ranges::find(pairs, wedge, &VertexPair::kept);
    if (!found.empty()) {
      put(wedge, found, solved);
    } else if (pair != pairs.end()) {
      blend_numbers(*pair, 0, solved_, blend);
    }
  }
}

void AttributeCosts::put(std::uint32_t vertex, std::span<const WedgeShare> shares, std::vector<double>& solved) {
  constexpr double shortest = 0.1;  // what is left of opposite ones says nothing
  solved.clear();
  for (std::size_t i = 0; i < solved_; ++i) {
    solved.push_back(shared_number(shares, [&](std::uint32_t v) { return double{rows_.of(v)[i]}; }));
  }
  for (const AttributeRows::Direction& one : rows_.directions) {
    glm::dvec3 way;
    for (std::size_t k = 0; k < 3; ++k) {
      way[static_cast<int>(k)] =
          shared_sum(shares, [&](std::uint32_t v) { return double{rows_.of(v)[one.first + k]}; });
    }
    const double length = std::sqrt(dot(way, way));
    if (!(length > shortest * one.length)) continue;
    for (std::size_t k = 0; k < 3; ++k) solved[one.first + k] = way[static_cast<int>(k)] * (one.length / length);
  }
  std::ranges::copy(solved, rows_.of(vertex));
}

void AttributeCosts::join(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend,
                          std::span<const VertexPair> pairs, Room& room) {
  if (empty()) return;
  const bool moves = place != mesh_.point(removed).place && place != mesh_.point(kept).place;
  const std::size_t first = moves ? solved_ : 0;
  if (moves && solved_ > 0) solve(removed, kept, place, blend, pairs, room);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool is_blended = std::ranges::find(pairs.first(i), pairs[i].kept, &VertexPair::kept) != pairs.begin() + i;
    if (!is_blended) blend_numbers(pairs[i], first, rows_.width, blend);
  }
}

void AttributeCosts::blend_numbers(const VertexPair& pair, std::size_t first, std::size_t end, float blend) {
  float* to = rows_.of(pair.kept);
  const float* from = rows_.of(pair.removed);
  for (std::size_t i = first; i < end; ++i) to[i] += (from[i] - to[i]) * blend;
}

}  // namespace foredraw::processors::quadric_collapse
