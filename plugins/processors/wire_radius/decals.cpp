#include "decals.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::processors::wire_radius {

namespace {

constexpr std::size_t most_probes = 16;

bool is_crossed(const BackProbe::Line& line, const RayTree& surfaces) {
  const glm::dvec3 way = line.to - line.from;
  if (!(glm::dot(way, way) > 0)) return false;
  const auto hit = surfaces.first({.from = line.from, .direction = way});
  return hit && hit->way <= 1;
}

/// Two lines across a tube, and the four halves of these.
BackProbe across_tube(const ChainSection& at, const glm::dvec3& centre) {
  // Within its own walls, which a triangle has at .67 of its half width, and a pentagon at .89.
  const double within = at.section.roundness < 0.7 ? 0.6 : 0.8;
  const glm::dvec3 wide = at.section.across * (within * at.section.least);
  const glm::dvec3 square = glm::normalize(glm::cross(at.axis, at.section.across)) * (within * at.section.least);
  return {{{centre - wide, centre + wide}, {centre - square, centre + square}},
          {{centre, centre + wide}, {centre, centre - wide}, {centre, centre + square}, {centre, centre - square}}};
}

}  // namespace

std::vector<BackProbe> back_probes(const Chain& chain, const WireRun& run, double reach) {
  std::vector<BackProbe> probes;
  const std::vector<ChainSection>& all = chain.sections;
  const double begin = all[run.first].along, length = all[run.last].along - begin;
  std::size_t at = run.first;
  for (std::size_t i = 0; i < most_probes; ++i) {
    const double along = begin + length * (static_cast<double>(i) + 0.5) / most_probes;
    while (at + 1 < run.last && all[at + 1].along <= along) ++at;
    const ChainSection &a = all[at], &b = all[at + 1];
    const double part = b.along > a.along ? (along - a.along) / (b.along - a.along) : 0;
    const glm::dvec3 centre = a.section.centre + (b.section.centre - a.section.centre) * part;
    const double distance = reach * 2 * a.section.greatest;
    if (a.section.closed) {
      if (a.section.least > 0) probes.push_back(across_tube(a, centre));
    } else if (a.section.is_flat()) {
      const glm::dvec3 way = glm::normalize(glm::cross(a.axis, a.section.across)) * distance;
      probes.push_back({{{centre + way, centre - way}}, {}});
    } else {
      probes.push_back({{{centre, centre + a.section.opening * distance}}, {}});
    }
  }
  return probes;
}

std::vector<BackProbe> back_probes(const WeldedMesh& mesh, std::span<const std::uint32_t> triangles, double distance) {
  std::vector<BackProbe> probes;
  const std::size_t taken = std::min(triangles.size(), most_probes);
  for (std::size_t i = 0; i < taken; ++i) {
    const auto& [a, b, c] = mesh.triangles[triangles[i * triangles.size() / taken]];
    const glm::dvec3 normal = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    const glm::dvec3 centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    probes.push_back({{{centre + normal * (distance / length), centre - normal * (distance / length)}}, {}});
  }
  return probes;
}

bool is_decal(std::span<const BackProbe> probes, const RayTree& surfaces) {
  std::size_t hits = 0;
  for (const BackProbe& probe : probes) {
    const auto crossed = [&](const BackProbe::Line& line) { return is_crossed(line, surfaces); };
    hits += std::ranges::any_of(probe.lines, crossed) &&
            (probe.outside.empty() || !std::ranges::all_of(probe.outside, crossed));
  }
  return !probes.empty() && 2 * hits >= probes.size();
}

}  // namespace foredraw::processors::wire_radius
