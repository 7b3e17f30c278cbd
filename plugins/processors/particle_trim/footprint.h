#pragma once
// Where an image shows: the places at which its sampler finds more than a threshold.

#include "convex_hull.h"
#include "particle_trim.h"

#include <foredraw/image/alpha_image.h>

#include <memory>
#include <mutex>

namespace foredraw::processors::particle_trim {

struct FootprintOptions {
  double threshold = 0;  ///< what is above it shows; 0 to 1
  Footprint footprint = Footprint::bilinear;
  int mip_levels = 0;  ///< smaller versions of the image that may be sampled as well
  double padding = 0;  ///< texels more on each side
};

/// What the options say of how an image shows.
FootprintOptions footprint_of(const ParticleTrimOptions& options);

class ShownCells;

/// An image that is drawn in parts.
class ShownImage {
 public:
  /// The image has to stay.
  ShownImage(const AlphaImage& image, const Sampling& sampling, const FootprintOptions& options);
  ~ShownImage();

  /// Points in the frame round all that shows there: every place at which it shows lies in their convex hull. Those of
  /// each row of texels; none where nothing shows.
  std::vector<Point> shown_points(const Box& frame) const;

  /// Which half texels of the image show; found on the first ask.
  const ShownCells& cells() const;

  const AlphaImage& image() const { return image_; }
  /// The image itself, and then the smaller versions that may be sampled.
  std::size_t levels() const { return 1 + smaller_.size(); }
  const AlphaImage& level(std::size_t i) const { return i == 0 ? image_ : smaller_[i - 1]; }
  const Sampling& sampling() const { return sampling_; }
  const FootprintOptions& options() const { return options_; }

  /// Whether texels blend with their neighbours.
  bool is_blended() const { return options_.footprint != Footprint::texels && !sampling_.is_nearest; }
  /// As in the image: what is above it shows.
  std::uint16_t limit() const { return limit_; }

 private:
  const AlphaImage& image_;
  std::vector<AlphaImage> smaller_;
  Sampling sampling_;
  FootprintOptions options_;
  std::uint16_t limit_;
  mutable std::once_flag finding_cells_;
  mutable std::unique_ptr<const ShownCells> cells_;
};

/// The corners of the hull of what shows in a frame, with the padding and what samplers and rasterisers round off round
/// it, as far as it lies in the frame.
std::vector<Point> padded_hull(const std::vector<Point>& shown, const Box& frame, const FootprintOptions& options);

}  // namespace foredraw::processors::particle_trim
