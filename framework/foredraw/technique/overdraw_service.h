#pragma once
// Measured overdraw for techniques that want it, whoever answers: a plugin says uses_overdraw on its card and asks
// run.overdraw; the pipeline's [services] says which evaluator that is.

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
};

}  // namespace foredraw
