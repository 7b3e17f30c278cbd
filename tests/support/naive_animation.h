#pragma once
// A second opinion on posed positions: everything in doubles and written the long way round. Arcs and sines for
// rotations, de Casteljau for splines, parents climbed from each node, points moved by each joint in turn.

#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace foredraw::testing {

class NaiveAnimation {
 public:
  NaiveAnimation(const Scene& scene, const Pose& pose) : scene_(scene), pose_(pose) {}

  std::vector<glm::dvec3> positions(const SubjectPart& part) const {
    const VertexStreams& vertices = *scene_.draws[part.draw].levels[0].vertices;
    const Node& node = scene_.nodes[*part.node];
    const std::vector<double> weights = morph_weights(*part.node);
    std::vector<glm::dvec3> positions;
    for (std::size_t v = 0; v < vertices.count; ++v) {
      Point p = point(*vertices.find("POSITION"), v);
      for (std::size_t target = 0; target < weights.size() && target < vertices.morph_targets.size(); ++target) {
        for (const VertexStream& stream : vertices.morph_targets[target]) {
          if (stream.semantic != "POSITION") continue;
          const Point offset = point(stream, v);
          for (std::size_t i = 0; i < 3; ++i) p[i] += weights[target] * offset[i];
        }
      }
      p = node.skin ? by_joints(p, vertices, v, scene_.skins[*node.skin], *part.node) : to_world(*part.node, p);
      positions.emplace_back(p[0], p[1], p[2]);
    }
    return positions;
  }

 private:
  using Point = std::array<double, 3>;
  using Numbers = std::vector<double>;

  static Point point(const VertexStream& stream, std::size_t v) {
    return {decode_component(stream, v, 0), decode_component(stream, v, 1), decode_component(stream, v, 2)};
  }

