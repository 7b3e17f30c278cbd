#pragma once
// How the experiment runs pipelines and judges what they make.

#include <foredraw/pipeline/runner.h>

#include <string>

namespace foredraw::bench {

inline constexpr std::uint32_t cache_size = 20;  // the paper's

struct Figures {
  double acmr = 0;
  double ratio = 0;
  double seconds = 0;  ///< of the stage that orders
};

/// From where all is judged: no order was made for these.
Views held_out_views();

/// Pipelines of Foredraw, run on two threads: orders are made for 162 orthographic views.
class Lab {
 public:
  Lab();

  const Executor& executor() const { return executor_; }

  /// `stages`: TOML, what stands between the brackets. Orders are made for so many poses at most, of all clips.
  Result run(const Scene& scene, const std::string& stages, int keyframes);

  /// As drawn in so many poses at most of the motion.
  Figures measured(const Scene& scene, const std::string& motion, int keyframes);

 private:
  Plan planned(const Scene& scene, const std::string& stages, int keyframes, const std::string& measures);

  Executor executor_;
  Analyses analyses_;
  Registry registry_;
};

}  // namespace foredraw::bench
