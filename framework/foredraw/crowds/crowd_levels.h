#pragma once
// What is known ahead of the levels at which the instances of a crowd can be drawn. The stage crowd-levels makes it.

#include <foredraw/runtime/tessellation_level.h>
#include <foredraw/scene/draw.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

/// How an instance is drawn (Tatarchuk, Barczak, Purnomo 2008: red, green and blue).
enum class CrowdClass : std::uint8_t {
  tessellated,  ///< full detail, its triangles divided and moved by a map of heights
  plain,        ///< full detail as it is stored
  simplified,   ///< a coarser level of detail
};
constexpr std::string_view to_text(CrowdClass of) {
  return of == CrowdClass::tessellated ? "tessellated" : of == CrowdClass::plain ? "plain" : "simplified";
}

/// A row of the table. Distances are from the finest displaced surface, or from full detail where nothing is displaced,
/// in the draws' units.
struct CrowdLevel {
  CrowdClass kind = CrowdClass::plain;
  std::uint32_t number = 0;  ///< parts of each edge where it is tessellated, the draws' level where it is simplified
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;  ///< that are stored, and posed
  float largest = 0;
  float rms = 0;
  friend bool operator==(const CrowdLevel&, const CrowdLevel&) = default;
};

struct CrowdLevels {
  static constexpr std::string_view product = "crowd-levels";
  static constexpr std::size_t most_levels = 128;  ///< as the runtime has it

  struct OfDraw {
    DrawId draw = 0;
    std::uint32_t crowd = 0;  ///< draws of equal numbers are drawn together, at the same row
    float area = 0;           ///< of full detail: what its rms weighs
    std::vector<CrowdLevel> levels;
    friend bool operator==(const OfDraw&, const OfDraw&) = default;
  };

  std::uint32_t characters = 10;  ///< at their finest level, whose triangles are the budget of all
  foredraw_spacing spacing = FOREDRAW_SPACING_EQUAL;
  std::vector<OfDraw> draws;  ///< rising; never empty
  friend bool operator==(const CrowdLevels&, const CrowdLevels&) = default;
};

/// What is drawn together.
struct Crowd {
  std::vector<DrawId> draws;       ///< rising
  std::vector<CrowdLevel> levels;  ///< of all draws: the sum of their counts, the largest of their distances
  std::uint64_t budget = 0;        ///< triangles
};

/// By the numbers that draws give, rising.
std::vector<Crowd> crowds_of(const CrowdLevels& levels);

}  // namespace foredraw
