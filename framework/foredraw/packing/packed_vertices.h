#pragma once
// Vertices in 128 bits beside the plain streams: the product of a stage that packs them.

#include <foredraw/runtime/packed_vertex.h>
#include <foredraw/scene/scene.h>

#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

namespace foredraw {

/// A layout of runtime/packed_vertex.h as a value.
struct PackedLayout : foredraw_packed_layout {
  /// Bit by bit: all of it is numbers of four bytes, without gaps.
  friend bool operator==(const PackedLayout& a, const PackedLayout& b) { return std::memcmp(&a, &b, sizeof a) == 0; }
};

struct PackedVertices {
  static constexpr std::string_view product = "packed-vertices";

  struct OfDraw {
    DrawId draw = 0;
    PackedLayout layout{};                    ///< of the rows, which hold the vertices as they are stored
    std::optional<PackedLayout> posed = {};   ///< for vertices that were skinned or morphed, in world space where nodes
                                              ///< show the draw; nothing where nothing moves them
    std::vector<Shared<std::uint32_t>> rows;  ///< [level] four words a vertex; levels that share vertices share them
    friend bool operator==(const OfDraw&, const OfDraw&) = default;
  };

  std::vector<OfDraw> draws;  ///< rising; never empty
  friend bool operator==(const PackedVertices&, const PackedVertices&) = default;
};

}  // namespace foredraw
