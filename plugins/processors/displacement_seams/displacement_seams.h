#pragma once
// A displacement map whose heights agree along the seams of its layout.
//
// N. Tatarchuk, J. Barczak, B. Purnomo: Real-Time Tessellation on GPU, SIGGRAPH 2008 course notes, whose
// averaging of texels is here too. What is solved instead is ours.

#include <foredraw/analysis/seam_points.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

enum class SeamMethod : std::uint8_t {
  exact,   ///< equal whole numbers at the points of a tessellation
  average  ///< the paper's: texels that meet are averaged, again and again
};

struct DisplacementSeamsOptions {
  SeamMethod method = SeamMethod::exact;
  int iterations = 20;                        ///< of averaging
  std::uint32_t bits = 14;                    ///< that heights have to agree in, 1 to 16
  const std::atomic<bool>* cancel = nullptr;  ///< once it is set, an answer comes soon that is of no use
};

/// What a map becomes, without its texels: those of large maps are put where they are wanted.
struct SeamRepair {
  bool is_new = false;  ///< false: the old map stays
  /// What the old heights were at the new ones' 0 and 1: other than 0 and 1 where the solution left the range.
  double at_zero = 0, at_one = 1;
  std::vector<std::array<double, 2>> scales;  ///< to which all texels are scaled, one after the other: new 0 and 1
  std::vector<std::uint32_t> seam_texels;     ///< that were changed, but for scaling; by place, ascending
  std::vector<std::uint16_t> values;          ///< of these, new
  std::vector<std::uint32_t> rule;            ///< [edge] seam_factors()
  std::vector<std::uint32_t> factors;  ///< [edge] up to which it is equal now, in powers of two; 0: not even its ends
  std::size_t points = 0;              ///< at the factors of the rule
  std::size_t unequal_before = 0, unequal_after = 0;  ///< of them
};

struct RepairedMap : SeamRepair {
  std::vector<std::uint16_t> texels;  ///< the new map; empty: the old one stays
};

/// The map with seams whose sides are equal at k/factor of every edge, as displaced_height.h reads heights, in the
/// first `bits` bits: 0 unequal points wherever that can be, and else factors that are halved. Only texels that the
/// seams lie in change; if heights leave the range of 16 bits, all are scaled into it. A map that a second run would
/// not better is not changed: a second run changes nothing.
///
/// O(s) for seams of s texels together, where seams form lines and not a felt. The same bytes on every machine.
RepairedMap displacement_seams(const SeamEdges& seams, const foredraw_height_map& map,
                               const DisplacementSeamsOptions& options = {});

/// The same without texels. Memory: 2 bytes for each texel of the map, given back in the end, and what the seams take.
SeamRepair seam_repair(const SeamEdges& seams, const foredraw_height_map& map,
                       const DisplacementSeamsOptions& options = {});

/// Makes the new texels of the old ones.
void put(const SeamRepair& repair, std::span<std::uint16_t> texels);

struct Plugin;
Plugin displacement_seams_plugin();

}  // namespace foredraw
