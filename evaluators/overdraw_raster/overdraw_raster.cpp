#include "overdraw_raster.h"

#include <foredraw/analysis/fragments.h>
#include <foredraw/analysis/mesh_facts.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace foredraw {

namespace {

/// The depth buffer, and in it whose fragment each pixel shows.
class Picture {
 public:
  explicit Picture(int size) : depths_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  /// Counts for each part what passes and what stays.
  std::vector<OverdrawCount> draw(std::span<const PreparedPart> parts, const Camera& camera) {
    std::vector<OverdrawCount> counts(parts.size());
    std::fill(depths_.begin(), depths_.end(), nothing);
    const auto nobody = static_cast<std::uint32_t>(parts.size());
    if (parts.size() > 1) owners_.assign(depths_.size(), nobody);
    std::vector<std::uint64_t> lost(parts.size() + 1);
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      OverdrawCount& count = counts[part];
      rasteriser_.draw(parts[part], camera, [&](const Fragments& some) {
        if (parts.size() > 1) {
        for (std::size_t i = 0; i < some.count; ++i) {
          const auto depth = static_cast<std::int32_t>(some.depths[i]);
          std::int32_t& nearest = depths_[some.pixels[i]];
          std::uint32_t& owner = owners_[some.pixels[i]];
          const bool passes = depth < nearest;
          count.shaded += passes;
          count.ties += depth == nearest;
          lost[owner] += passes;
          nearest = passes ? depth : nearest;
          owner = passes ? part : owner;
        }
        } else if (some.is_row) {
        std::uint32_t shaded = 0, ties = 0, visible = 0;
        std::int32_t* row = depths_.data() + some.pixels[0];
        const std::uint32_t* depths = some.depths.data();
        for (std::size_t i = 0; i < some.count; ++i) {
          const std::int32_t depth = static_cast<std::int32_t>(depths[i]);
          const std::int32_t nearest = row[i];
          shaded += depth < nearest;
          ties += depth == nearest;
          visible += nearest == nothing;
          row[i] = std::min(depth, nearest);
        }
        count.shaded += shaded;
        count.ties += ties;
        count.visible += visible;
        } else {
        std::uint64_t shaded = 0, ties = 0, visible = 0;
        for (std::size_t i = 0; i < some.count; ++i) {
          const auto depth = static_cast<std::int32_t>(some.depths[i]);
          std::int32_t& nearest = depths_[some.pixels[i]];
          shaded += depth < nearest;
          ties += depth == nearest;
          visible += nearest == nothing;
          nearest = std::min(depth, nearest);
        }
        count.shaded += shaded;
        count.ties += ties;
        count.visible += visible;
        }
      });
    }
    if (parts.size() > 1) for (std::uint32_t part = 0; part < parts.size(); ++part) counts[part].visible = counts[part].shaded - lost[part];
    return counts;
  }

 private:
  static constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int32_t> depths_;
  std::vector<std::uint32_t> owners_;
  Rasteriser rasteriser_;
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

std::size_t count_non_finite_triangles(const RasterPart& part) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      if (is_finite(part.positions[part.indices[corner]])) continue;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace foredraw
