#pragma once
// Rows of texels as a sampler sees them: the image and what lies beyond its edges.

#include <foredraw/image/alpha_image.h>

#include <algorithm>
#include <optional>
#include <span>

namespace foredraw::processors::particle_trim {

/// The first and the last texel of a row that show.
struct Extent {
  std::int64_t first, last;
};

class TexelRow {
 public:
  TexelRow(const AlphaImage& image, const Sampling& sampling, std::int64_t row)
      : texels_(std::span(image.alpha)
                    .subspan(std::size_t{wrapped(row, image.height, sampling.wrap[1])} * image.width, image.width)),
        wrap_(sampling.wrap[0]) {}

  std::uint16_t operator[](std::int64_t column) const {
    const bool is_inside = column >= 0 && column < width();
    return texels_[is_inside ? static_cast<std::size_t>(column)
                             : wrapped(column, static_cast<std::uint32_t>(texels_.size()), wrap_)];
  }

  /// Among columns `from` to `to`, both included, those above the limit.
  std::optional<Extent> extent(std::int64_t from, std::int64_t to, std::uint16_t limit) const {
    const std::int64_t first = first_above(from, to, limit);
    if (first > to) return std::nullopt;
    std::int64_t last = to;
    while (last > first) {
      // Whole runs that do not show are skipped at once; a loop without a way out of it is one of vectors.
      if (last < width() && last - run >= std::max<std::int64_t>(first, -1) && !any_above(last - run + 1, limit)) {
        last -= run;
      } else if ((*this)[last] > limit) {
        break;
      } else {
        --last;
      }
    }
    return Extent{first, last};
  }

 private:
  static constexpr std::int64_t run = 32;

  std::int64_t width() const { return static_cast<std::int64_t>(texels_.size()); }

  bool any_above(std::int64_t from, std::uint16_t limit) const {
    std::uint16_t most = 0;
    for (std::int64_t i = 0; i < run; ++i) most = std::max(most, texels_[static_cast<std::size_t>(from + i)]);
    return most > limit;
  }

  std::int64_t first_above(std::int64_t from, std::int64_t to, std::uint16_t limit) const {
    while (from <= to) {
      if (from >= 0 && from + run <= std::min(to + 1, width()) && !any_above(from, limit)) {
        from += run;
      } else if ((*this)[from] > limit) {
        break;
      } else {
        ++from;
      }
    }
    return from;
  }

  std::span<const std::uint16_t> texels_;
  Wrap wrap_;
};

}  // namespace foredraw::processors::particle_trim
