#include "energy_mesh.h"

#include "distance_term.h"
#include "spring_term.h"

#include <foredraw/analysis/surface_samples.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::processors::energy_collapse {

namespace {

constexpr std::size_t most_triangles = 64;  // around an edge; it waits until there are fewer

bool has(const CollapseRecorder::Corners& corners, std::uint32_t p) {
  return std::ranges::find(corners, p) != corners.end();
}

}  // namespace

EnergyMesh::EnergyMesh(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                       const VertexScalars& scalars, const EnergyCollapseOptions& options)
    : options_(options),
      recorder_(positions, indices),
      rules_(recorder_),
      frame_(unit_frame(positions, recorder_)),
      positions_(positions.begin(), positions.end()),
      values_(scalars.values.begin(), scalars.values.end()),
      width_(options.scalar > 0 ? scalars.width : 0) {
  if (!(frame_.diagonal > 0)) frame_.diagonal = 1;
  constexpr float most = 1e30f;  // so that what two of them differ by is a float, and its square a double
  for (float& value : values_) value = std::isfinite(value) ? std::clamp(value, -most, most) : 0.0f;
  places_.reserve(positions.size());
  for (std::uint32_t p = 0; p < positions.size(); ++p) {
    places_.push_back(recorder_.is_finite(p) ? at(positions[p]) : glm::dvec3(0));
  }
  scatter_samples(positions);
  scatter_curve_samples();
}

void EnergyMesh::scatter_samples(std::span<const glm::vec3> positions) {
  samples_on_.resize(recorder_.points().size());
  std::vector<std::uint32_t> corners;
  for (const CollapseRecorder::Corners& points : recorder_.points()) {
    corners.insert(corners.end(), points.begin(), points.end());
  }
  const std::size_t count = recorder_.points().size() * options_.samples;
  for (const SurfacePoint& point : points_on(Surface{positions, corners}, count, options_.seed)) {
    const CollapseRecorder::Corners& points = recorder_.points()[point.triangle];
    const CollapseRecorder::Corners& vertices = recorder_.vertices()[point.triangle];
    samples_on_[point.triangle].push_back(static_cast<std::uint32_t>(samples_.size()));
    glm::dvec3 place(0);
    for (int k = 0; k < 3; ++k) place += point.weights[k] * places_[points[static_cast<std::size_t>(k)]];
    samples_.push_back({place});
    for (std::size_t s = 0; s < width_; ++s) {
      double value = 0;
      for (int k = 0; k < 3; ++k) {
        value += point.weights[k] * static_cast<double>(values_[vertices[static_cast<std::size_t>(k)] * width_ + s]);
      }
      sample_values_.push_back(static_cast<float>(value));
    }
  }
}

/// As dense along curves as the others are on the surface, and one at each end.
void EnergyMesh::scatter_curve_samples() {
  double area = 0;
  for (const auto& [a, b, c] : recorder_.points()) {
    const glm::dvec3 normal = glm::cross(places_[b] - places_[a], places_[c] - places_[a]);
    area += 0.5 * std::sqrt(glm::dot(normal, normal));
  }
  spacing_ = samples_.empty() ? 1 : std::sqrt(area / static_cast<double>(samples_.size()));
  for (std::uint32_t p = 0; p < places_.size(); ++p) {
    for (const std::uint32_t q : rules_.sharp_neighbours(p)) {
      if (q < p || !recorder_.is_finite(p) || !recorder_.is_finite(q)) continue;
      const glm::dvec3 edge = places_[q] - places_[p];
      const double pieces = spacing_ > 0 ? std::ceil(std::sqrt(glm::dot(edge, edge)) / spacing_) : 1;
      const int count = static_cast<int>(std::clamp(pieces, 1.0, 64.0));
      for (int i = 0; i <= count; ++i) {
        curve_samples_on_[{p, q}].push_back(static_cast<std::uint32_t>(curve_samples_.size()));
        curve_samples_.push_back({places_[p] + edge * (static_cast<double>(i) / count)});
      }
    }
  }
}

std::vector<std::uint32_t> EnergyMesh::neighbours(std::uint32_t p) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t t : recorder_.triangles_at(p)) {
    for (const std::uint32_t q : recorder_.points()[t]) {
      if (q != p && std::ranges::find(found, q) == found.end()) found.push_back(q);
    }
  }
  return found;
}

