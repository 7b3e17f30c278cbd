#pragma once
// Maps of heights as scene files can hold them.

#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/image.h>

#include <cstddef>
#include <string>
#include <variant>

namespace foredraw {

struct StorableMap {
  Image image;
  bool is_converted = false;
  std::size_t outside = 0;  ///< floats of the image that were no heights of 0 to 1: they are now the nearest one, or 0
};

/// PNG and JPEG, and what a stage made, as they are; of any other kind, such as OpenEXR, the heights in 16 bits, which
/// are written as a PNG. Or why it cannot be, as the rest of a sentence.
std::variant<StorableMap, std::string> storable_map(const Image& image, Analyses& analyses);

}  // namespace foredraw
