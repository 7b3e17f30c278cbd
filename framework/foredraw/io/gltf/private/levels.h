#pragma once
// Levels of detail in a document. glTF knows primitives alone, so each level is one while the document is checked, read
// and patched: FOREDRAW_levels behind those of its own mesh, MSFT_lod in the meshes of coarser nodes. The scene alone
// holds levels as levels. docs/reference/levels.md tells what the extension's members mean. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/gltf/private/source.h>

#include <map>

namespace foredraw::gltf {

inline constexpr const char* levels_extension = "FOREDRAW_levels";
inline constexpr const char* lod_extension = "MSFT_lod";
inline constexpr const char* coverage_key = "MSFT_screencoverage";  // in the node's extras

/// What FOREDRAW_levels says of itself: it is no product, and yet costs nothing else where it is damaged.
ProductCard levels_card();

/// Puts the levels of every primitive behind the primitives of its mesh. Answers with what is wrong in one of them; the
/// JSON is then of no use.
std::optional<std::string> expose_levels(Json& json, std::vector<Ladder>& ladders);

/// A place in such a primitive, as the document said it before: "meshes[0].primitives[4].indices" as
/// "meshes[0].primitives[0].extensions.FOREDRAW_levels.levels[1].indices". Other places stay.
std::string place_of_level(const std::vector<Ladder>& ladders, const std::string& place);

/// The reverse, for a document that was patched from the scene: `scene` still holds its levels.
void enclose_levels(const Scene& scene, Json& json);

/// The levels that MSFT_lod gives meshes. A note says so of each node whose coarser ones are no levels of its mesh.
std::vector<Ladder> lod_ladders(const Scene& scene, const Document& document, Diagnostics& diagnostics);

/// Draws that are levels become those of the draws that are full detail, and leave the scene's list.
void fold_levels(Scene& scene, const std::vector<Ladder>& ladders);

/// The scene with each level a draw of its own again; draws that stand for themselves keep their numbers.
Scene unfolded(const Scene& scene);

/// What MSFT_lod says of a node.
struct Lods {
  std::vector<NodeId> ids;  ///< of coarser nodes
  std::vector<double>
      coverage;  ///< [level], full detail too: the least share of the screen that it is for; none: unknown
};
using LodsOf = std::map<NodeId, Lods>;

/// The scene with its levels in meshes of coarser nodes, where MSFT_lod can tell of them; `lods` are each node's. A
/// note tells of meshes whose levels stay with their primitives.
Scene with_lod_nodes(const Scene& scene, const Document& document, LodsOf& lods, Diagnostics& diagnostics);

/// A scene on its way into a document.
class LevelScene {
 public:
  /// All of these must outlive it.
  LevelScene(const Scene& scene, const Source& source, LevelsAs levels, Diagnostics& diagnostics);

  /// Each level a draw of its own.
  const Scene& flat() const { return flat_ ? *flat_ : scene_; }
  /// Whether levels are told to be as far from full detail as they were when read.
  bool same_errors() const;
  void put_lods(Json& json) const;
  void enclose(Json& json) const { enclose_levels(with_lods_ ? *with_lods_ : scene_, json); }

 private:
  const Scene& scene_;
  const Source& source_;
  std::optional<Scene> with_lods_;
  std::optional<Scene> flat_;
  LodsOf lods_;
};

/// Whether a level is a primitive of a mesh other than its draw's.
bool is_in_coarser_mesh(const Draw& draw, const Level& level);

}  // namespace foredraw::gltf
