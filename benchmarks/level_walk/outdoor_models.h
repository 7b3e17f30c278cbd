#pragma once
// Trees, rocks and what stands in streets: made of a seed, each seed another one. They stand on the plane y = 0 around
// the origin; triangles are those of full detail.

#include "palette.h"

namespace foredraw::bench {

/// Of the height, its crown as wide as half of that: wood (2,600 triangles) and leaves (8,400).
std::vector<ModelPart> tree(double height, std::uint64_t seed);

/// 3,800 triangles, as high as wide.
std::vector<ModelPart> bush(double size, std::uint64_t seed);

/// 2,300 to 8,200 triangles, by the seed.
std::vector<ModelPart> rock(double size, std::uint64_t seed);

/// Blades of grass: 1,440 triangles.
std::vector<ModelPart> tuft(double size, std::uint64_t seed);

/// Bollards, hydrants, bins, planters, urns and columns, by the rest of the seed by 6: about 3,000 triangles.
constexpr std::uint64_t street_kinds = 6;
std::vector<ModelPart> street_piece(double height, std::uint64_t seed);

/// A twisted figure of `around` * `along` * 2 triangles.
std::vector<ModelPart> statue(double height, std::uint64_t seed, std::size_t around = 80, std::size_t along = 90);

}  // namespace foredraw::bench
