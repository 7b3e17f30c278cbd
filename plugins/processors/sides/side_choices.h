#pragma once
// What is done with each double-sided draw: a choice by figures alone.

#include "sides.h"

#include <foredraw/scene/draw.h>

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace foredraw::processors::sides {

enum class Choice {
  left,          ///< it stays double-sided
  single_sided,  ///< no back of it is seen
  copies,        ///< single-sided; what is seen from both sides is there twice
  two_draws,     ///< one single-sided, with copies; one double-sided
};

/// A double-sided draw.
struct Sided {
  std::span<const Side> wanted;   ///< [triangle]
  std::span<const double> gains;  ///< [triangle] fragments saved where its sides are drawn apart, or one not at all
  double vertices = 0;            ///< that it uses
};

struct Plan {
  Choice choice = Choice::left;
  std::vector<bool> stays;  ///< [triangle] of two draws: it stays double-sided
  std::size_t added = 0;    ///< triangles
  double saved = 0;         ///< fragments
};

struct ChoiceOptions {
  double most_added = 0.1;     ///< triangles, times the scene's
  double vertex_weight = 0.3;  ///< a copied vertex, as a share of all, must save this share of what is seen
  bool split = true;           ///< a draw of which too much would be added may become two
};

/// The scene that the draws are of.
struct Sizes {
  double triangles = 0, vertices = 0;
  double visible = 0;  ///< fragments, in the pictures that gains are of
};

/// What costs a draw least where each added triangle costs as many fragments as `price`, and a draw call `call_price`:
/// a copy of all that is seen from both sides; two draws, in which what gains more than the price is copied and the
/// rest stays double-sided; or nothing. Of equal ones the last. O(triangles).
Plan cheapest_plan(const Sided& draw, double price, double call_price, bool may_split);

/// Plans for draws of a scene. An added triangle has the price of its vertices, or more: as much as it takes for all
/// draws together to add no more than they may. So what is copied gains most for its triangles.
std::map<DrawId, Plan> plans(const std::map<DrawId, Sided>& draws, const Sizes& scene, const ChoiceOptions& options);

}  // namespace foredraw::processors::sides
