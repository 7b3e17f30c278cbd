#pragma once
// Scenes of images alone, made on the spot.

#include <foredraw/analysis/analyses.h>
#include <foredraw/image/alpha_image.h>
#include <foredraw/scene/scene.h>

#include <string>
#include <vector>

namespace foredraw::testing {

/// An image whose bytes are its texels (of 8 or 16 bits), for `stored_texels` to decode.
Image texel_image(const ImageFacts& facts, const std::vector<std::uint16_t>& values);

/// A grey image with this alpha, of 16 bits.
Image texel_image(const AlphaImage& alpha);

/// The decoder of such images.
ImageDecoder stored_texels();

/// One blended draw, its mesh and its node: a quad that shows all of the image, a unit a texel, upright, the image's
/// upper left corner at the origin and y upwards. Its frame is the image, which is clamped.
Scene sprite_scene(Image image, std::string name = "sprite");

}  // namespace foredraw::testing
