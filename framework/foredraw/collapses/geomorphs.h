#pragma once
// How levels of detail become each other: the product of a stage that knows what each vertex of a level becomes.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw {

struct DrawGeomorph {
  DrawId draw = 0;
  std::vector<Shared<std::uint32_t>> ancestors;  ///< [level][its vertex] = vertex of the next coarser level
  friend bool operator==(const DrawGeomorph&, const DrawGeomorph&) = default;
};

struct Geomorphs {
  static constexpr std::string_view product = "geomorphs";
  std::vector<DrawGeomorph> draws;  ///< rising; each of a draw with levels, and of all its levels but the coarsest
  friend bool operator==(const Geomorphs&, const Geomorphs&) = default;
};

/// [vertex of the draw's level] = the vertex of the next coarser level that it becomes; empty where the scene does not
/// say, or has no coarser one.
std::span<const std::uint32_t> ancestors_of(const Scene& scene, DrawLevel level);

}  // namespace foredraw
