#pragma once
// Draws as extensions of a file name them: [mesh, primitive].

#include <foredraw/scene/extension_value.h>
#include <foredraw/scene/scene.h>

#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// Nothing where the value is no list of such names, or one names nothing.
std::optional<std::vector<DrawId>> named_primitives(const ExtensionValue* list, const Scene& scene);

/// Each by the first mesh that holds it. Refusal where none does.
ExtensionValue names_of_primitives(std::span<const DrawId> draws, const Scene& scene);

}  // namespace foredraw
