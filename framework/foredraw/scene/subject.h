#pragma once
// Draws that are seen and judged together.

#include <foredraw/scene/scene.h>

#include <algorithm>
#include <string>
#include <string_view>
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

/// The draw as the first node shows it; nothing where none does.
std::optional<SubjectPart> shown_part(const Scene& scene, DrawId draw);

/// What is seen and judged as one.
enum class SubjectUnit {
  mesh,       ///< each mesh: as each node shows it where a skin or morph weights move it, else in its own space
  character,  ///< every mesh that shares a skin or hangs below one of its joints; the other meshes one by one
  scene,      ///< all that the scene shows; an instanced mesh once, as its node stands
};

constexpr std::string_view text_of(SubjectUnit unit) {
  switch (unit) {
    case SubjectUnit::mesh: return "mesh";
    case SubjectUnit::character: return "character";
    case SubjectUnit::scene: break;
  }
  return "scene";
}

/// The subjects of a scene. Every draw that a mesh holds is in one subject at least: meshes that nothing shows are
/// subjects of their own. Parts are drawn node by node as the file's walk has them, and of a node in the sequence of
/// Mesh::draws.
std::vector<Subject> subjects_of(const Scene& scene, SubjectUnit unit = SubjectUnit::character);

}  // namespace foredraw
