#include "overdraw_raster.h"

#include <foredraw/analysis/fragments.h>

#include <algorithm>
#include <vector>

namespace foredraw {

namespace {

constexpr std::uint32_t nobody = ~std::uint32_t{0};

/// The depth buffer, and in it whose fragment each pixel shows.
class Picture {
 public:
  explicit Picture(int size) : size_(size), pixels_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  /// Counts for each part what passes and what stays.
  std::vector<OverdrawCount> draw(std::span<const PreparedPart> parts, const Camera& camera) {
    counts_.assign(parts.size(), {});
    std::fill(pixels_.begin(), pixels_.end(), Pixel{});
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      for_each_fragment(
          parts[part], camera, corners_,
          [&](std::int32_t x, std::int32_t y, std::uint32_t depth, std::uint32_t) { put(x, y, depth, part); });
    }
    return counts_;
  }

 private:
  struct Pixel {
    std::uint32_t depth = ~std::uint32_t{0};
    std::uint32_t part = nobody;
  };

  void put(std::int32_t x, std::int32_t y, std::uint32_t depth, std::uint32_t part) {
    Pixel& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(x)];
    OverdrawCount& count = counts_[part];
    if (depth < pixel.depth) {
      ++count.shaded;
      ++count.visible;
      if (pixel.part != nobody) --counts_[pixel.part].visible;
      pixel = {depth, part};
    } else if (depth == pixel.depth) {
      ++count.ties;
    }
  }

  int size_;
  std::vector<Pixel> pixels_;
  std::vector<Corner> corners_;
  std::vector<OverdrawCount> counts_;
};

}  // namespace

OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views) {
  const std::vector<PreparedPart> ready = prepared(parts);
  OverdrawCounts counts(parts.size());
  Picture picture(views.size);
  for (const View& view : views.views) {
    const auto of_view = picture.draw(ready, Camera(view, views.size));
    for (std::size_t part = 0; part < parts.size(); ++part) counts[part].push_back(of_view[part]);
  }
  return counts;
}

}  // namespace foredraw
