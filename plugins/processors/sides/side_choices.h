#pragma once
// What is done with each double-sided draw: a choice by figures alone.

#include "sides.h"

#include <foredraw/scene/draw.h>

#include <cstddef>
#include <map>
#include <span>

namespace foredraw::sides {

enum class Choice {
  left,          ///< it stays double-sided
  single_sided,  ///< no back of it is seen
  copies,        ///< single-sided; what is seen from both sides is there twice
  two_draws,     ///< one single-sided, one double-sided
};

/// What is seen of a draw.
struct Counted {
  std::size_t triangles = 0;
  std::size_t added = 0;   ///< seen from both sides
  std::size_t turned = 0;  ///< seen from behind alone

  std::size_t backs() const { return added + turned; }
};

Counted counted(std::span<const Side> wanted);

struct ChoiceOptions {
  double most_added = 0.1;     ///< triangles, times the scene's
  double vertex_weight = 0.1;  ///< of a shaded vertex beside a fragment, as occlusion-order has it
  bool split = true;           ///< a draw of which too much would be added may become two
};

/// Copies for as many draws as the scene of so many triangles may grow by, those that add least first, of equal ones
/// the lower number; the others become two, or stay as they are where they may not, or where all their backs are seen.
std::map<DrawId, Choice> first_choices(const std::map<DrawId, Counted>& counts, std::size_t triangles,
                                       const ChoiceOptions& options);

/// Whether a choice costs no more than it saves: `saved` of `visible` fragments, in a scene of so many vertices.
bool pays(Choice choice, const Counted& count, double saved, double visible, double vertices,
          const ChoiceOptions& options);

}  // namespace foredraw::sides
