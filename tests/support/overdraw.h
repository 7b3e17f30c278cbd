#pragma once
// What tests of evaluators of overdraw look at, and how they ask.

#include "support/meshes.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/mask.h>
#include <foredraw/viewing/view_set.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace foredraw::testing {

inline Views views_of(const std::vector<glm::dvec3>& directions, int size = 64, double distance = 0) {
  Views views{{}, size};
  for (const glm::dvec3& direction : directions) views.views.push_back({direction, distance});
  return views;
}

inline Views all_sides(int size = 64, double distance = 0, int count = 20) {
  ViewSet set;
  set.views = "fibonacci";
  set.count = count;
  set.size = size;
  if (distance > 0) set.distance = distance;
  return make_views(set);
}

/// Of all parts and views.
inline OverdrawCount total(const OverdrawCounts& counts) {
  OverdrawCount sum;
  for (const auto& part : counts) {
    for (const OverdrawCount& count : part) sum += count;
  }
  return sum;
}

/// A square that faces +Z.
inline TestMesh quad(float z, float half = 1) {
  return {{{-half, -half, z}, {half, -half, z}, {-half, half, z}, {half, half, z}}, {0, 1, 2, 2, 1, 3}};
}

/// Of a square whose left half is a hole.
inline std::shared_ptr<const Mask> half_a_hole() {
  auto mask = std::make_shared<Mask>();
  mask->image = std::make_shared<const AlphaImage>(AlphaImage{2, 1, {0, 65535}});
  mask->sampling.is_nearest = true;
  mask->uv = {{0, 1}, {1, 1}, {0, 0}, {1, 0}};
  mask->alphas.assign(4, 1);
  return mask;
}

/// Random triangles large enough to hide one another, each there twice so that there are ties.
inline TestMesh crowd(std::uint64_t seed) {
  Random random(seed);
  const auto coordinate = [&] { return static_cast<float>(random.unit()); };
  TestMesh mesh;
  for (std::uint32_t corner = 0; corner < 3 * 40; ++corner) {
    mesh.indices.push_back(corner);
    mesh.positions.push_back(glm::vec3{coordinate(), coordinate(), coordinate()});  // braces: one after the other
  }
  return shuffled(joined(mesh, mesh), seed);
}

/// What an evaluator of scenes finds out.
inline Findings evaluate(const Plugin& plugin, const Scene& scene, const Settings& settings, int threads = 2) {
  const Technique technique = plugin.create(settings);
  RunFixture fixture;
  const Executor executor(threads);
  Run run{fixture.analyses, executor, fixture.findings, fixture.views};
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, run);
  return fixture.findings;
}

/// The figure of a draw, or of the scene; null where there is none.
inline const Measured* find(const Findings& findings, const std::string& metric, std::optional<DrawId> draw) {
  for (const Measured& measured : findings.measured) {
    if (measured.metric == metric && measured.about.draw == draw) return &measured;
  }
  return nullptr;
}

}  // namespace foredraw::testing
