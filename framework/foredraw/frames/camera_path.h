#pragma once
// The way that a camera takes through a scene, spelled alike in pipelines and option lists.

#include <foredraw/frames/frame_camera.h>
#include <foredraw/frames/frame_scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// Frames as a pipeline spells them.
struct FrameSet {
  /// auto: the first camera of the scene that an animation moves, else around the scene; around; camera; a file: its
  /// path, with a dot or a slash in it (read_camera_keys()).
  std::string path = "auto";
  int frames = 120;   ///< evenly over the whole path
  int width = 640;    ///< pixels
  int height = 360;   ///< pixels
  double angle = 60;  ///< degrees from the lower to the upper edge of the picture; a camera of the scene has its own
  std::int64_t seed = 0;  ///< of the path around the scene

  FrameSize size() const { return {width, height}; }
  friend bool operator==(const FrameSet&, const FrameSet&) = default;
};

struct PathFrame {
  double seconds = 0;  ///< in the scene's clips
  FrameCamera camera;
};
using CameraPath = std::vector<PathFrame>;

/// Whether the word of a path is the path of a file: it has a dot or a slash.
bool is_camera_file(std::string_view path);

/// What is wrong with the set as it is spelled, or nothing. No file is read.
std::optional<std::string> mistake_in(const FrameSet& set);

/// A camera at one moment: it looks from the eye at the target.
struct CameraKey {
  double seconds = 0;
  glm::dvec3 eye{0}, target{0};
};

/// Reads keys from a text file, one a line, times rising, empty lines and what follows # left out:
///   SECONDS EYE_X EYE_Y EYE_Z TARGET_X TARGET_Y TARGET_Z
/// Or says what is wrong: "walk.txt:3: ...".
std::variant<std::vector<CameraKey>, std::string> read_camera_keys(const std::string& path);

/// The frames of a set; or why there are none ("the scene has no camera that an animation moves"). Between keys the
/// camera moves evenly. The path around the scene is a closed curve through eight places by the seed, some of them near
/// and some far, that looks at the middle of it all. The same bits on every machine.
std::variant<CameraPath, std::string> camera_path(const FrameScene& scene, const FrameSet& set);

}  // namespace foredraw
