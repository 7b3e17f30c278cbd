#pragma once
// A draw as a technique sees it: level 0 in the order that stands alone.

#include <foredraw/scene/scene.h>

namespace foredraw {

struct DrawView {
  const Scene& scene;
  DrawId id;

  const Draw& draw() const { return scene.draws[id]; }
  const VertexStreams& vertices() const { return *draw().levels[0].vertices; }
  const IndexStream& stream() const { return draw().levels[0].orders[0]; }
  std::span<const std::uint32_t> indices() const { return stream().indices.view(); }
  std::size_t triangle_count() const { return stream().triangle_count(); }
  std::size_t vertex_count() const { return vertices().count; }
};

}  // namespace foredraw
