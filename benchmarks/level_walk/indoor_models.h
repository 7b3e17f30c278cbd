#pragma once
// Furniture and ornaments, in metres: they stand on the plane y = 0 around the origin, with their front to +Z. What a
// seed changes is said; triangles are those of full detail.

#include "palette.h"

namespace foredraw::bench {

std::vector<ModelPart> table();                         ///< .8 high, 1.4 x .8; 15,000 triangles
std::vector<ModelPart> chair(std::uint64_t seed);       ///< .5 wide, 1 high; 12,000
std::vector<ModelPart> sofa(std::uint64_t seed);        ///< 1.7 wide, .85 deep and high; 15,000
std::vector<ModelPart> shelf(std::uint64_t seed);       ///< with books: 1.2 wide, .35 deep, 1.8 high; 8,000 to 11,000
std::vector<ModelPart> pedestal();                      ///< 1 high, .45 wide; 6,000
std::vector<ModelPart> vase(std::uint64_t seed);        ///< .35 to .5 high; 12,000
std::vector<ModelPart> floor_lamp();                    ///< 1.6 high; 7,000
std::vector<ModelPart> pot_plant(std::uint64_t seed);   ///< 1.3 high; 20,000
std::vector<ModelPart> chandelier(std::uint64_t seed);  ///< hangs from y = 0 down to -.75, 1 wide; 30,000
std::vector<ModelPart> rug(std::uint64_t seed);         ///< 1.9 x 1.3, .03 high; 4,800

/// A box of a material, for walls: `size` around x = 0 and z = 0, from y = 0 up.
std::vector<ModelPart> slab(const glm::dvec3& size, std::string_view material);

}  // namespace foredraw::bench
