#include "order_figures.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <evaluators/vertex_cache/vertex_cache.h>
#include <foredraw/viewing/view_set.h>

namespace foredraw::bench {

namespace {

double overdraw(const MeshSet& set, const std::vector<std::vector<std::uint32_t>>& orders) {
  const Views views = make_views({.views = "icosphere", .count = 42});
  OverdrawCount sum;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const RasterPart part{.positions = set.meshes[i].positions, .indices = orders[i]};
    const OverdrawCounts counts = overdraw_raster({&part, 1}, views);
    for (const OverdrawCount& view : counts[0]) sum += view;
  }
  return static_cast<double>(sum.shaded) / static_cast<double>(sum.visible);
}

}  // namespace

std::vector<std::string> cache_names() {
  return {"fifo-12", "fifo-16", "fifo-20", "fifo-24", "fifo-32", "lru-16", "nvidia", "amd", "intel"};
}

OrderFigures figures_of(const MeshSet& set, const std::vector<std::vector<std::uint32_t>>& orders) {
  OrderFigures figures;
  for (const std::string& name : cache_names()) {
    CacheCount sum;
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const CacheCount one = count(orders[i], set.meshes[i].positions.size(), *cache_model(name));
      sum.misses += one.misses;
      sum.triangles += one.triangles;
      sum.referenced += one.referenced;
    }
    figures.acmr.push_back(static_cast<double>(sum.misses) / static_cast<double>(sum.triangles));
    if (name == "fifo-16") figures.atvr = static_cast<double>(sum.misses) / static_cast<double>(sum.referenced);
  }
  const bool is_small = std::ranges::all_of(
      set.meshes, [](const TestMesh& mesh) { return mesh.indices.size() / 3 <= most_drawn_triangles; });
  if (is_small) figures.ovr = overdraw(set, orders);
  return figures;
}

}  // namespace foredraw::bench