  Point by_joints(const Point& p, const VertexStreams& vertices, std::size_t v, const Skin& skin, NodeId node) const {
    Point sum{};
    double all = 0;
    for (const char* set : {"0", "1"}) {
      const VertexStream* joints = vertices.find(std::string("JOINTS_") + set);
      const VertexStream* weights = vertices.find(std::string("WEIGHTS_") + set);
      if (joints == nullptr || weights == nullptr) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto joint = static_cast<std::size_t>(decode_component(*joints, v, c));
        const double weight = decode_component(*weights, v, c);
        if (weight == 0) continue;
        const Point moved = to_world(skin.joints[joint], by_matrix(skin.inverse_bind_matrices[joint], p));
        for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * moved[i];
        all += weight;
      }
    }
    if (all == 0) return to_world(node, p);
    for (double& s : sum) s /= all;
    return sum;
  }

  static Point by_matrix(const glm::mat4& m, const Point& p) {
    Point result;
    for (int row = 0; row < 3; ++row) {
      result[static_cast<std::size_t>(row)] = static_cast<double>(m[0][row]) * p[0] +
                                              static_cast<double>(m[1][row]) * p[1] +
                                              static_cast<double>(m[2][row]) * p[2] + static_cast<double>(m[3][row]);
    }
    return result;
  }

  Point to_world(NodeId node, Point p) const {
    p = to_parent(node, p);
    for (NodeId parent = 0; parent < scene_.nodes.size(); ++parent) {
      for (const NodeId child : scene_.nodes[parent].children) {
        if (child == node) return to_world(parent, p);
      }
    }
    return p;
  }

  Point to_parent(NodeId id, const Point& p) const {
    const Node& node = scene_.nodes[id];
    if (node.matrix) return by_matrix(*node.matrix, p);
    const glm::vec3& t = node.transform.translation;
    const glm::vec3& s = node.transform.scale;
    const glm::quat& r = node.transform.rotation;
    const Numbers move = animated(id, AnimatedPath::translation, {t.x, t.y, t.z});
    const Numbers size = animated(id, AnimatedPath::scale, {s.x, s.y, s.z});
    const Numbers q = animated(id, AnimatedPath::rotation, {r.x, r.y, r.z, r.w});
    // v + 2 q x (q x v + w v)
    const Point v{size[0] * p[0], size[1] * p[1], size[2] * p[2]};
    const Point axis{q[0], q[1], q[2]};
    Point inner = cross(axis, v);
    for (std::size_t i = 0; i < 3; ++i) inner[i] += q[3] * v[i];
    const Point turn = cross(axis, inner);
    return {v[0] + 2 * turn[0] + move[0], v[1] + 2 * turn[1] + move[1], v[2] + 2 * turn[2] + move[2]};
  }

  static Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Numbers morph_weights(NodeId id) const {
    const Node& node = scene_.nodes[id];
    std::vector<float> rest = node.weights;
    if (rest.empty() && node.mesh) rest = scene_.meshes[*node.mesh].weights;
    return animated(id, AnimatedPath::weights, Numbers(rest.begin(), rest.end()));
  }

  Numbers animated(NodeId node, AnimatedPath path, Numbers value) const {
    if (!pose_.clip) return value;
    for (const AnimationChannel& channel : scene_.animations[*pose_.clip].channels) {
      if (channel.node == node && channel.path == path) value = sampled(channel);
    }
    return value;
  }

  Numbers sampled(const AnimationChannel& channel) const {
    const auto times = channel.times.view();
    const bool is_cubic = channel.interpolation == Interpolation::cubic_spline;
    const std::size_t in_key = channel.values.size() / times.size();
    const std::size_t width = is_cubic ? in_key / 3 : in_key;
    const auto value = [&](std::size_t key, std::size_t which) {
      const auto from = channel.values.view().subspan(key * in_key + which * width, width);
      return Numbers(from.begin(), from.end());
    };
    const std::size_t middle = is_cubic ? 1 : 0;
    if (pose_.time <= static_cast<double>(times.front())) return finished(channel, value(0, middle));
    if (pose_.time >= static_cast<double>(times.back())) return finished(channel, value(times.size() - 1, middle));
    std::size_t key = 0;
    while (static_cast<double>(times[key + 1]) <= pose_.time) ++key;
    const double before = times[key];
    const double seconds = static_cast<double>(times[key + 1]) - before;
    const double t = (pose_.time - before) / seconds;
    const Numbers a = value(key, middle);
    const Numbers b = value(key + 1, middle);
    if (channel.interpolation == Interpolation::step) return finished(channel, a);
    if (!is_cubic && channel.path == AnimatedPath::rotation) return turned(unit(a), unit(b), t);
    Numbers result;
    for (std::size_t i = 0; i < width; ++i) {
      if (is_cubic) {  // the curve's control points, then the middle of middles
        const double p1 = a[i] + value(key, 2)[i] * seconds / 3;
        const double p2 = b[i] - value(key + 1, 0)[i] * seconds / 3;
        const auto mix = [t](double x, double y) { return x * (1 - t) + y * t; };
        const double q0 = mix(a[i], p1), q1 = mix(p1, p2), q2 = mix(p2, b[i]);
        result.push_back(mix(mix(q0, q1), mix(q1, q2)));
      } else {
        result.push_back(a[i] * (1 - t) + b[i] * t);
      }
    }
    return finished(channel, result);
  }

  static Numbers finished(const AnimationChannel& channel, const Numbers& value) {
    return channel.path == AnimatedPath::rotation ? unit(value) : value;
  }

  static Numbers unit(Numbers q) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& part : q) part /= length;
    return q;
  }

  static Numbers turned(const Numbers& a, const Numbers& b, double t) {
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double arc = std::acos(std::min(1.0, std::abs(cosine)));
    Numbers result = a;
    if (arc < 1e-7) return result;
    for (std::size_t i = 0; i < 4; ++i) {
      const double end = cosine < 0 ? -b[i] : b[i];
      result[i] = (std::sin(arc * (1 - t)) * a[i] + std::sin(arc * t) * end) / std::sin(arc);
    }
    return result;
  }

  const Scene& scene_;
  Pose pose_;
};

/// How far two opinions on a part are from each other, over the farthest distance from the origin (1 at least).
inline double difference(const std::vector<glm::vec3>& positions, const std::vector<glm::dvec3>& naive) {
  if (positions.size() != naive.size()) return INFINITY;
  double largest = 0;
  double extent = 1;
  for (std::size_t v = 0; v < naive.size(); ++v) {
    for (int i = 0; i < 3; ++i) {
      largest = std::max(largest, std::abs(static_cast<double>(positions[v][i]) - naive[v][i]));
      extent = std::max(extent, std::abs(naive[v][i]));
    }
  }
  return largest / extent;
}

}  // namespace foredraw::testing
