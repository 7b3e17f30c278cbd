#include "wire_points.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::processors::wire_radius {

WirePoints::WirePoints(const WeldedMesh& mesh)
    : mesh_(mesh), cutter_(mesh), points_(mesh.points.size()), triangles_(mesh.triangles.size(), 0) {}

/// Searches from the section that a point beside it is at.
const WirePoints::Seen& WirePoints::look_at(std::uint32_t point, std::uint32_t triangle, std::uint32_t near,
                                            const Chain& chain, const WireRun& run) {
  Seen& seen = points_[point];
  if (seen.run == run_) return seen;
  const std::vector<ChainSection>& all = chain.sections;
  const glm::dvec3& at = mesh_.points[point];
  const auto distance = [&](std::size_t section) { return glm::distance(all[section].section.centre, at); };
  const std::size_t count = run.last - run.first + 1;
  // Beside a ring's last section is its first one.
  const auto beside = [&](std::size_t section, bool later) {
    const std::size_t from = section - run.first;
    if (run.closed) return run.first + (from + (later ? 1 : count - 1)) % count;
    return later ? std::min(section + 1, run.last) : std::max(section, run.first + 1) - 1;
  };
  std::size_t section = near;
  for (bool moved = true; moved;) {
    moved = false;
    for (const bool later : {false, true}) {
      const std::size_t other = beside(section, later);
      if (distance(other) < distance(section)) {
        section = other;
        moved = true;
      }
    }
  }
  const ChainSection& nearest = all[section];
  const double along = glm::dot(at - nearest.section.centre, nearest.axis);
  const double off = glm::length(at - nearest.section.centre - along * nearest.axis);
  const bool at_end = !run.closed && ((section == run.first && along < 0) || (section == run.last && along > 0));
  // A square's corner is 1.41 times as far from its centre as its side; beyond the ends there may be a round cap.
  const std::size_t next = beside(section, along > 0);
  const double gap = glm::distance(all[next].section.centre, nearest.section.centre);
  const double part = gap > 0 ? std::clamp(std::abs(along) / gap, 0.0, 1.0) : 0.0;
  const double greatest =
      nearest.section.greatest + (all[next].section.greatest - nearest.section.greatest) * (at_end ? 0.0 : part);
  seen.run = run_;
  seen.section = static_cast<std::uint32_t>(section);
  seen.triangle = triangle;
  seen.beyond = at_end ? std::abs(along) : 0;
  // At a bend the section is wider, where two pieces meet.
  const double mitre = std::sqrt((1 + std::max(0.0, glm::dot(nearest.axis, all[next].axis))) / 2);
  seen.is_along = off * mitre <= 1.5 * greatest && seen.beyond <= 1.1 * nearest.section.mean_half_width();
  return seen;
}

WirePoint WirePoints::centred(const Seen& seen, std::uint32_t point, const Chain& chain, const WireRun& run) {
  const std::vector<ChainSection>& all = chain.sections;
  const ChainSection& nearest = all[seen.section];
  const glm::dvec3& at = mesh_.points[point];
  const double half = nearest.section.mean_half_width();
  // Along the axis half way to the neighbouring section, and a little towards the middle, where a section is whole.
  const double along = glm::dot(at - nearest.section.centre, nearest.axis);
  glm::dvec3 axis = nearest.axis;
  std::size_t next = seen.section;
  if (along > 0 && seen.section < run.last) ++next;
  if (along < 0 && seen.section > run.first) --next;
  if (next != seen.section) {
    const double gap = glm::distance(all[next].section.centre, nearest.section.centre);
    axis = glm::normalize(axis + (all[next].axis - axis) * std::clamp(std::abs(along) / gap, 0.0, 1.0));
  }
  const auto lay_flat = [&](WirePoint& of, const Section& section) {
    of.is_flat = section.is_flat();
    if (!of.is_flat) return;
    // Along the breadth, though a ribbon may be folded a little; in its middle so short that nothing moves by it.
    const double least = of.half_width / 1024, across = glm::dot(of.to_centre, section.across);
    of.to_centre = section.across * (std::abs(across) > least ? across : least);
  };
  const double inwards = 2 * std::size_t{seen.section} < run.first + run.last ? 0.02 * half : -0.02 * half;
  const Plane plane{at + inwards * axis, axis};
  WirePoint result{point, nearest.section.centre + along * nearest.axis - at, axis, nearest.section.half_width(),
                   false};
  lay_flat(result, nearest.section);
  const std::uint32_t there = cutter_.walk(seen.triangle, plane, 64);
  if (there == none || !cutter_.cut(there, plane, 256, 1e300)) return result;
  const Section& own = cutter_.section();
  const bool is_alike = own.closed == nearest.section.closed && own.half_width() < 1.5 * nearest.section.half_width() &&
                        1.5 * own.half_width() > nearest.section.half_width() &&
                        glm::distance(own.centre, plane.at) < 2 * nearest.section.greatest;
  if (!is_alike) return result;
  result.to_centre = own.centre - inwards * axis - at;
  result.half_width = own.half_width();
  lay_flat(result, own);
  return result;
}

WireParts WirePoints::along(const Chain& chain, const WireRun& run) {
  ++run_;
  WireParts parts;
  std::vector<std::uint32_t> waiting;
  std::vector<std::uint32_t> near;  // the section that the triangle is near to
  for (std::size_t i = run.first; i <= run.last; ++i) {
    const std::uint32_t t = chain.sections[i].triangle;
    if (triangles_[t] == run_) continue;
    triangles_[t] = run_;
    waiting.push_back(t);
    near.push_back(static_cast<std::uint32_t>(i));
  }
  double beyond[2] = {0, 0};
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back(), at = near.back();
    waiting.pop_back();
    near.pop_back();
    bool is_along = true;
    std::uint32_t beside = at;
    for (const std::uint32_t point : mesh_.triangles[t]) {
      const Seen& seen = look_at(point, t, at, chain, run);
      is_along &= seen.is_along;
      beside = seen.section;
    }
    if (!is_along) continue;
    parts.triangles.push_back(t);
    for (const std::uint32_t other : mesh_.across[t]) {
      if (other == none || triangles_[other] == run_) continue;
      triangles_[other] = run_;
      waiting.push_back(other);
      near.push_back(beside);
    }
  }
  std::ranges::sort(parts.triangles);
  std::vector<std::uint32_t> points;
  for (const std::uint32_t t : parts.triangles)
    points.insert(points.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const std::uint32_t point : points) {
    const Seen& seen = points_[point];
    double& end = beyond[seen.section == run.first ? 0 : 1];
    end = std::max(end, seen.beyond);
    parts.points.push_back(centred(seen, point, chain, run));
  }
  parts.beyond = beyond[0] + beyond[1];
  return parts;
}

}  // namespace foredraw::processors::wire_radius
