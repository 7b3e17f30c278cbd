#pragma once
// Draws that are seen and judged together.

#include <foredraw/scene/scene.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foredraw {

/// A draw as one node shows it. Without a node: in its own space.
struct SubjectPart {
  DrawId draw = 0;
  std::optional<NodeId> node;
  friend bool operator==(const SubjectPart&, const SubjectPart&) = default;
};

/// One draw, a mesh, a character, or the scene. Parts are in the sequence in which they are drawn.
struct Subject {
  std::string name;
  std::vector<SubjectPart> parts;

  /// Whether a node shows any of it. Else all parts are in their own space, where nothing moves them.
  bool is_placed() const {
    return std::any_of(parts.begin(), parts.end(), [](const SubjectPart& part) { return part.node.has_value(); });
  }
};

/// The default subjects of a scene: a character (every mesh that shares a skin or hangs below one of its joints) where
/// there is a skin; a mesh as each node shows it whose morph weights an animation moves; else each mesh in its own
/// space. Every draw that a mesh holds is in one subject at least. Parts are drawn node by node as the file's walk has
/// them, and of a node in the sequence of Mesh::draws.
std::vector<Subject> subjects_of(const Scene& scene);

}  // namespace foredraw
