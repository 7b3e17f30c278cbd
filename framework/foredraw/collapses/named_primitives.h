#pragma once
// Draws as extensions of a file name them, [mesh, primitive], and what is asked of products that hold something of each
// of several meshes.

#include <foredraw/scene/extension_value.h>
#include <foredraw/scene/scene.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// Nothing where the value is no list of such names, or one names nothing.
std::optional<std::vector<DrawId>> named_primitives(const ExtensionValue* list, const Scene& scene);

/// Each by the first mesh that holds it. Refusal where none does.
ExtensionValue names_of_primitives(std::span<const DrawId> draws, const Scene& scene);

/// The first thing that is wrong with what a product holds, as the rest of a sentence: a draw is to be in one of them
/// at most, and why_not() says what else is wrong with one. Nothing where all is right.
template <class Meshes, class WhyNot>
std::string first_difference(const Meshes& meshes, const Scene& scene, const WhyNot& why_not) {
  std::vector<bool> is_named(scene.draws.size(), false);
  for (const auto& mesh : meshes) {
    if (mesh.draws.empty()) return "one of them names no draw";
    for (const DrawId id : mesh.draws) {
      if (id >= scene.draws.size() || is_named[id]) return "a draw is named twice, or does not exist";
      is_named[id] = true;
    }
    if (std::string why = why_not(mesh); !why.empty()) return why;
  }
  return {};
}

}  // namespace foredraw
