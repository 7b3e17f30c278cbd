#pragma once
// Sections in a row, along something that may be a wire.

#include "section.h"

#include <functional>

namespace foredraw::processors::wire_radius {

struct ChainSection {
  Section section;
  glm::dvec3 axis{0};             ///< from one end of the chain to the other
  std::uint32_t triangle = none;  ///< one that it cuts
  double along = 0;               ///< the way to its centre from the first one's
};

struct Chain {
  std::vector<ChainSection> sections;
  bool closed = false;  ///< a ring: behind the last one comes the first one

  double length() const;  ///< of a ring all the way round
};

struct ChainLimits {
  double slender = 8;   ///< how many times as long as wide a wire is at least: what is too stout for it is not followed
  double aspect = 2.2;  ///< what is twice as flat is not followed
  double taper = 3;     ///< by which factor the half width may change from where it began, either way
  double steadiness = 0.25;  ///< by how much the half width may change over a step as long as itself
};

/// Follows sections from where it is put, as far as they stay alike. It remembers, for each triangle, in about which
/// directions it was cut already.
class ChainFollower {
 public:
  ChainFollower(const WeldedMesh& mesh, const ChainLimits& limits);

  /// The chain through this triangle along about this direction, of length 1. Empty where the section there is too wide
  /// for a wire with the shell's area, or cutting it was tried before.
  Chain follow(std::uint32_t triangle, const glm::dvec3& direction);

 private:
  struct At {
    ChainSection section;
    double next_corner = 0;                ///< how far ahead the next one is
    std::vector<std::uint32_t> triangles;  ///< that it cuts
  };
  /// The section next to that point, first along the axis given, and then along its own.
  bool cut_at(std::uint32_t triangle, const Plane& plane, At& at);
  static void keep_cut(Cutter& cutter, std::uint32_t triangle, const Plane& plane, At& at);
  /// One side of a chain; axes point away from the first section.
  struct End {
    At last;
    bool is_behind = false;
    std::vector<ChainSection> sections = {};  ///< but the first one
    double length = 0;
    int steps = 0;
    bool is_closed = false;  ///< it came to where the chain was, so many sections ago
    int turns = 0;
  };
  void extend(End& end, double began, int halvings);
  /// How many sections ago the chain was where it is again; 0: it was never there.
  int turns_back(std::span<const std::uint32_t> triangles, int number);
  bool is_steady(const Section& before, const Section& after, double step) const;
  bool was_tried(std::uint32_t triangle, const glm::dvec3& direction) const;
  /// By sections with about this axis: the same would come out again.
  bool was_followed(const At& at) const;
  void mark(std::span<const std::uint32_t> triangles, const glm::dvec3& direction);
  /// What lies between two sections in a row was as good as cut. Without it each ring of a fine mesh would be followed.
  void mark_between(const At& from, const At& to);

  const WeldedMesh& mesh_;
  ChainLimits limits_;
  Cutter cutter_, straight_;          ///< the second cuts again, straight across
  std::vector<std::uint16_t> tried_;  ///< [triangle] a bit for each of 13 directions
  struct Cut {
    std::uint32_t chain = 0;
    int number = 0;  ///< of the section, below 0 behind the first one
  };
  std::vector<Cut> last_cut_;           ///< [triangle]
  std::vector<std::uint32_t> oblique_;  ///< what cut_at() cut before it turned the plane
  std::vector<std::uint32_t> waiting_;  ///< of mark_between()
  std::vector<std::uint32_t> between_;  ///< [triangle] the last call of it that came there
  std::uint32_t calls_ = 0;
  std::uint32_t chain_ = 0;
  double most_perimeter_ = 0;  ///< of the shell that is looked at
};

}  // namespace foredraw::processors::wire_radius
