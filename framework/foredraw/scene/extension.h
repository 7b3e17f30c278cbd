#pragma once
// What glTF has no words for: written as an optional extension, so that a reader that does not know it loses nothing.

#include <foredraw/scene/vertex_streams.h>

#include <string>
#include <vector>

namespace foredraw {

/// A stream that belongs to an extension. What its rows belong to says how they move when an order is applied; what its
/// values name says how they are renumbered.
struct ExtensionStream {
  enum class Rows { none, vertices, triangles };
  enum class Values { plain, vertices, triangles };  ///< the last two: uint32, one component

  VertexStream stream;  ///< `semantic` is its key in the extension's object
  Rows rows = Rows::none;
  Values values = Values::plain;
};

struct Extension {
  std::string name;
  std::string json = "{}";  ///< the extension's object without its streams
  std::vector<ExtensionStream> streams;
};

}  // namespace foredraw
