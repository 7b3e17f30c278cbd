#pragma once
#include <foredraw/overdraw/fragment_layers.h>
#include <foredraw/technique/draw_view.h>
#include <foredraw/technique/run.h>
#include <foredraw/viewing/subject_geometry.h>

namespace foredraw {

/// Measured overdraw of one draw alone, in its own space, for whoever tries several orders of it.
class DrawOverdraw {
 public:
  DrawOverdraw(const DrawView& view, Run& run) : view_(view), run_(run) {}

  std::size_t triangle_count() const { return view_.triangle_count(); }
  /// Of its triangles in that order, a permutation, [new] = old, over all views of the pipeline; null: as they stand.
  /// What is seen is captured at the first call, where the pipeline's service can. Nothing is seen of blended draws.
  OverdrawCount count(const std::uint32_t* order);

 private:
  void capture();
  OverdrawCount drawn(std::span<const std::uint32_t> order);

  DrawView view_;
  Run& run_;
  bool is_captured_ = false;
  SubjectGeometry geometry_;
  std::optional<FragmentLayers> layers_;
};

}  // namespace foredraw
