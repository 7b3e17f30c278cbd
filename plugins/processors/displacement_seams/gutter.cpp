#include "gutter.h"

#include <foredraw/geometry/finite.h>

#include "is_cancelled.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace foredraw {

namespace {

enum class State : std::uint8_t { free, waits, said };

class Gutter {
 public:
  Gutter(std::span<std::uint16_t> texels, const foredraw_height_map& map, const std::atomic<bool>* cancel)
      : texels_(texels), map_(map), cancel_(cancel), states_(texels.size(), State::free) {}

  void mark(const UvTriangle& uv) {
    UvTriangle at;
    for (std::size_t c = 0; c < 3; ++c) at[c] = uv[c] * glm::dvec2(map_.width, map_.height) - 0.5;
    glm::dvec2 least = at[0], most = at[0];
    for (const glm::dvec2& corner : at) {
      if (!is_finite(corner)) return;
      least = {std::min(least.x, corner.x), std::min(least.y, corner.y)};
      most = {std::max(most.x, corner.x), std::max(most.y, corner.y)};
    }
    if (most.x - least.x > map_.width || most.y - least.y > map_.height ||
        std::abs(least.x) + std::abs(least.y) > 1e6) {
      std::ranges::fill(states_, State::said);  // it goes around the map
      return;
    }
    const auto first = [](double from) { return static_cast<std::int32_t>(std::floor(from)); };
    for (std::int32_t y = first(least.y); y <= first(most.y) + 1 && !is_over(); ++y) {
      for (std::int32_t x = first(least.x); x <= first(most.x) + 1; ++x) {
        if (is_near(at, {x, y}))
          states_[number(foredraw_height_texel(x, map_.width, map_.wrap[0]),
                         foredraw_height_texel(y, map_.height, map_.wrap[1]))] = State::said;
      }
    }
  }

  std::size_t fill(int width) {
    std::vector<std::size_t> ring;
    for (std::size_t t = 0; t < states_.size(); ++t) {
      if (t % 65536 == 0 && is_over()) return 0;
      if (states_[t] == State::said) add_neighbours(t, ring);
    }
    std::size_t changed = 0;
    for (int i = 0; i < width && !ring.empty() && !is_over(); ++i) {
      std::vector<std::uint16_t> means;
      for (const std::size_t t : ring) means.push_back(mean_around(t));
      std::vector<std::size_t> next;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        changed += texels_[ring[k]] != means[k] ? 1 : 0;
        texels_[ring[k]] = means[k];
        states_[ring[k]] = State::said;
      }
      for (const std::size_t t : ring) add_neighbours(t, next);
      ring = std::move(next);
    }
    return changed;
  }

 private:
  bool is_over() const { return processors::displacement_seams::is_cancelled(cancel_); }

  /// Whether the triangle comes into the square of two texels around a texel's middle.
  static bool is_near(const UvTriangle& at, const glm::dvec2& middle) {
    const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
    const double turn = a.x * b.y - a.y * b.x < 0 ? -1 : 1;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec2 along = (at[(c + 1) % 3] - at[c]) * turn, away = middle - at[c];
      if (along.x * away.y - along.y * away.x + std::abs(along.x) + std::abs(along.y) < 0) return false;
    }
    return true;
  }

  std::size_t number(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * map_.width + x; }

  /// Beyond an edge that clamps there is none.
  std::optional<std::size_t> neighbour(std::size_t texel, int right, int down) const {
    const auto along = [](std::int64_t at, std::uint32_t size, std::uint8_t wrap) -> std::optional<std::uint32_t> {
      if (at >= 0 && at < size) return static_cast<std::uint32_t>(at);
      if (wrap != FOREDRAW_HEIGHT_REPEAT) return std::nullopt;
      return at < 0 ? size - 1 : 0;
    };
    const auto x = along(static_cast<std::int64_t>(texel % map_.width) + right, map_.width, map_.wrap[0]);
    const auto y = along(static_cast<std::int64_t>(texel / map_.width) + down, map_.height, map_.wrap[1]);
    if (!x || !y) return std::nullopt;
    return number(*x, *y);
  }

  template <class F>
  void for_neighbours(std::size_t texel, const F& with) const {
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        const auto other = neighbour(texel, right, down);
        if (other && *other != texel) with(*other);
      }
    }
  }

  void add_neighbours(std::size_t texel, std::vector<std::size_t>& ring) {
    for_neighbours(texel, [&](std::size_t other) {
      if (states_[other] != State::free) return;
      states_[other] = State::waits;
      ring.push_back(other);
    });
  }

  std::uint16_t mean_around(std::size_t texel) const {
    std::uint32_t sum = 0, count = 0;
    for_neighbours(texel, [&](std::size_t other) {
      if (states_[other] != State::said) return;
      sum += texels_[other];
      ++count;
    });
    return static_cast<std::uint16_t>((sum + count / 2) / count);
  }

  std::span<std::uint16_t> texels_;
  const foredraw_height_map& map_;
  const std::atomic<bool>* cancel_;
  std::vector<State> states_;
};

}  // namespace

std::size_t fill_gutter(std::span<std::uint16_t> texels, const foredraw_height_map& map,
                        std::span<const UvTriangle> triangles, int width, const std::atomic<bool>* cancel) {
  Gutter gutter(texels, map, cancel);
  for (const UvTriangle& triangle : triangles) gutter.mark(triangle);
  return gutter.fill(width);
}

}  // namespace foredraw
