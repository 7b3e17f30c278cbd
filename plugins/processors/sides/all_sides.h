#pragma once
// A subject with every side of its double-sided parts apart, so that each can be drawn, missed or asked for by itself.

#include "sides.h"

#include <foredraw/viewing/raster_part.h>

#include <span>
#include <vector>

namespace foredraw::sides {

/// [part][triangle]
using SidesOfParts = std::vector<std::vector<Side>>;

/// A subject in a pose. Fronts come first, part by part; then the backs of those parts that draw them. The geometry
/// need not
/// outlive it.
class AllSides {
 public:
  explicit AllSides(std::span<const RasterPart> parts);

  /// Single-sided ones, in which triangles are numbered through.
  std::span<const PreparedPart> parts() const { return prepared_; }

  struct Place {
    std::size_t part = 0;  ///< of the subject
    std::size_t triangle = 0;
    Side side = front;
  };
  Place place_of(std::uint32_t number) const;
  std::size_t count() const { return first_.back(); }           ///< of all sides
  std::uint32_t first_back() const { return first_[fronts_]; }  ///< those from there on are backs

 private:
  std::vector<PreparedPart> prepared_;
  std::vector<std::pair<std::size_t, Side>> what_;  ///< [part of parts()]
  std::size_t fronts_ = 0;                          ///< parts of parts() that show fronts
  std::vector<std::uint32_t> first_{0};             ///< [part of parts()] its first number; and the end
};

}  // namespace foredraw::sides