void EnergyMesh::add_triangles(std::uint32_t p, std::uint32_t other, Star& star) const {
  for (const std::uint32_t t : recorder_.triangles_at(p)) {
    const CollapseRecorder::Corners& points = recorder_.points()[t];
    if (has(points, other)) continue;
    const auto k = static_cast<std::size_t>(std::ranges::find(points, p) - points.begin());
    StarTriangle triangle;
    triangle.number = t;
    for (std::size_t i = 0; i < 3; ++i) triangle.vertex[i] = recorder_.vertices()[t][(k + i) % 3];
    triangle.others = {places_[points[(k + 1) % 3]], places_[points[(k + 2) % 3]]};
    triangle.normal = glm::cross(triangle.others[0] - places_[p], triangle.others[1] - places_[p]);
    for (const VertexPair& pair : recorder_.pairs()) {
      if (pair.kept != triangle.vertex[0] && pair.removed != triangle.vertex[0]) continue;
      triangle.vertex[0] = pair.kept;
      triangle.removed = pair.removed;
      break;
    }
    star.triangles.push_back(triangle);
  }
}

void EnergyMesh::add_curves(std::uint32_t p, std::uint32_t other, Star& star) const {
  for (const std::uint32_t q : rules_.sharp_neighbours(p)) {
    if (q != other) {
      star.curve_ends.push_back(q);
      star.curve_end_at.push_back(places_[q]);
    } else if (other < p) {
      continue;  // the edge itself, seen from its other end
    }
    const auto on = curve_samples_on_.find(std::minmax(p, q));
    if (on == curve_samples_on_.end()) continue;
    star.curve_samples.insert(star.curve_samples.end(), on->second.begin(), on->second.end());
  }
}

void EnergyMesh::add_springs(std::uint32_t removed, std::uint32_t kept, Star& star) const {
  const auto squared = [&](std::uint32_t a, std::uint32_t b) {
    const glm::dvec3 edge = places_[a] - places_[b];
    return glm::dot(edge, edge);
  };
  double before = squared(removed, kept);
  std::vector<std::uint32_t> ends = neighbours(kept);
  std::erase(ends, removed);
  for (const std::uint32_t end : ends) before += squared(end, kept);
  for (const std::uint32_t end : neighbours(removed)) {
    if (end == kept) continue;
    before += squared(end, removed);
    if (std::ranges::find(ends, end) == ends.end()) ends.push_back(end);
  }
  for (const std::uint32_t end : ends) star.neighbours.push_back(places_[end]);
  const double per_triangle = static_cast<double>(star.samples.size()) / static_cast<double>(star.triangles.size() + 2);
  star.stiffness = options_.spring * spring_factor(per_triangle);
  star.before += star.stiffness * before;
}

Star EnergyMesh::star_of(std::uint32_t removed, std::uint32_t kept) const {
  Star star;
  add_triangles(kept, removed, star);
  add_triangles(removed, kept, star);
  const auto add_samples = [&](std::uint32_t t) {
    star.samples.insert(star.samples.end(), samples_on_[t].begin(), samples_on_[t].end());
  };
  for (const StarTriangle& triangle : star.triangles) add_samples(triangle.number);
  for (const std::uint32_t t : recorder_.triangles_at(removed)) {
    if (has(recorder_.points()[t], kept)) add_samples(t);
  }
  double distances = 0, differences = 0, from_curves = 0;
  for (const std::uint32_t s : star.samples) {
    star.sample_at.push_back(samples_[s].at);
    distances += samples_[s].squared;
    differences += samples_[s].difference;
  }
  add_curves(kept, removed, star);
  add_curves(removed, kept, star);
  for (const std::uint32_t c : star.curve_samples) {
    star.curve_at.push_back(curve_samples_[c].at);
    from_curves += curve_samples_[c].squared;
  }
  star.before = options_.distance * distances + options_.scalar * differences + options_.discontinuity * from_curves;
  add_springs(removed, kept, star);
  return star;
}

bool EnergyMesh::keeps_sides(const Star& star, const glm::dvec3& place) const {
  constexpr double least_cosine = 0.2;
  return std::ranges::all_of(star.triangles, [&](const StarTriangle& triangle) {
    const double before = glm::dot(triangle.normal, triangle.normal);
    if (!(before > 0)) return true;
    const glm::dvec3 normal = glm::cross(triangle.others[0] - place, triangle.others[1] - place);
    const double along = glm::dot(normal, triangle.normal);
    return along > 0 && along * along >= least_cosine * least_cosine * before * glm::dot(normal, normal);
  });
}

