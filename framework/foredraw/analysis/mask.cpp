#include <foredraw/analysis/mask.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace foredraw {

namespace {

constexpr std::int64_t steps = 256;  ///< in a texel

std::int64_t remainder(std::int64_t number, std::int64_t divisor) {
  const std::int64_t rest = number % divisor;
  return rest < 0 ? rest + divisor : rest;
}

std::uint32_t wrapped(std::int64_t texel, std::uint32_t count, Wrap wrap) {
  const std::int64_t edge = count;
  if (wrap == Wrap::clamped) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(texel, 0, edge - 1));
  if (wrap == Wrap::repeat) return static_cast<std::uint32_t>(remainder(texel, edge));
  const std::int64_t there_and_back = remainder(texel, 2 * edge);
  return static_cast<std::uint32_t>(std::min(there_and_back, 2 * edge - 1 - there_and_back));
}

/// In steps from the image's edge. What is not finite, or so far off that nothing is to be told there, lies at 0.
std::int64_t in_steps(double place, std::uint32_t texels) {
  constexpr double far_off = 1 << 20;
  if (!(std::abs(place) < far_off)) return 0;
  return static_cast<std::int64_t>(std::floor(place * texels * steps + 0.5));
}

}  // namespace

double alpha_at(const Mask& mask, const glm::dvec2& place) {
  if (!mask.image) return 1;
  const AlphaImage& image = *mask.image;
  const auto texel = [&](std::int64_t x, std::int64_t y) {
    return std::int64_t{image.alpha[std::size_t{wrapped(y, image.height, mask.wrap[1])} * image.width +
                                    wrapped(x, image.width, mask.wrap[0])]};
  };
  std::int64_t x = in_steps(place.x, image.width);
  std::int64_t y = in_steps(place.y, image.height);
  constexpr double most = 65535;
  if (mask.is_nearest) return static_cast<double>(texel(x >> 8, y >> 8)) / most;
  x -= steps / 2;
  y -= steps / 2;
  const std::int64_t right = x & (steps - 1), down = y & (steps - 1);
  x >>= 8;
  y >>= 8;
  const std::int64_t upper = texel(x, y) * (steps - right) + texel(x + 1, y) * right;
  const std::int64_t lower = texel(x, y + 1) * (steps - right) + texel(x + 1, y + 1) * right;
  return static_cast<double>(upper * (steps - down) + lower * down) / (steps * steps * most);
}

MaskedTriangle::MaskedTriangle(const Mask& mask, const Camera& camera, const std::array<std::uint32_t, 3>& vertices,
                               const std::array<Corner, 3>& corners)
    : mask_(mask), vertices_(vertices), corners_(corners) {
  // In a sequence that does not depend on how they are numbered, so that sums are rounded alike.
  const auto exchange_unless_sorted = [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) { return std::tie(corners_[i].x, corners_[i].y, corners_[i].depth); };
    if (key(a) <= key(b)) return;
    std::swap(corners_[a], corners_[b]);
    std::swap(vertices_[a], vertices_[b]);
  };
  exchange_unless_sorted(0, 1);
  exchange_unless_sorted(1, 2);
  exchange_unless_sorted(0, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    scales_[i] = camera.is_perspective() ? 1 / (camera.steps_before_sphere() + corners_[i].depth) : 1;
  }
}

bool MaskedTriangle::is_there(std::int32_t x, std::int32_t y) const {
  const Corner point = {x, y, 0};
  std::array<double, 3> shares;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t area = doubled_area(corners_[(i + 1) % 3], corners_[(i + 2) % 3], point);
    shares[i] = static_cast<double>(std::abs(area)) * scales_[i];
  }
  const double sum = shares[0] + shares[1] + shares[2];
  // From the first corner on, so that where all are alike the point is too.
  const std::uint32_t first = vertices_[0];
  glm::dvec2 place = mask_.image ? mask_.places[first] : glm::dvec2(0);
  double alpha = mask_.alphas[first];
  for (std::size_t i = 1; i < 3; ++i) {
    const double share = shares[i] / sum;
    if (mask_.image) place += share * (mask_.places[vertices_[i]] - mask_.places[first]);
    alpha += share * (mask_.alphas[vertices_[i]] - mask_.alphas[first]);
  }
  return alpha * alpha_at(mask_, place) >= mask_.cutoff;
}

}  // namespace foredraw
