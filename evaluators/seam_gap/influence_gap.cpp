#include "influence_gap.h"

#include <foredraw/analysis/welded_positions.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace foredraw {

namespace {

constexpr double same_weight = 1e-6;

struct Influence {
  float joint;
  double weight;
};

/// Of a vertex: each joint once, by its number, with a share of 1; none without weights.
std::vector<Influence> influences(const VertexStreams& vertices, std::size_t vertex) {
  std::vector<Influence> all;
  double sum = 0;
  for (int set = 0;; ++set) {
    const VertexStream* joints = vertices.find("JOINTS_" + std::to_string(set));
    const VertexStream* weights = vertices.find("WEIGHTS_" + std::to_string(set));
    if (joints == nullptr || weights == nullptr) break;
    for (std::size_t c = 0; c < std::min(joints->format.components, weights->format.components); ++c) {
      const double weight = decode_component(*weights, vertex, c);
      if (!(weight > 0) || !std::isfinite(weight)) continue;
      const float joint = decode_component(*joints, vertex, c);
      const auto same = std::ranges::find(all, joint, &Influence::joint);
      if (same == all.end()) {
        all.push_back({joint, weight});
      } else {
        same->weight += weight;
      }
      sum += weight;
    }
  }
  for (Influence& one : all) one.weight /= sum;
  std::ranges::sort(all, {}, &Influence::joint);
  return all;
}

bool is_equal(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  const auto weight_in = [](const std::vector<Influence>& of, float joint) {
    const auto found = std::ranges::lower_bound(of, joint, {}, &Influence::joint);
    return found != of.end() && found->joint == joint ? found->weight : 0;
  };
  const auto holds = [&](const std::vector<Influence>& one, const std::vector<Influence>& other) {
    return std::ranges::all_of(
        one, [&](const Influence& of) { return std::abs(of.weight - weight_in(other, of.joint)) <= same_weight; });
  };
  return holds(a, b) && holds(b, a);
}

struct AtPoint {
  std::size_t vertices = 0;
  std::vector<Influence> first;
  bool is_unequal = false;
};

}  // namespace

InfluenceGap influence_gap(std::span<const VertexStreams* const> parts) {
  std::vector<glm::vec3> positions;
  for (const VertexStreams* part : parts) {
    if (part->find("JOINTS_0") == nullptr) continue;
    const std::vector<glm::vec3> own = decode_vec3(*part->find("POSITION"));
    positions.insert(positions.end(), own.begin(), own.end());
  }
  const std::vector<std::uint32_t> point = welded(positions);
  std::vector<std::uint32_t> vertices(positions.size(), 0);
  for (const std::uint32_t at : point) ++vertices[at];
  std::vector<AtPoint> at(positions.size());
  std::size_t vertex = 0;
  for (const VertexStreams* part : parts) {
    if (part->find("JOINTS_0") == nullptr) continue;
    for (std::size_t v = 0; v < part->count; ++v, ++vertex) {
      if (vertices[point[vertex]] < 2) continue;
      AtPoint& of = at[point[vertex]];
      std::vector<Influence> own = influences(*part, v);
      if (of.vertices++ == 0) {
        of.first = std::move(own);
      } else {
        of.is_unequal = of.is_unequal || !is_equal(of.first, own);
      }
    }
  }
  InfluenceGap gap;
  for (const AtPoint& of : at) {
    if (of.vertices < 2) continue;
    ++gap.shared;
    if (of.is_unequal) ++gap.unequal;
  }
  return gap;
}

}  // namespace foredraw
