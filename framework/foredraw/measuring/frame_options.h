#pragma once
#include <foredraw/frames/camera_path.h>
#include <foredraw/technique/options.h>

#include <concepts>

namespace foredraw {

/// The rows of a set of frames, for options that derive from FrameSet.
template <class Options>
requires std::derived_from<Options, FrameSet>
void add_frame_rows(OptionTable<Options>& table) {
  table.number_or_text(&FrameSet::path, "path",
                       "Way of the camera: auto (a camera of the scene that an animation moves, else around), around "
                       "(around the scene), camera, or a file with one key per line",
                       OptionType::views);
  table.template row<int>(&FrameSet::frames, "frames", "Number of frames, evenly over the path", {1, 100000, "frames"});
  table.template row<int>(&FrameSet::width, "width", "Width of the pictures", {16, 4096, "pixels"});
  table.template row<int>(&FrameSet::height, "height", "Height of the pictures", {16, 4096, "pixels"});
  table.template row<double>(&FrameSet::angle, "angle",
                             "Angle from the lower to the upper edge of the picture; a camera of the scene has its own",
                             {1, 170, "degrees"});
  table.template row<std::int64_t>(&FrameSet::seed, "seed", "Seed of the path around the scene", {.least = 0});
}

}  // namespace foredraw
