#pragma once
// Evaluators measure, and take everything const. Figures go to run.measure.

#include <foredraw/scene/scene.h>
#include <foredraw/technique/draw_view.h>
#include <foredraw/technique/run.h>

namespace foredraw {

class Evaluator {
 public:
  static constexpr std::string_view works_on = "scene";
  virtual ~Evaluator() = default;
  virtual void evaluate(const Scene&, Run&) const = 0;
};

/// The framework loops over the draws, many at once.
class DrawEvaluator {
 public:
  static constexpr std::string_view works_on = "draws";
  virtual ~DrawEvaluator() = default;
  virtual void evaluate(const DrawView&, Run&) const = 0;
};

}  // namespace foredraw
