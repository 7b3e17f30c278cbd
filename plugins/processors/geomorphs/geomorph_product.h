#pragma once
// The product that geomorphs makes: the ancestors of vertices, level by level.

#include <foredraw/scene/product_row.h>

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

/// How Geomorphs are read, written, proved and told. Proved is that triangles end as those of the next level: a
/// renderer that has moved all vertices to their ancestors may draw the next level in their place, and no pixel
/// changes.
std::shared_ptr<const ProductRow> geomorph_product();

}  // namespace foredraw
