#pragma once
// A subject with every side of its double-sided parts apart, so that each can be drawn, missed or asked for by itself.

#include "sides.h"

#include <foredraw/scene/subject.h>
#include <foredraw/viewing/raster_part.h>

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace foredraw::processors::sides {

/// [part][triangle]
using SidesOfParts = std::vector<std::vector<Side>>;

/// A subject in a pose. Its sides are numbered: fronts first, part by part; then the backs of those parts that draw
/// them. The geometry need not outlive it.
class AllSides {
 public:
  explicit AllSides(std::span<const RasterPart> parts);

  /// Fragments have the numbers of their sides.
  std::span<const PreparedPart> parts() const { return prepared_; }

  struct Place {
    std::size_t part = 0;  ///< of the subject
    std::size_t triangle = 0;
    Side side = front;
  };
  Place place_of(std::uint32_t number) const;
  std::size_t count() const { return first_.back(); }  ///< of all sides
  /// [side] 1 for those in `some`.
  std::vector<std::uint8_t> among(const SidesOfParts& some) const;
  std::uint32_t first_back() const { return first_[fronts_]; }  ///< those from there on are backs

 private:
  std::vector<PreparedPart> prepared_;
  std::vector<std::pair<std::size_t, Side>> what_;  ///< [run of numbers]
  std::size_t fronts_ = 0;                          ///< runs that are fronts
  std::vector<std::uint32_t> first_{0};             ///< [run of numbers] its first one; and the end
};

/// What is wanted ([draw][triangle]) of each part of a subject; of parts of other draws, all that they draw.
SidesOfParts sides_of_parts(const Subject& subject, std::span<const RasterPart> parts,
                            const std::map<DrawId, std::vector<Side>>& wanted);

/// What is nearest in each pixel of a picture: of equally near sides the first by number.
struct NearestSides {
  static constexpr std::uint32_t nothing = ~std::uint32_t{0};

  explicit NearestSides(std::size_t pixels) : depths(pixels, nothing), sides(pixels, nothing) {}

  std::vector<std::uint32_t> depths, sides;  ///< [pixel]

  void add(std::uint32_t pixel, std::uint32_t depth, std::uint32_t side) {
    if (depth > depths[pixel] || (depth == depths[pixel] && side > sides[pixel])) return;
    depths[pixel] = depth;
    sides[pixel] = side;
  }
};

}  // namespace foredraw::processors::sides
