#pragma once
// Holes in a surface, as glTF's alpha mode MASK cuts them.

#include <foredraw/image/alpha_image.h>
#include <foredraw/viewing/camera.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace foredraw {

/// A surface is there where its alpha is `cutoff` or more: that of the image, times the vertices'.
struct Mask {
  std::shared_ptr<const AlphaImage> image;  ///< none: 1 everywhere
  Sampling sampling;
  std::vector<glm::dvec2> uv;  ///< [vertex] in the image, (0, 0) upper left, (1, 1) lower right
  std::vector<double> alphas;  ///< [vertex]
  double cutoff = 0.5;
};

/// A triangle in the picture. Whoever asks at the same point hears the same, whichever corner came first.
class MaskedTriangle {
 public:
  /// The corners' units are those of the points that will be asked for.
  MaskedTriangle(const Mask& mask, const Camera& camera, const std::array<std::uint32_t, 3>& vertices,
                 const std::array<Corner, 3>& corners);

  /// Whether the surface is there, at a point on the triangle.
  bool is_there(std::int32_t x, std::int32_t y) const;

 private:
  const Mask& mask_;
  std::array<std::uint32_t, 3> vertices_;
  std::array<Corner, 3> corners_;
  std::array<double, 3> scales_;  ///< of their shares: in perspective they fall with the distance
};

}  // namespace foredraw
