#pragma once
// What the reader keeps for the writer. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/private/document.h>
#include <foredraw/scene/scene.h>

namespace foredraw::gltf {

class Source final : public SceneSource {
 public:
  Source(Document document, Scene as_read) : document(std::move(document)), as_read(std::move(as_read)) {}

  std::uint64_t bytes() const override { return bytes_read(document); }

  Document document;
  Scene as_read;  ///< handles to what the stages were given, each level a draw of its own; its own source is empty
};

/// The scene that a document holds, its source left out.
Scene scene_of(const Document& document);

/// Which nodes the scene that the file shows holds: the default one, or the first. A file without scenes shows all.
/// Those that KHR_node_visibility hides, with all below them, are not shown.
void find_shown_nodes(Scene& scene, const Document& document);

/// The draws with an extension that may refer to their triangles or vertices by number.
void find_extended(Scene& scene, const Document& document);

}  // namespace foredraw::gltf
