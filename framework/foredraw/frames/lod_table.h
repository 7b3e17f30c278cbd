#pragma once
// What is known ahead of the ways to draw each draw of a scene, as a product. The stage lod-table makes it.

#include <foredraw/frames/rendering_costs.h>
#include <foredraw/runtime/lod_table.h>
#include <foredraw/scene/draw.h>

#include <array>
#include <string_view>
#include <vector>

namespace foredraw {

struct LodTable {
  static constexpr std::string_view product = "lod-table";
  static constexpr std::size_t renderings = all_renderings.size();
  static constexpr std::size_t octaves = FOREDRAW_LOD_OCTAVES;
  static constexpr std::size_t most_levels = FOREDRAW_LOD_MOST_LEVELS;
  static_assert(renderings == FOREDRAW_LOD_RENDERINGS);

  struct OfLevel {
    std::uint32_t triangles = 0;
    std::uint32_t shaded = 0;    ///< vertices that a first-in-first-out cache of 16 lets through
    std::uint32_t vertices = 0;  ///< that are stored
    float error = 0;             ///< largest distance from full detail, in the draw's units; 0: none, or not known
    friend bool operator==(const OfLevel&, const OfLevel&) = default;
  };
  /// [octave of the size on the screen, from 4 pixels across the bounding sphere on][rendering]: bit l is set where
  /// level l, drawn so, lies on the upper hull of cost and benefit at some size of the octave.
  using Hulls = std::array<std::array<std::uint32_t, renderings>, octaves>;

  struct OfDraw {
    DrawId draw = 0;
    float radius = 0;      ///< of the bounding sphere of full detail, in the draw's units; above 0
    float coverage = 1;    ///< of the sphere's disc, what part the draw covers in the mean; 0 to 1
    float importance = 1;  ///< 0 to 1
    std::array<float, renderings> accuracy = {1, 1, 1};  ///< how near each comes to the full one; 0 to 1
    std::vector<OfLevel> levels;                         ///< 1 to most_levels, full detail first
    Hulls hulls = {};
    friend bool operator==(const OfDraw&, const OfDraw&) = default;
  };

  RenderingCosts costs;       ///< with which hulls were made
  std::vector<OfDraw> draws;  ///< rising; never empty
  friend bool operator==(const LodTable&, const LodTable&) = default;
};

}  // namespace foredraw
