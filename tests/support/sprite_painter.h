#pragma once
// Sprites painted the plain way, pixel by pixel: a second opinion on what fills and what shows.

#include <foredraw/image/alpha_image.h>
#include <foredraw/image/texture_uv.h>
#include <foredraw/scene/scene.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::testing {

enum class SpriteFilter { nearest, bilinear, trilinear };

/// Where and how a sprite is painted: its image scaled (pixels a texel), turned (radians) about its upper left corner,
/// and moved (pixels).
struct SpriteStand {
  double scale = 1;
  double angle = 0;
  glm::dvec2 offset{0};
  SpriteFilter filter = SpriteFilter::bilinear;
};

struct PaintedPixel {
  double alpha = 0;
  int times = 0;  ///< triangles that cover it
};

/// By column and row; pixels that nothing covers are not there.
using SpritePicture = std::map<std::array<std::int64_t, 2>, PaintedPixel>;

inline std::vector<AlphaImage> levels_of(AlphaImage image) {
  std::vector<AlphaImage> levels{std::move(image)};
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(next_level(levels.back()));
  return levels;
}

/// The alpha at a place of the image, as wide a step apart as the scale says.
inline double painted_alpha(std::span<const AlphaImage> levels, std::array<Wrap, 2> wrap, const SpriteStand& stand,
                            const glm::dvec2& place) {
  const Sampling sampling{wrap, stand.filter == SpriteFilter::nearest};
  if (stand.filter != SpriteFilter::trilinear || stand.scale >= 1) return alpha_at(levels[0], sampling, place);
  const double most = static_cast<double>(levels.size() - 1);
  const double level = std::min(most, std::floor(-std::log2(stand.scale) * 256 + 0.5) / 256);
  const double first = std::floor(level);
  const double fine = alpha_at(levels[static_cast<std::size_t>(first)], sampling, place);
  if (level == first) return fine;
  const double coarse = alpha_at(levels[static_cast<std::size_t>(first) + 1], sampling, place);
  return fine + (coarse - fine) * (level - first);
}

/// Whether a triangle (in 1/256 pixel) holds the centre of a pixel. One that lies on an edge is thought a very little
/// to the right, and far less than that down: the rule by which each centre belongs to one of two triangles with that
/// edge.
inline bool holds_centre(const std::array<std::array<std::int64_t, 2>, 3>& corners,
                         const std::array<std::int64_t, 2>& pixel) {
  const std::array<__int128, 2> centre = {256 * pixel[0] + 128, 256 * pixel[1] + 128};
  int right = 0, left = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % 3];
    const __int128 x = b[0] - a[0], y = b[1] - a[1];
    __int128 side = x * (centre[1] - a[1]) - y * (centre[0] - a[0]);
    if (side == 0) side = -y;
    if (side == 0) side = x;
    right += side > 0;
    left += side < 0;
  }
  return right == 3 || left == 3;
}

/// Paints triangles whose corners lie at `places` in the image, (0, 0) upper left, (1, 1) lower right.
inline SpritePicture painted(std::span<const glm::dvec2> places, std::span<const std::uint32_t> indices,
                             std::span<const AlphaImage> levels, std::array<Wrap, 2> wrap, const SpriteStand& stand) {
  const double sine = std::sin(stand.angle), cosine = std::cos(stand.angle);
  const double width = levels[0].width, height = levels[0].height;
  SpritePicture picture;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    std::array<std::array<std::int64_t, 2>, 3> corners;
    std::array<std::int64_t, 2> least, most;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 at = places[indices[t + i]] * glm::dvec2(width, height) * stand.scale;
      const glm::dvec2 pixel = glm::dvec2(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y) + stand.offset;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double in_pixels = axis == 0 ? pixel.x : pixel.y;
        const auto whole = static_cast<std::int64_t>(std::floor(in_pixels));
        corners[i][axis] = static_cast<std::int64_t>(std::floor(in_pixels * 256 + 0.5));
        least[axis] = i == 0 ? whole - 1 : std::min(least[axis], whole - 1);
        most[axis] = i == 0 ? whole + 1 : std::max(most[axis], whole + 1);
      }
    }
    for (std::int64_t y = least[1]; y <= most[1]; ++y) {
      for (std::int64_t x = least[0]; x <= most[0]; ++x) {
        if (!holds_centre(corners, {x, y})) continue;
        PaintedPixel& pixel = picture[{x, y}];
        if (pixel.times++ > 0) continue;
        const double right = static_cast<double>(x) + 0.5 - stand.offset.x;
        const double down = static_cast<double>(y) + 0.5 - stand.offset.y;
        const glm::dvec2 place((cosine * right + sine * down) / stand.scale / width,
                               (cosine * down - sine * right) / stand.scale / height);
        pixel.alpha = painted_alpha(levels, wrap, stand, place);
      }
    }
  }
  return picture;
}

/// Paints a draw as its material's texture is laid onto it.
inline SpritePicture painted(const Scene& scene, const Draw& draw, std::span<const AlphaImage> levels,
                             const SpriteStand& stand) {
  const Material* material = scene.material_of(draw);
  if (material == nullptr || !material->base_colour) throw std::runtime_error(draw.name + " has no texture");
  const Texture& texture = *material->base_colour;
  const VertexStream* texcoords = draw.levels[0].vertices->find("TEXCOORD_" + std::to_string(texture.texcoord));
  if (texcoords == nullptr) throw std::runtime_error(draw.name + " has no texture coordinates");
  return painted(texture_uv(*texcoords, texture), draw.levels[0].orders[0].indices.view(), levels, texture.wrap, stand);
}

/// The pixels that show (with more alpha than the threshold) in one picture, and in the other show otherwise, more
/// often or less, or not at all.
inline std::size_t differing_pixels(const SpritePicture& a, const SpritePicture& b, double threshold) {
  std::size_t differing = 0;
  const auto compare = [&](const SpritePicture& from, const SpritePicture& to, bool counts_both) {
    for (const auto& [at, pixel] : from) {
      if (!(pixel.alpha > threshold)) continue;
      const auto found = to.find(at);
      if (found == to.end()) {
        ++differing;
      } else if (counts_both && (found->second.alpha != pixel.alpha || found->second.times != pixel.times)) {
        ++differing;
      }
    }
  };
  compare(a, b, true);
  compare(b, a, false);
  return differing;
}

}  // namespace foredraw::testing
