#pragma once
// Finds what is long and thin in a mesh: tubes, ribbons, and nets of ribbons.

#include <foredraw/wires/wires.h>

#include <glm/vec3.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace foredraw {

struct WireOptions {
  double slender = 8;  ///< a wire is at least so many times as long as it is wide on average
  double aspect =
      2.2;           ///< a tube's section is at most so many times as wide as it is thick; what is flatter is a board
  double taper = 3;  ///< along a wire, the width changes at most by this factor
  bool ribbons = true;  ///< flat ribbons, and nets of them, too
  double decal = 1;  ///< a ribbon with a surface within so many of its breadths before or behind it is paint, no wire
  float least_length = 0;  ///< what is shorter is left alone, in the mesh's units
};

/// Why something that is long and thin is no wire, or not one that can be widened.
enum class WireRefusal : std::uint8_t {
  stout,   ///< less than `slender` times as long as wide, but at least half of that
  flat,    ///< its section is flatter than `aspect`, or has a dent
  ribbon,  ///< ribbons are not wanted
  decal,   ///< it lies on a surface
  small,   ///< shorter than `least_length`
  joined,  ///< all its corners join it to something else
  tiny,    ///< its width is 0 in 32-bit floats
};

struct FoundWire {
  WireKind kind = WireKind::tube;
  double length = 0;  ///< of the centre line; of a net of all its ribbons
  double radius = 0;  ///< half the least width, on average
  bool closed = false;
};

/// What was looked at and left alone.
struct RefusedWire {
  WireRefusal why = WireRefusal::stout;
  std::uint32_t triangle = 0;  ///< one of it
  double length = 0;
  double width = 0;  ///< on average
};

struct FoundWires {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<FoundWire> wires;
  std::vector<std::uint32_t> wire_of;  ///< [triangle] its wire, or none
  std::vector<glm::vec3> to_centre;    ///< [vertex] to the centre line; 0 where there is no wire
  std::vector<float> half_width;       ///< [vertex] the least; below 0: a joint, which stays where it is; 0: no wire
  std::vector<glm::vec3> axis;         ///< [vertex] of length 1, or 0
  std::vector<bool> is_flat;  ///< [vertex] its section is; to_centre lies in its breadth then and is never quite 0
  /// Where the ribbons of a net cross, vertices have another centre line for each but one of them: once more what
  /// stands above, of flat sections.
  struct Copy {
    std::uint32_t vertex = 0;
    glm::vec3 to_centre{0}, axis{0};
    float half_width = 0;
  };
  std::vector<Copy> copies;
  struct Corner {
    std::uint32_t index = 0;  ///< in the mesh's list of indices
    std::uint32_t copy = 0;
  };
  std::vector<Corner> corners;  ///< of triangles of wires, that want a copy; rising
  std::vector<RefusedWire> refused;
};

struct WireSearch {
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(double)> progress = {};  ///< the part done, 0 to 1
};

/// Looks at a mesh, three indices a triangle, each below the number of positions. Vertices at one position are one.
///
/// A plane that cuts a wire across cuts it in a small loop, or, through a ribbon, in a short line from border to
/// border. Such sections are followed from any triangle along its edges, each as far from the last one as it is wide,
/// so that an antenna on a large body is found as well as a rope of its own; they make a wire as far as they stay
/// alike. Each vertex gets the section through itself. O(n log n) where wires have few triangles round them. The
/// technique is Persson's: "Graphics Gems for Games", SIGGRAPH 2012, "Phone-wire AA"; how wires are found is our own.
FoundWires find_wires(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                      const WireOptions& options = {}, const WireSearch& search = {},
                      std::size_t first_fixed = std::numeric_limits<std::size_t>::max());

struct Plugin;
Plugin wire_radius_plugin();

}  // namespace foredraw
