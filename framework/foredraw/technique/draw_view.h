#pragma once
// A draw as a technique sees it: at one level of detail, in the order that stands alone. The runner hands each level
// out as the one that the draw has; run.about says which it is.

#include <foredraw/scene/scene.h>

namespace foredraw {

struct DrawView {
  const Scene& scene;
  DrawId id;

  const Draw& draw() const { return scene.draws[id]; }
  const VertexStreams& vertices() const { return *draw().full().vertices; }
  const IndexStream& stream() const { return draw().full().stream(); }
  std::span<const std::uint32_t> indices() const { return stream().indices.view(); }
  std::size_t triangle_count() const { return stream().triangle_count(); }
  std::size_t vertex_count() const { return vertices().count; }
};

}  // namespace foredraw
