#pragma once
// Sprites drawn as tight polygons in place of quads.

#include "texel_grid.h"

#include <foredraw/image/alpha_image.h>

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace foredraw {

namespace processors::particle_trim {

enum class Footprint : std::uint8_t {
  texels,          ///< the texels themselves: right where nothing is blended
  bilinear_loose,  ///< whatever blends with a texel that shows: half a texel more on each side
  bilinear,        ///< where the blend exceeds the threshold
};

/// How texture coordinates are stored.
enum class UvFormat : std::uint8_t { float32, float16, unorm16 };

class ShownImage;  // footprint.h

}  // namespace processors::particle_trim

enum class TrimMethod : std::uint8_t { optimal, persson };

/// The direction in which polygons run, as seen in the image.
enum class TrimWinding : std::uint8_t { as_before, clockwise, counter_clockwise };

struct ParticleTrimOptions {
  int vertices = 8;  ///< of a polygon, at most; 3 to 16
  TrimMethod method = TrimMethod::optimal;
  double threshold = 0;  ///< what is above it shows; 0 to 1
  AlphaChannel channel = AlphaChannel::alpha;
  processors::particle_trim::Footprint footprint = processors::particle_trim::Footprint::bilinear;
  int mip_levels = 2;  ///< smaller versions of the image that may be sampled; 0 to 14
  double padding = 0;  ///< texels more on each side; 0 to 64
  processors::particle_trim::UvFormat uv = processors::particle_trim::UvFormat::float32;
  TrimWinding winding = TrimWinding::as_before;  ///< as the quad's
  double least_saving = 0.05;                    ///< of the frame, below which a sprite stays as it is; 0 to 1
  int hull_edges = 24;                           ///< of method persson: to which the hull is reduced first; 3 to 32
};

/// A part of an image that is drawn by itself: upright, in 1/256 texel from the image's upper left corner, y down.
using TrimFrame = processors::particle_trim::Box;

struct TrimmedSprite {
  enum class Outcome : std::uint8_t {
    trimmed,    ///< to a polygon of as many vertices as were asked for, or fewer
    rectangle,  ///< no polygon keeps clear of what shows beside the frame: the upright rectangle
    empty,      ///< nothing shows
    full,       ///< all of it shows
    no_saving,  ///< too little would be saved
  };
  Outcome outcome = Outcome::trimmed;
  std::vector<glm::dvec2>
      corners;               ///< texture coordinates as they are stored, clockwise on a screen; empty: the frame stays
  double area = 0;           ///< of what is drawn, in texels
  double frame_area = 0;     ///< in texels
  std::uint64_t texels = 0;  ///< that were checked
  double lost = 0;  ///< the largest value that may show in the frame outside of the polygon, at most the threshold
};

/// A polygon for each frame, of equal shape where there are several. Every place in a frame at which the image,
/// sampled, is above the threshold lies in the frame's polygon as it is stored, and every such place outside of the
/// frame lies outside of it: shown in whole numbers afterwards. O(texels) and the search. Source: Persson, "Graphics
/// Gems for Games", SIGGRAPH 2012, "Particle trimming"; the smallest polygon after DePano 1987.
std::vector<TrimmedSprite> particle_trim(const AlphaImage& image, const Sampling& sampling,
                                         std::span<const TrimFrame> frames, const ParticleTrimOptions& options = {});

/// The same for an image that is asked about several times: processors::particle_trim::ShownImage(image, sampling,
/// processors::particle_trim::footprint_of(options)).
std::vector<TrimmedSprite> particle_trim(const processors::particle_trim::ShownImage& image,
                                         std::span<const TrimFrame> frames, const ParticleTrimOptions& options = {});

struct Plugin;
Plugin particle_trim_plugin();

}  // namespace foredraw
