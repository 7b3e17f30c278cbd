#pragma once
// What a technique found where a figure is not enough: pictures and curves, for the page of a run.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// Pixels along an edge of a picture at most.
inline constexpr int largest_picture = 4096;

/// Pictures of one thing, frame after frame. A picture that stands alone is a film of one frame.
struct Film {
  std::string name;     ///< what is seen: "levels", or the method that is watched: "optimization"
  std::string caption;  ///< for people: what the colours mean; may be empty
  int width = 0;        ///< pixels, 1 to largest_picture; a page has room for four films of 256 beside each other
  int height = 0;
  std::vector<std::vector<std::uint8_t>> frames;  ///< [frame] red, green, blue (sRGB) of each pixel, rows from the top
};

/// Curves over frames.
struct Chart {
  /// A technique's lines of equal name have one colour in all its charts, and its film of that name is marked with it.
  struct Line {
    std::string name;            ///< the method: "optimization"
    std::vector<double> values;  ///< [frame]; where it is not finite, the line has a gap
  };
  /// What values are held against, a dashed line across the chart.
  struct Mark {
    std::string name;  ///< "budget"
    double value = 0;  ///< in the unit of the lines; finite
  };

  std::string name;         ///< its title: "frame time"
  std::string caption;      ///< for people: how to read it; may be empty
  std::string x = "frame";  ///< what stands along it, counted from 1
  std::string y;            ///< what the values are: "time of a frame"
  std::string unit;         ///< of the values and the mark: "ms"; empty: they have none
  std::vector<Line> lines;  ///< one or more, with as many values each
  std::optional<Mark> mark;
};

using Attachment = std::variant<Film, Chart>;

const std::string& name_of(const Attachment& attachment);

/// How many frames a film has, and how many values each line of a chart.
std::size_t frames_of(const Attachment& attachment);

/// Why it can not be shown, as the end of a sentence: no name or one twice, no frame, a frame that is not of the size,
/// lines of different lengths, a mark that is not finite. O(frames + lines squared).
std::optional<std::string> mistake_in(const Attachment& attachment);

}  // namespace foredraw
