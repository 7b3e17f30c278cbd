#include <foredraw/analysis/texture_places.h>

#include <cmath>

namespace foredraw {

namespace {

struct Turn {
  double sine, cosine;
};

/// By their series, because what a library says may depend on the processor in the last bit.
Turn turn_by(double angle) {
  constexpr double circle = 6.283185307179586;
  if (!std::isfinite(angle)) return {0, 1};
  const double x = angle - circle * std::floor(angle / circle + 0.5);
  Turn turn{0, 0};
  double term = 1;
  for (int n = 0; n < 40; ++n) {  // x is below 4
    double& sum = n % 2 == 0 ? turn.cosine : turn.sine;
    sum += n % 4 < 2 ? term : -term;
    term *= x / (n + 1);
  }
  return turn;
}

}  // namespace

std::vector<glm::dvec2> texture_places(const VertexStream& texcoords, const Texture& texture) {
  const Turn turn = turn_by(texture.rotation);
  std::vector<glm::dvec2> places;
  for (const glm::vec3& texcoord : decode_vec3(texcoords)) {
    const glm::dvec2 scaled = texture.scale * glm::dvec2(texcoord);
    places.push_back(texture.offset + glm::dvec2(turn.cosine * scaled.x + turn.sine * scaled.y,
                                                 turn.cosine * scaled.y - turn.sine * scaled.x));
  }
  return places;
}

}  // namespace foredraw
