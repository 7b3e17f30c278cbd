#pragma once
#include <foredraw/page/page.h>

#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// Pictures and curves as the page's script reads them (script/frames.js).
struct ShownAttachments {
  std::string json;                   ///< with the numbers of pictures; empty: nobody attached anything
  std::vector<std::string> pictures;  ///< [number] a PNG, base64; equal ones are held once
};

/// Of the first most_displays files. Grouped by file, technique and number of frames, then by what it was attached to:
/// the input, or what a pipeline made. Films whose pictures would make the page hold more than `most_bytes` are told of
/// without them.
ShownAttachments shown_attachments(std::span<const Comparison> comparisons,
                                   std::size_t most_bytes = most_picture_bytes);

}  // namespace foredraw
