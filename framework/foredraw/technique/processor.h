#pragma once
// Processors alone make new geometry.

#include <foredraw/scene/scene.h>
#include <foredraw/technique/draw_view.h>
#include <foredraw/technique/run.h>

namespace foredraw {

class Processor {
 public:
  static constexpr std::string_view works_on = "scene";
  virtual ~Processor() = default;
  /// Changes the scene. `draws` are those that it may change, rising; it leaves the others alone. Answers with those
  /// that are now as its card says, whether they had to change or not.
  virtual std::vector<DrawId> process(Scene&, const std::vector<DrawId>& draws, Run&) const = 0;
};

/// The framework loops over the draws, many at once. The answer stands in the draw's place.
class DrawProcessor {
 public:
  static constexpr std::string_view works_on = "draws";
  virtual ~DrawProcessor() = default;
  virtual Draw process(const DrawView&, Run&) const = 0;
};

}  // namespace foredraw
