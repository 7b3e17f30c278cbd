#pragma once
// An animation of a file, and what it says at a time.

#include "gltf_document.h"

#include <string>
#include <vector>

namespace foredraw::bench {

class Clip {
 public:
  struct Track {
    std::size_t node = 0;
    std::string path;  ///< "translation", "rotation" or "scale"
    std::size_t width = 3;
    std::vector<float> times, values;
    bool moves = false;  ///< it says more than one value
  };

  /// Of float values, with linear or step keys. Throws std::runtime_error where the file has no animation of this name.
  Clip(const GltfDocument::Opened& file, const std::string& name);

  const std::vector<Track>& tracks() const { return tracks_; }
  double seconds() const { return seconds_; }

  /// What a track says at a time from 0 to seconds(), linear between keys, turns of length 1.
  static void add_value(const Track& track, double time, std::vector<float>& to);

 private:
  std::vector<Track> tracks_;
  double seconds_ = 0;
};

}  // namespace foredraw::bench
