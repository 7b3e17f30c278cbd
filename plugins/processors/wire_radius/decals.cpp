#include "decals.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::wiring {

namespace {

constexpr std::size_t most_samples = 32;

/// Calls take(i) for so many of `count` numbers, spread evenly.
template <class Take>
void spread(std::size_t count, Take take) {
  const std::size_t taken = std::min(count, most_samples);
  for (std::size_t i = 0; i < taken; ++i) take(i * count / taken);
}

}  // namespace

std::vector<RibbonSample> ribbon_samples(const Chain& chain, const WireRun& run) {
  std::vector<RibbonSample> samples;
  spread(run.last - run.first, [&](std::size_t i) {
    const ChainSection &a = chain.sections[run.first + i], &b = chain.sections[run.first + i + 1];
    if (!a.section.is_flat()) return;
    samples.push_back({(a.section.centre + b.section.centre) / 2.0,
                       glm::normalize(glm::cross(a.axis, a.section.across)), 2 * a.section.greatest});
  });
  return samples;
}

std::vector<RibbonSample> ribbon_samples(const WeldedMesh& mesh, std::span<const std::uint32_t> triangles,
                                         double breadth) {
  std::vector<RibbonSample> samples;
  spread(triangles.size(), [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[triangles[i]];
    const glm::dvec3 normal = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    const double length = glm::length(normal);
    if (length > 0)
      samples.push_back({(mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0, normal / length, breadth});
  });
  return samples;
}

bool is_decal(std::span<const RibbonSample> samples, double reach, const RayTree& surfaces) {
  std::size_t hits = 0;
  for (const RibbonSample& sample : samples) {
    const glm::dvec3 way = sample.normal * (reach * sample.breadth);
    const auto hit = surfaces.first({.from = sample.at + way, .direction = -2.0 * way});
    hits += hit && hit->way <= 1;
  }
  return !samples.empty() && 2 * hits >= samples.size();
}

}  // namespace foredraw::wiring
