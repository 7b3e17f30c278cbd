#include "prune.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

using Value = std::array<double, 4>;

/// What the node has at rest, in the sequence of the channel's values.
Value rest_of(const Node& node, AnimatedPath path) {
  const Transform& t = node.transform;
  if (path == AnimatedPath::rotation) return {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
  const glm::vec3& v = path == AnimatedPath::scale ? t.scale : t.translation;
  return {v.x, v.y, v.z, 0};
}

double distance(std::span<const float> value, const Value& rest, double sign) {
  double square = 0;
  for (std::size_t i = 0; i < value.size(); ++i) square += (value[i] - sign * rest[i]) * (value[i] - sign * rest[i]);
  return std::sqrt(square);
}

bool rests(const AnimationChannel& channel, const Node& node, const RestTolerances& tolerances) {
  if (channel.path == AnimatedPath::weights || channel.interpolation == Interpolation::cubic_spline || node.matrix) {
    return false;
  }
  const bool is_rotation = channel.path == AnimatedPath::rotation;
  const std::size_t parts = is_rotation ? 4 : 3;
  const double most = is_rotation                           ? tolerances.rotation
                      : channel.path == AnimatedPath::scale ? tolerances.scale
                                                            : tolerances.translation;
  if (channel.times.empty() || channel.values.size() != channel.times.size() * parts) return false;
  const Value rest = rest_of(node, channel.path);
  for (std::size_t k = 0; k < channel.times.size(); ++k) {
    const auto value = channel.values.view().subspan(k * parts, parts);
    const bool is_near =
        distance(value, rest, 1) <= most || (is_rotation && distance(value, rest, -1) <= most);  // the same rotation
    if (!is_near) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> resting_tracks(const Animation& animation, const std::vector<Node>& nodes,
                                 const RestTolerances& tolerances) {
  const std::vector<AnimationChannel>& channels = animation.channels;
  std::vector<bool> rest(channels.size());
  float end = -std::numeric_limits<float>::infinity(), left_end = end;
  const auto end_of = [](const AnimationChannel& channel) {
    return channel.times.empty() ? -std::numeric_limits<float>::infinity() : channel.times.view().back();
  };
  for (std::size_t c = 0; c < channels.size(); ++c) {
    rest[c] = channels[c].node < nodes.size() && rests(channels[c], nodes[channels[c].node], tolerances);
    end = std::max(end, end_of(channels[c]));
    if (!rest[c]) left_end = std::max(left_end, end_of(channels[c]));
  }
  for (std::size_t c = 0; c < channels.size() && left_end < end; ++c) {
    if (!rest[c] || end_of(channels[c]) < end) continue;
    rest[c] = false;
    left_end = end;
  }
  return rest;
}

}  // namespace foredraw
