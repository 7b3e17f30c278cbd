#include <foredraw/overdraw/fragment_layers.h>

#include <foredraw/overdraw/fragments.h>
#include <foredraw/overdraw/private/layer_lists.h>

#include <algorithm>
#include <atomic>

namespace foredraw {

namespace {

/// A view's fragments, until they are sorted by pixel and depth.
class Capture {
 public:
  Capture(int size, std::size_t most_bytes)
      : size_(static_cast<std::size_t>(size)), ends_(size_ * size_), most_(most_bytes / sizeof(Fragment)) {}

  void draw(std::span<const PreparedPart> parts, const Camera& camera) {
    Rasteriser rasteriser;
    for (const PreparedPart& part : parts) {
      rasteriser.draw(part, camera, [&](const Fragments& some) {
        for (std::size_t i = 0; i < some.count; ++i) {
          if (fragments_.size() == most_) return void(is_full_ = true);
          fragments_.push_back({some.pixels[i], some.depths[i], some.triangles[i]});
          ++ends_[some.pixels[i]];
        }
      });
    }
  }

  bool is_full() const { return is_full_; }

  ViewLayers layers(std::size_t triangles) && {
    OverdrawCount always;
    const std::vector<std::uint64_t> sorted = by_pixel_and_depth(always);
    LayerLists lists;
    std::vector<std::uint32_t> list;
    std::size_t first = 0;
    for (const std::size_t end : ends_) {
      if (end == first) continue;
      list.clear();
      for (std::size_t i = first; i < end; ++i) {
        const bool is_tied = i > first && sorted[i] >> 32 == sorted[i - 1] >> 32;
        list.push_back(static_cast<std::uint32_t>(sorted[i]) | (is_tied ? tie_bit<std::uint32_t> : 0));
      }
      lists.add(list, 1);
      first = end;
    }
    return std::move(lists).laid_out(triangles, always);
  }

 private:
  struct Fragment {
    std::uint32_t pixel, depth, triangle;
  };

  /// Depth in the upper half, triangle in the lower; pixel after pixel up to ends_[pixel], those with one layer left
  /// out and counted.
  std::vector<std::uint64_t> by_pixel_and_depth(OverdrawCount& always) {
    std::size_t sum = 0;
    std::vector<std::uint8_t> has_one(ends_.size(), 0);
    for (std::size_t pixel = 0; pixel < ends_.size(); ++pixel) {
      const std::size_t count = ends_[pixel];
      always.visible += count > 0 ? 1 : 0;
      always.shaded += count == 1 ? 1 : 0;
      has_one[pixel] = count == 1 ? 1 : 0;
      ends_[pixel] = sum;  // for now where the pixel begins
      if (count > 1) sum += count;
    }
    std::vector<std::uint64_t> sorted(sum);
    for (const auto& [pixel, depth, triangle] : fragments_) {
      if (has_one[pixel] == 0) sorted[ends_[pixel]++] = std::uint64_t{depth} << 32 | triangle;
    }
    fragments_ = {};
    std::size_t first = 0;
    for (const std::size_t end : ends_) {
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.begin() + static_cast<std::ptrdiff_t>(end));
      first = end;
    }
    return sorted;
  }

  std::size_t size_;
  std::vector<std::size_t> ends_;  // [pixel], first the number of its fragments
  std::vector<Fragment> fragments_;
  std::size_t most_;
  bool is_full_ = false;
};

}  // namespace

std::optional<FragmentLayers> fragment_layers(std::span<const RasterPart> parts, const Views& views,
                                              const Executor& executor, std::size_t most_bytes) {
  const std::vector<PreparedPart> ready = prepared(parts);
  FragmentLayers layers;
  for (const RasterPart& part : parts) layers.owners += part.triangle_count();
  layers.views.resize(views.views.size());
  // Sums only grow, so whether the views exceed the limit does not depend on which of them is the last.
  std::atomic<std::size_t> bytes = 0;
  std::atomic<bool> is_too_much = false;
  executor.for_each(views.views.size(), [&](std::size_t view) {
    if (is_too_much) return;
    Capture capture(views.size, most_bytes);
    capture.draw(ready, Camera(views.views[view], views.size));
    const bool is_full = capture.is_full();
    if (!is_full) layers.views[view] = std::move(capture).layers(layers.owners);
    const std::size_t so_far = bytes += bytes_of(layers.views[view]);
    if (is_full || so_far > most_bytes) is_too_much = true;
  });
  if (is_too_much) return std::nullopt;
  return layers;
}

}  // namespace foredraw
