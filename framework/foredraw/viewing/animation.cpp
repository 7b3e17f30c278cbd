#include <foredraw/viewing/animation.h>

#include <foredraw/viewing/slerp.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace foredraw {

namespace {

/// Values for each key: the cubic spline's are in-tangent, value, out-tangent.
std::size_t values_per_key(const AnimationChannel& channel) {
  return channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
}

/// Components of a value.
std::size_t width_of(const AnimationChannel& channel) {
  switch (channel.path) {
    case AnimatedPath::translation:
    case AnimatedPath::scale: return 3;
    case AnimatedPath::rotation: return 4;
    case AnimatedPath::weights: break;
  }
  return channel.times.empty() ? 0 : channel.values.size() / (channel.times.size() * values_per_key(channel));
}

/// A moment among a channel's keys.
struct Moment {
  std::size_t key = 0;  ///< the last one that is not later
  double part = 0;      ///< of the way to the next key, below 1
  double seconds = 0;   ///< between the two
};

Moment moment_of(std::span<const float> times, double time) {
  const auto later = std::upper_bound(times.begin(), times.end(), time);
  if (later == times.begin()) return {};
  const auto key = static_cast<std::size_t>(later - times.begin()) - 1;
  if (later == times.end()) return {key};
  const double seconds = static_cast<double>(*later) - static_cast<double>(times[key]);
  return {key, (time - static_cast<double>(times[key])) / seconds, seconds};
}

using Values = std::vector<double>;

/// `which`: of the values of a key, such as its out-tangent.
Values values_at(const AnimationChannel& channel, std::size_t key, std::size_t which) {
  const std::size_t width = width_of(channel);
  const auto values = channel.values.view().subspan((key * values_per_key(channel) + which) * width, width);
  return {values.begin(), values.end()};
}

glm::dquat unit_rotation(const Values& v) { return glm::normalize(glm::dquat(v[3], v[0], v[1], v[2])); }

Values between_linear(const AnimationChannel& channel, const Moment& at) {
  const Values from = values_at(channel, at.key, 0);
  const Values to = values_at(channel, at.key + 1, 0);
  if (channel.path == AnimatedPath::rotation) {
    const glm::dquat turned = slerp(unit_rotation(from), unit_rotation(to), at.part);
    return {turned.x, turned.y, turned.z, turned.w};
  }
  Values result;
  for (std::size_t i = 0; i < from.size(); ++i) result.push_back(from[i] + at.part * (to[i] - from[i]));
  return result;
}

/// glTF 2.0, appendix C.5: tangents are per second.
Values between_cubic(const AnimationChannel& channel, const Moment& at) {
  const Values from = values_at(channel, at.key, 1);
  const Values leaving = values_at(channel, at.key, 2);
  const Values arriving = values_at(channel, at.key + 1, 0);
  const Values to = values_at(channel, at.key + 1, 1);
  const double t = at.part;
  Values result;
  for (std::size_t i = 0; i < from.size(); ++i) {
    result.push_back((2 * t * t * t - 3 * t * t + 1) * from[i] + at.seconds * (t * t * t - 2 * t * t + t) * leaving[i] +
                     (3 * t * t - 2 * t * t * t) * to[i] + at.seconds * (t * t * t - t * t) * arriving[i]);
  }
  return result;
}

Values sampled(const AnimationChannel& channel, double time) {
  const Moment at = moment_of(channel.times.view(), time);
  const bool is_cubic = channel.interpolation == Interpolation::cubic_spline;
  if (at.part == 0 || channel.interpolation == Interpolation::step) return values_at(channel, at.key, is_cubic ? 1 : 0);
  return is_cubic ? between_cubic(channel, at) : between_linear(channel, at);
}

void apply(const AnimationChannel& channel, double time, Transform& transform, std::vector<float>& weights) {
  const Values v = sampled(channel, time);
  switch (channel.path) {
    case AnimatedPath::translation: transform.translation = glm::dvec3(v[0], v[1], v[2]); break;
    case AnimatedPath::scale: transform.scale = glm::dvec3(v[0], v[1], v[2]); break;
    case AnimatedPath::rotation: transform.rotation = glm::quat(unit_rotation(v)); break;
    case AnimatedPath::weights: weights.assign(v.begin(), v.end()); break;
  }
}

/// At rest: the node's own, else its mesh's.
std::vector<float> morph_weights(const Scene& scene, const Node& node) {
  if (!node.weights.empty() || !node.mesh) return node.weights;
  return scene.meshes[*node.mesh].weights;
}

/// Nodes as clips move them.
class MovedNodes {
 public:
  explicit MovedNodes(const Scene& scene) : scene_(scene) {
    for (const Node& node : scene.nodes) {
      transforms_.push_back(node.transform);
      nodes_.weights.push_back(morph_weights(scene, node));
    }
  }

  void play(const Animation& clip, double seconds) {
    for (const AnimationChannel& channel : clip.channels) {
      if (channel.node >= scene_.nodes.size() || !has_keys(channel)) continue;
      apply(channel, seconds, transforms_[channel.node], nodes_.weights[channel.node]);
    }
  }

  PosedNodes posed() {
    std::vector<glm::mat4> locals;
    for (std::size_t i = 0; i < transforms_.size(); ++i) {
      locals.push_back(scene_.nodes[i].matrix ? *scene_.nodes[i].matrix : transforms_[i].matrix());
    }
    nodes_.world = world_transforms(scene_, locals);
    return std::move(nodes_);
  }

 private:
  const Scene& scene_;
  std::vector<Transform> transforms_;
  PosedNodes nodes_;
};

}  // namespace

bool has_keys(const AnimationChannel& channel) {
  const std::size_t width = width_of(channel);
  return !channel.times.empty() && width > 0 &&
         channel.values.size() >= channel.times.size() * values_per_key(channel) * width;
}

PosedNodes posed_nodes(const Scene& scene, const Pose& pose) {
  MovedNodes nodes(scene);
  if (pose.clip && *pose.clip < scene.animations.size()) nodes.play(scene.animations[*pose.clip], pose.time);
  return nodes.posed();
}

PosedNodes posed_nodes_of_all_clips(const Scene& scene, double seconds) {
  MovedNodes nodes(scene);
  for (const Animation& clip : scene.animations) {
    float end = 0;
    for (const AnimationChannel& channel : clip.channels) {
      if (has_keys(channel)) end = std::max(end, channel.times.view().back());
    }
    const auto length = static_cast<double>(end);
    nodes.play(clip, length > 0 && seconds > length ? std::fmod(seconds, length) : seconds);
  }
  return nodes.posed();
}

}  // namespace foredraw
