#include "plain_peer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foredraw::bench {

namespace {

/// A number from 0 to 1 as a shader gets it back.
double unorm(double value, int bits) {
  return meshopt_quantizeUnorm(static_cast<float>(value), bits) / (std::ldexp(1.0, bits) - 1);
}

double snorm(double value, int bits) {
  return meshopt_quantizeSnorm(static_cast<float>(value), bits) / (std::ldexp(1.0, bits - 1) - 1);
}

double largest_angle(const VertexStream* stream) {
  double most = 0;
  for (const glm::vec3& value : stream == nullptr ? std::vector<glm::vec3>() : decode_vec3(*stream)) {
    const glm::dvec3 wanted = glm::normalize(glm::dvec3(value));
    const glm::dvec3 is(snorm(wanted.x, 8), snorm(wanted.y, 8), snorm(wanted.z, 8));
    const double angle = std::atan2(glm::length(glm::cross(wanted, is)), glm::dot(wanted, is));
    if (std::isfinite(angle)) most = std::max(most, angle);
  }
  return most * 180 / std::numbers::pi;
}

struct Extent {
  glm::dvec3 least{1e300}, most{-1e300};
  explicit Extent(const std::vector<glm::vec3>& values) {
    for (const glm::dvec3 value : values) least = glm::min(least, value), most = glm::max(most, value);
  }
  glm::dvec3 size() const { return most - least; }
};

}  // namespace

PeerErrors peer_errors(const VertexStreams& vertices) {
  PeerErrors errors;
  const std::vector<glm::vec3> positions = decode_vec3(*vertices.find("POSITION"));
  const Extent box(positions);
  const double scale = std::max({box.size().x, box.size().y, box.size().z});
  for (const glm::dvec3 position : positions) {
    glm::dvec3 is;
    for (int c = 0; c < 3; ++c) is[c] = box.least[c] + scale * unorm((position[c] - box.least[c]) / scale, 14);
    errors.position = std::max(errors.position, glm::length(is - position));
  }
  errors.normal = largest_angle(vertices.find("NORMAL"));
  errors.tangent = largest_angle(vertices.find("TANGENT"));
  if (const VertexStream* stream = vertices.find("TEXCOORD_0")) {
    const std::vector<glm::vec3> uvs = decode_vec3(*stream);
    const Extent square(uvs);
    for (const glm::dvec3 uv : uvs) {
      for (int c = 0; c < 2; ++c) {
        const double size = square.size()[c], part = size > 0 ? (uv[c] - square.least[c]) / size : 0;
        errors.uv = std::max(errors.uv, std::abs(square.least[c] + size * unorm(part, 12) - uv[c]));
      }
    }
  }
  return errors;
}

}  // namespace foredraw::bench
