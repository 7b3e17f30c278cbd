#pragma once
// Measured overdraw for techniques that want it, whoever answers: a plugin says uses_overdraw on its card and asks
// run.overdraw; the pipeline's [services] says which evaluator that is.

#include <foredraw/analysis/fragment_layers.h>
#include <foredraw/analysis/overdraw_count.h>
#include <foredraw/scene/subject.h>
#include <foredraw/scene/views.h>
#include <foredraw/technique/run.h>

namespace foredraw {

class OverdrawService {
 public:
  virtual ~OverdrawService() = default;
  /// Draws the subject's parts in their sequence from every view and counts. Blended parts are left out.
  virtual OverdrawCounts count(const Scene&, const Subject&, const Views&, Run&) = 0;
  /// Whether layers() may answer.
  virtual bool can_capture() const { return false; }
  /// The same subject as layers, which count any order of its triangles as count() would, all parts together, without
  /// drawing again. Triangles are numbered through the parts, and parts that are not drawn have none. Nothing where the
  /// service can not capture, or where layers would take more than `most_bytes`: then ask count().
  virtual std::optional<FragmentLayers> layers(const Scene&, const Subject&, const Views&, Run&,
                                               std::size_t most_bytes = default_layer_bytes) {
    static_cast<void>(most_bytes);
    return std::nullopt;
  }
};

}  // namespace foredraw
