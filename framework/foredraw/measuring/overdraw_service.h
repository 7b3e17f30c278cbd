#pragma once
// Measured overdraw for techniques that want it, whoever answers: a plugin says uses_overdraw on its card and asks
// run.overdraw; the pipeline's [services] says which evaluator that is.

#include <foredraw/overdraw/fragment_layers.h>
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>
#include <foredraw/technique/run.h>
#include <foredraw/viewing/subject_geometry.h>

namespace foredraw {

class OverdrawService {
 public:
  explicit OverdrawService(Faces faces = Faces::material) : faces_(faces) {}
  virtual ~OverdrawService() = default;

  /// Draws the parts one after the other from every view and counts.
  virtual OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run& run) const = 0;

  /// Whether capture() may answer.
  virtual bool can_capture() const { return false; }
  /// The same parts as layers, which count any order of their triangles as draw() would, all parts together, without
  /// drawing again. Triangles are numbered through the parts. Nothing where the service can not capture, or where
  /// layers would take more than `most_bytes`: then ask draw().
  virtual std::optional<FragmentLayers> capture(std::span<const RasterPart>, const Views&, Run&,
                                                std::size_t /*most_bytes*/ = default_layer_bytes) const {
    return std::nullopt;
  }

  /// Figures and notes of its own, behind those that all evaluators of overdraw have, once it has drawn the scene's
  /// subjects from the views.
  virtual void tell_more(const Scene&, std::span<const Subject>, const Views&, Run&) const {}

  /// Which back faces who asks should have culled.
  Faces faces() const { return faces_; }

  /// The subject's parts at rest, in their sequence. Parts that are blended, or masked one does not know how, are left
  /// out.
  OverdrawCounts count(const Scene& scene, const Subject& subject, const Views& views, Run& run) const {
    const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene) : PosedNodes();
    return draw(subject_geometry(scene, subject, faces_, nodes, run.analyses).parts, views, run);
  }

 private:
  Faces faces_;
};

}  // namespace foredraw
