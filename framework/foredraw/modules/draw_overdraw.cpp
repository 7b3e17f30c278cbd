#include <foredraw/modules/draw_overdraw.h>

#include <foredraw/measuring/overdraw_service.h>

#include <numeric>

namespace foredraw {

OverdrawCount DrawOverdraw::count(const std::uint32_t* first) {
  std::vector<std::uint32_t> as_they_stand;
  if (first == nullptr) {
    as_they_stand.resize(triangle_count());
    std::iota(as_they_stand.begin(), as_they_stand.end(), 0u);
    first = as_they_stand.data();
  }
  const std::span order(first, triangle_count());
  capture();
  if (geometry_.parts.front().indices.empty()) return {};
  return layers_ ? count_overdraw(*layers_, order) : drawn(order);
}

void DrawOverdraw::capture() {
  if (is_captured_) return;
  const Subject alone{view_.draw().name, {{view_.id, {}}}};
  geometry_ =
      subject_geometry(view_.scene, alone, run_.overdraw->faces(), PosedNodes(), run_.analyses, ShownSurface::stored);
  const bool is_seen = !geometry_.parts.front().indices.empty();
  if (is_seen && run_.overdraw->can_capture()) {
    layers_ = run_.overdraw->capture(geometry_.parts, run_.views, run_);
  }
  is_captured_ = true;
}

OverdrawCount DrawOverdraw::drawn(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * order.size());
  const auto old = view_.indices();
  for (const std::uint32_t triangle : order) {
    const auto corners = old.subspan(3 * std::size_t{triangle}, 3);
    indices.insert(indices.end(), corners.begin(), corners.end());
  }
  RasterPart part = geometry_.parts.front();
  part.indices = indices;
  OverdrawCount sum;
  const OverdrawCounts counts = run_.overdraw->draw({&part, 1}, run_.views, run_);
  for (const OverdrawCount& count : counts.front()) sum += count;
  return sum;
}

}  // namespace foredraw
