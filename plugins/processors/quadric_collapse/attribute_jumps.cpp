// What it costs that vertices become one that no face joins them to: their attributes jump between the faces that meet.

#include "attribute_cost.h"

#include <algorithm>

namespace foredraw::processors::quadric_collapse {

double AttributeCosts::turned(std::uint32_t one, std::uint32_t other) const {
  if (rows_.directions.empty()) return 1;
  double squared = 0;
  for (const AttributeRows::Direction& direction : rows_.directions) {
    if (!(direction.length > 0)) continue;
    for (std::size_t i = direction.first; i < direction.first + 3; ++i) {
      const double difference = (double{rows_.of(one)[i]} - rows_.of(other)[i]) / direction.length;
      squared += difference * difference;
    }
  }
  return squared;
}

/// A vertex, seen from the place where it becomes one with others: what the functions of its faces say there.
struct AttributeCosts::Jump {
  const Sums& of;
  const glm::dvec3* by_number;
  const float* row;
  glm::dvec3 way;  ///< to the place, from where the vertex is

  /// Sums over faces, by area, of their functions of attribute i less `from`.
  double sum(std::size_t i, double from) const { return of.area * (double{row[i]} - from) + dot(by_number[i], way); }
};

double AttributeCosts::jumps(std::uint32_t removed, std::uint32_t kept, glm::vec3 place, float blend,
                             const JoinedVertices& joined) {
  if (empty() || joined.by_faces == joined.pairs.size()) return 0;
  add_up(removed), add_up(kept);
  const auto seen_from = [&](std::uint32_t vertex, std::uint32_t point) {
    return Jump{sums_[vertex], sums_by_number_.data() + vertex * rows_.width, rows_.of(vertex),
                glm::dvec3(place) - glm::dvec3(mesh_.point(point).place)};
  };
  const auto joined_by_face = std::span(joined.pairs).first(joined.by_faces);
  const auto others = std::span(joined.pairs).subspan(joined.by_faces);
  double sum = 0;
  for (std::size_t first = 0; first < others.size(); ++first) {
    const std::uint32_t to = others[first].kept;
    if (std::ranges::find(others.first(first), to, &VertexPair::kept) != others.begin() + first) continue;
    const auto beside = std::ranges::find(joined_by_face, to, &VertexPair::kept);
    const bool has_one = beside != joined_by_face.end();
    const Jump stays = seen_from(to, kept);
    const Jump comes = seen_from(has_one ? beside->removed : others[first].removed, removed);
    for (std::size_t i = 0; i < solved_; ++i) {
      // The variance between vertices, in which those that a face joins are one.
      const double from = double{stays.row[i]};
      double area = stays.of.area, all = stays.sum(i, from), squares = 0;
      if (has_one) area += comes.of.area, all += comes.sum(i, from);
      if (area > 0) squares = all * all / area;
      for (const VertexPair& pair : others.subspan(first)) {
        if (pair.kept != to) continue;
        const Jump one = seen_from(pair.removed, removed);
        if (!(one.of.area > 0)) continue;
        const double of_one = one.sum(i, from);
        area += one.of.area, all += of_one, squares += of_one * of_one / one.of.area;
      }
      if (area > 0) sum += squares - all * all / area;
    }
    for (std::size_t i = solved_; i < rows_.width; ++i) {
      const double value = double{stays.row[i]} + (double{comes.row[i]} - stays.row[i]) * blend;
      const auto add = [&](const Jump& one) {
        const double difference = double{one.row[i]} - value;
        sum += difference * (one.of.area * difference + 2 * dot(one.by_number[i], one.way));
      };
      if (!has_one) add(stays);
      for (const VertexPair& pair : others.subspan(first)) {
        if (pair.kept == to) add(seen_from(pair.removed, removed));
      }
    }
  }
  return std::max(sum, 0.0);
}

}  // namespace foredraw::processors::quadric_collapse
