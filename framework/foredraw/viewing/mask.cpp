#include <foredraw/viewing/mask.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace foredraw {

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
  glm::dvec2 uv = mask_.image ? mask_.uv[first] : glm::dvec2(0);
  double alpha = mask_.alphas[first];
  for (std::size_t i = 1; i < 3; ++i) {
    const double share = shares[i] / sum;
    if (mask_.image) uv += share * (mask_.uv[vertices_[i]] - mask_.uv[first]);
    alpha += share * (mask_.alphas[vertices_[i]] - mask_.alphas[first]);
  }
  // Of the texels themselves, no smaller version of them.
  const double texture = mask_.image ? alpha_at(*mask_.image, mask_.sampling, uv) : 1;
  return alpha * texture >= mask_.cutoff;
}

}  // namespace foredraw
