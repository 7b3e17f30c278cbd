#include "overdraw_raster.h"

#include <foredraw/overdraw/fragments.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace foredraw {

namespace {

/// The depth buffer. Where there are several parts, it also says whose fragment each pixel shows.
class Picture {
 public:
  explicit Picture(int size) : depths_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  /// Counts for each part what passes and what stays.
  std::vector<OverdrawCount> draw(std::span<const PreparedPart> parts, const Camera& camera) {
    std::fill(depths_.begin(), depths_.end(), nothing);
    if (parts.size() == 1) {
      OverdrawCount count;
      rasteriser_.draw(
          parts[0], camera, [&](const Fragments& some) { some.is_row ? put_row(some, count) : put(some, count); },
          [&](const Fragments& some) { count_discarded(some, count); });
      return {count};
    }
    const auto nobody = static_cast<std::uint32_t>(parts.size());
    owners_.assign(depths_.size(), nobody);
    lost_.assign(parts.size() + 1, 0);
    std::vector<OverdrawCount> counts(parts.size());
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      rasteriser_.draw(
          parts[part], camera, [&](const Fragments& some) { put(some, part, counts[part]); },
          [&](const Fragments& some) { count_discarded(some, counts[part]); });
    }
    for (std::size_t part = 0; part < parts.size(); ++part) counts[part].visible = counts[part].shaded - lost_[part];
    return counts;
  }

 private:
  // Depths are below 2^24. Signed, because that is what every processor compares several of at once.
  static constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::max();

  // No branches in these loops: whether a fragment passes is hard to foresee.

  void put(const Fragments& some, OverdrawCount& count) {
    OverdrawCount sum;
    for (std::size_t i = 0; i < some.count; ++i) {
      const auto depth = static_cast<std::int32_t>(some.depths[i]);
      std::int32_t& nearest = depths_[some.pixels[i]];
      sum.shaded += depth < nearest ? 1 : 0;
      sum.ties += depth == nearest ? 1 : 0;
      sum.visible += nearest == nothing ? 1 : 0;
      nearest = std::min(depth, nearest);
    }
    count += sum;
  }

  /// The same; the compiler does it with vector registers.
  void put_row(const Fragments& row, OverdrawCount& count) {
    std::int32_t* const pixels = &depths_[row.pixels[0]];
    const std::uint32_t* const depths = row.depths.data();
    std::uint32_t shaded = 0, ties = 0, visible = 0;
    for (std::size_t i = 0; i < row.count; ++i) {
      const auto depth = static_cast<std::int32_t>(depths[i]);
      const std::int32_t nearest = pixels[i];
      shaded += depth < nearest ? 1 : 0;
      ties += depth == nearest ? 1 : 0;
      visible += nearest == nothing ? 1 : 0;
      pixels[i] = std::min(depth, nearest);
    }
    count += {shaded, visible, ties, 0};
  }

  void put(const Fragments& some, std::uint32_t part, OverdrawCount& count) {
    for (std::size_t i = 0; i < some.count; ++i) {
      const auto depth = static_cast<std::int32_t>(some.depths[i]);
      std::int32_t& nearest = depths_[some.pixels[i]];
      std::uint32_t& owner = owners_[some.pixels[i]];
      const bool passes = depth < nearest;
      count.shaded += passes ? 1 : 0;
      count.ties += depth == nearest ? 1 : 0;
      lost_[owner] += passes ? 1 : 0;
      nearest = std::min(depth, nearest);
      owner = passes ? part : owner;
    }
  }

  void count_discarded(const Fragments& some, OverdrawCount& count) const {
    for (std::size_t i = 0; i < some.count; ++i) {
      count.discarded += static_cast<std::int32_t>(some.depths[i]) < depths_[some.pixels[i]] ? 1 : 0;
    }
  }

  std::vector<std::int32_t> depths_;
  std::vector<std::uint32_t> owners_;
  std::vector<std::uint64_t> lost_;  // [owner], fragments that passed and did not stay
  Rasteriser rasteriser_;
};

}  // namespace

OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views, const Executor& executor) {
  const std::vector<PreparedPart> ready = prepared(parts);
  const std::size_t count = views.views.size();
  OverdrawCounts counts(parts.size(), std::vector<OverdrawCount>(count));
  // Each share has a picture of its own, so there are few: some more than threads, for those that end early, and so
  // many that a share of many views ends soon when the run is cancelled.
  const std::size_t shares = std::min(count, std::max(4 * static_cast<std::size_t>(executor.threads()), count / 64));
  executor.for_each(shares, [&](std::size_t share) {
    Picture picture(views.size);
    for (std::size_t view = count * share / shares; view < count * (share + 1) / shares; ++view) {
      const std::vector<OverdrawCount> of_view = picture.draw(ready, Camera(views.views[view], views.size));
      for (std::size_t part = 0; part < parts.size(); ++part) counts[part][view] = of_view[part];
    }
  });
  return counts;
}

OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views) {
  return overdraw_raster(parts, views, Executor(1));
}

}  // namespace foredraw