std::optional<Joined> EnergyMesh::best(std::uint32_t p, std::uint32_t q) {
  if (recorder_.triangles_at(p).size() + recorder_.triangles_at(q).size() > most_triangles) return std::nullopt;
  if (!recorder_.keeps_topology(p, q) || !rules_.keeps_curves(p, q)) return std::nullopt;
  Joined joined{p, q};
  if (!recorder_.pairs_up(p, q)) {
    if (!recorder_.pairs_up(q, p)) return std::nullopt;
    joined = {q, p};
  }
  const Star star = star_of(joined.removed, joined.kept);
  const auto energy_at = [&](const glm::dvec3& place, Fit& fit) {
    const double distances = distance_term(star, place, 1, nearest_, fit);
    fit.matrix *= options_.distance;
    fit.vector *= options_.distance;
    const double mean = distances / static_cast<double>(std::max<std::size_t>(1, star.samples.size()));
    return options_.distance * distances + overshoot_term(star, place, options_.distance, mean, spacing_) +
           spring_term(star, place, fit) + discontinuity_term(star, place, options_.discontinuity, curve_nearest_, fit);
  };
  double least = std::numeric_limits<double>::infinity();
  glm::dvec3 place(0);
  Fit at_place;
  const auto offer = [&](const glm::dvec3& wanted) {
    const glm::dvec3 one = rounded(wanted);
    if (!std::isfinite(one.x + one.y + one.z) || !keeps_sides(star, one)) return;
    Fit fit;
    const double energy = energy_at(one, fit);
    if (!(energy < least)) return;
    least = energy;
    place = one;
    at_place = fit;
  };
  for (const double along : {0.0, 0.5, 1.0}) {
    offer(places_[joined.kept] + along * (places_[joined.removed] - places_[joined.kept]));
  }
  for (std::uint32_t round = 0; round < options_.rounds && at_place.matrix > 0; ++round) {
    const double before = least;
    offer(at_place.vector / at_place.matrix);
    if (!(least < before)) break;
  }
  if (!std::isfinite(least)) return std::nullopt;
  joined.place = to_mesh(place);
  joined.blend = static_cast<double>(blend_of(positions_[joined.kept], positions_[joined.removed], joined.place));
  if (width_ > 0) {
    Fit fit;
    distance_term(star, place, options_.distance, nearest_, fit);
    const ScalarFit scalar = scalar_term(star, nearest_, scalars(), sample_values_, options_.scalar);
    least += scalar.energy;
    joined.blend = scalar.blend;
  }
  joined.cost = least - star.before;
  return joined;
}

void EnergyMesh::collapse(const Joined& joined) {
  const auto [removed, kept] = std::pair(joined.removed, joined.kept);
  recorder_.pairs_up(removed, kept);
  const Star star = star_of(removed, kept);
  const glm::dvec3 place = at(joined.place);
  Fit fit;
  const double distances = distance_term(star, place, 1, nearest_, fit);
  discontinuity_term(star, place, 1, curve_nearest_, fit);
  const float blend = static_cast<float>(joined.blend);
  for (const VertexPair& pair : recorder_.pairs()) {
    for (std::size_t k = 0; k < width_; ++k) {
      float& value = values_[pair.kept * width_ + k];
      value += blend * (values_[pair.removed * width_ + k] - value);
    }
  }
  for (const std::uint32_t one : {removed, kept}) {
    for (const std::uint32_t t : recorder_.triangles_at(one)) samples_on_[t].clear();
  }
  for (std::size_t i = 0; i < star.samples.size(); ++i) {
    const StarTriangle& triangle = star.triangles[nearest_[i].triangle];
    Sample& sample = samples_[star.samples[i]];
    samples_on_[triangle.number].push_back(star.samples[i]);
    sample.squared = nearest_[i].squared;
    if (width_ == 0) continue;
    const std::span<const float> values(sample_values_.data() + star.samples[i] * width_, width_);
    sample.difference = scalar_difference(triangle, nearest_[i].weights, 0, scalars(), values);
  }
  for (const std::uint32_t one : {removed, kept}) {
    for (const std::uint32_t end : star.curve_ends) curve_samples_on_.erase(std::minmax(one, end));
  }
  curve_samples_on_.erase(std::minmax(removed, kept));
  for (std::size_t i = 0; i < star.curve_samples.size() && !star.curve_ends.empty(); ++i) {
    const std::uint32_t end = star.curve_ends[curve_nearest_[i].triangle];
    curve_samples_on_[std::minmax(kept, end)].push_back(star.curve_samples[i]);
    curve_samples_[star.curve_samples[i]].squared = curve_nearest_[i].squared;
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, star.samples.size()));
  recorder_.collapse(removed, kept, {blend, length_unit() * std::sqrt(distances / count), joined.place});
  positions_[kept] = joined.place;
  places_[kept] = place;
}

}  // namespace foredraw::processors::energy_collapse
