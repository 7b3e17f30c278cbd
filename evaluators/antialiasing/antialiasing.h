#pragma once
// Ways against jagged edges, held against a supersampled truth under sub-pixel motion.
//
// E. Persson: Graphics Gems for Games, SIGGRAPH 2012: phone-wire anti-aliasing, second-depth anti-aliasing.

#include "picture_figures.h"
#include "ways.h"

#include <foredraw/frames/sliding_views.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace foredraw {

struct AntialiasingOptions {
  FrameSize size{256, 256};  ///< of the pictures
  int truth_samples = 256;   ///< a power of two
  std::vector<evaluators::antialiasing::Way> ways{evaluators::antialiasing::all_ways.begin(),
                                                  evaluators::antialiasing::all_ways.end()};
  Rendering rendering = Rendering::full;
  const std::vector<std::uint32_t>* closed =
      nullptr;  ///< as evaluators::antialiasing::Frame has it; null: without second_depth
};

/// A figure, and its standard deviation by leaving out one view after another; 0 where there is one view alone.
struct AntialiasingFigure {
  double value = 0, error = 0;
};

struct Antialiasing {
  struct OfWay {
    evaluators::antialiasing::Way way = evaluators::antialiasing::Way::none;
    AntialiasingFigure rmse, flicker;  ///< root mean squares over touched pixels, of a channel's range
    AntialiasingFigure broken;         ///< part of the pixels that wires touch
    AntialiasingFigure ink;            ///< of wires, more than there should be: 0.1 is a tenth more
    FramePicture picture;              ///< the first view's first frame
  };
  std::vector<OfWay> ways;
  AntialiasingFigure floor;  ///< rmse of a second truth, from the first frame of each view
  FramePicture truth;        ///< of the first view's first frame
  double touched = 0;        ///< part of all pixels that count
  bool has_wires = false;    ///< in some frame; without, ways for wires are left out
};

/// None: it was cancelled. `progress`: the part done, 0 to 1; from any thread; may be empty.
std::optional<Antialiasing> antialiasing(const FrameScene& scene, const FrameMoment& moment, const SlidingViews& views,
                                         const AntialiasingOptions& options, const Executor& executor,
                                         const std::atomic<bool>* cancel = nullptr,
                                         const std::function<void(double)>& progress = {});

struct Plugin;
Plugin antialiasing_plugin();

}  // namespace foredraw
