#pragma once
// Long thin things of draws, which vertices know by their centre lines: the product of a stage that found them.

#include <foredraw/scene/draw.h>

#include <glm/vec4.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace foredraw {

/// Streams of a draw with wires, in its own space. WIRE, float VEC4: from the vertex to its wire's centre line, and
/// half the least width of the section there. Below 0: the vertex joins the wire to something else and stays where it
/// is. 0: no wire. AXIS, float VEC4: the centre line's direction, of one sign along a wire, and 1 where the section is
/// flat: then half the width is half its breadth, in which the vector to the centre line lies. 0 where there is none.
inline constexpr std::string_view wire_semantic = "_FOREDRAW_WIRE";
inline constexpr std::string_view wire_axis_semantic = "_FOREDRAW_WIRE_AXIS";

enum class WireKind : std::uint8_t {
  tube,    ///< with a closed section, or one that is open at the back
  ribbon,  ///< flat
  net,     ///< flat ribbons that cross
};

constexpr std::string_view text_of(WireKind kind) {
  switch (kind) {
    case WireKind::tube: return "tube";
    case WireKind::ribbon: return "ribbon";
    case WireKind::net: break;
  }
  return "net";
}

/// Of a wire that several draws show a part of, each has one: `triangles` are the draw's own, the rest is the whole's.
struct Wire {
  std::uint32_t triangles = 0;  ///< how many, not where: they stand in any order among the draw's other wires
  WireKind kind = WireKind::tube;
  float length = 0;     ///< of the centre line; of a net of all its ribbons
  float radius = 0;     ///< half the least width, on average
  bool closed = false;  ///< a ring, without ends
  friend bool operator==(const Wire&, const Wire&) = default;
};

/// Of full detail, in the order that stands alone: the wires' triangles are its last ones. All corners of these are a
/// wire's, and one at least may move; no corner of those before may.
struct DrawWires {
  DrawId draw = 0;
  std::uint32_t first_triangle = 0;
  std::vector<Wire> wires;  ///< at least one; their triangles sum up to what the draw has from the first one on
  /// Where the streams are not the two above, but four sets of texture coordinates, of floats, from this one on: WIRE's
  /// x and y, its z and w, AXIS's x and y, its z and w.
  std::optional<std::uint32_t> texcoords = {};
  friend bool operator==(const DrawWires&, const DrawWires&) = default;
};

/// What the streams say, decoded.
struct DecodedWires {
  std::vector<glm::vec4> wires, axes;  ///< [vertex] WIRE and AXIS
};

/// `texcoords`: as DrawWires has it. Nothing where a stream is missing, or of another type.
std::optional<DecodedWires> decoded_wires(const VertexStreams& vertices, std::optional<std::uint32_t> texcoords);

struct Wires {
  static constexpr std::string_view product = "wires";
  std::vector<DrawWires> draws;  ///< rising

  const DrawWires* of(DrawId draw) const {
    const auto found = std::ranges::find(draws, draw, &DrawWires::draw);
    return found == draws.end() ? nullptr : &*found;
  }
  friend bool operator==(const Wires&, const Wires&) = default;
};

}  // namespace foredraw
