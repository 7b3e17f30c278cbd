#include "forsyth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace foredraw {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr std::size_t largest_cache = 64;

/// Of a vertex's triangles so many are looked at in one step. More have only vertices of huge valence, whose boost is
/// next to nothing: their triangles differ by the other two corners, and are found from these where they are cached.
constexpr std::uint32_t looked_at = 64;

/// The paper's constants: what a vertex is worth at its place in the cache and with its triangles left. Square roots
/// and divisions round alike on every processor, which powers do not.
struct Scores {
  std::array<float, largest_cache> of_place{};

  explicit Scores(std::size_t cache_size) {
    for (std::size_t place = 0; place < cache_size; ++place) {
      if (place < 3) {
        of_place[place] = 0.75f;  // the last triangle's, alike, so that it is not spun on the spot
      } else {
        const double left = 1 - static_cast<double>(place - 3) / static_cast<double>(cache_size - 3);
        of_place[place] = static_cast<float>(left * std::sqrt(left));  // to the power of 1.5
      }
    }
  }

  /// Vertices with few triangles left are got rid of first, so that none is left alone and has to be fetched again.
  static float of_live(std::uint32_t live) { return live == 0 ? 0 : 2 / std::sqrt(static_cast<float>(live)); }
};

/// What is still to be drawn: of each vertex the corners of its live triangles, in a list that shrinks in place.
struct LiveCorners {
  std::pmr::vector<std::uint32_t> begin;    // of each vertex: where its list begins
  std::pmr::vector<std::uint32_t> count;    // of each vertex: corners left
  std::pmr::vector<std::uint32_t> corners;  // the lists
  std::pmr::vector<std::uint32_t> slots;    // of each corner: where it is in its list

  LiveCorners(std::span<const std::uint32_t> indices, std::size_t vertex_count, std::pmr::memory_resource& memory)
      : begin(vertex_count, 0, &memory),
        count(vertex_count, 0, &memory),
        corners(indices.size(), 0, &memory),
        slots(indices.size(), 0, &memory) {
    for (std::uint32_t v : indices) ++count[v];
    std::uint32_t end = 0;
    for (std::size_t v = 0; v < vertex_count; ++v) begin[v] = std::exchange(end, end + count[v]);
    std::fill(count.begin(), count.end(), 0u);
    for (std::uint32_t corner = 0; corner < indices.size(); ++corner) {
      const std::uint32_t v = indices[corner];
      put(corner, begin[v] + count[v]++);
    }
  }

  std::span<const std::uint32_t> of(std::uint32_t v) const { return std::span(corners).subspan(begin[v], count[v]); }

  void remove(std::uint32_t corner, std::uint32_t v) { put(corners[begin[v] + --count[v]], slots[corner]); }

 private:
  void put(std::uint32_t corner, std::uint32_t slot) {
    corners[slot] = corner;
    slots[corner] = slot;
  }
};

/// The vertices drawn last, the latest first.
struct LruCache {
  std::array<std::uint32_t, largest_cache + 3> vertices;  // three more than fit, while a triangle moves in
  std::size_t count = 0;

  /// Moves the corners of a triangle to the front. What no longer fits is still behind the others until cut off.
  void draw(std::span<const std::uint32_t> triangle) {
    const auto old = vertices;
    const std::size_t old_count = std::exchange(count, 0);
    const auto append = [&](std::uint32_t v, std::size_t among) {
      const auto end = vertices.begin() + static_cast<std::ptrdiff_t>(among);
      if (std::find(vertices.begin(), end, v) == end) vertices[count++] = v;
    };
    for (std::uint32_t v : triangle) append(v, count);
    const std::size_t corners = count;
    for (std::size_t i = 0; i < old_count; ++i) append(old[i], corners);
  }
};

}  // namespace

void forsyth(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const ForsythOptions& options, std::pmr::memory_resource& memory) {
  const auto cache_size = static_cast<std::size_t>(options.cache_size);
  const Scores scores(cache_size);
  LiveCorners live(indices, vertex_count, memory);
  std::pmr::vector<float> score(vertex_count, 0, &memory);
  for (std::size_t v = 0; v < vertex_count; ++v) score[v] = Scores::of_live(live.count[v]);
  std::pmr::vector<bool> drawn(order.size(), false, &memory);
  LruCache cache;
  std::uint32_t cursor = 0;  // all triangles before it are drawn

  std::uint32_t next = none;
  for (std::uint32_t& place : order) {
    if (next == none) {  // no triangle left near the cache: on in input order
      while (drawn[cursor]) ++cursor;
      next = cursor;
    }
    place = next;
    drawn[next] = true;
    const auto triangle = indices.subspan(3 * std::size_t{next}, 3);
    for (std::uint32_t k = 0; k < 3; ++k) live.remove(3 * next + k, triangle[k]);
    cache.draw(triangle);
    for (std::size_t i = 0; i < cache.count; ++i) {
      const std::uint32_t v = cache.vertices[i];
      score[v] = Scores::of_live(live.count[v]) + (i < cache_size ? scores.of_place[i] : 0);
    }
    cache.count = std::min(cache.count, cache_size);

    next = none;
    float best = 0;
    for (std::size_t i = 0; i < cache.count; ++i) {
      const auto corners = live.of(cache.vertices[i]);
      for (std::uint32_t corner : corners.first(std::min<std::size_t>(corners.size(), looked_at))) {
        const std::uint32_t candidate = corner / 3;
        const auto v = indices.subspan(3 * std::size_t{candidate}, 3);
        const float sum = score[v[0]] + score[v[1]] + score[v[2]];
        if (next != none && sum <= best) continue;
        next = candidate;
        best = sum;
      }
    }
  }
}

std::vector<std::uint32_t> forsyth(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const ForsythOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  forsyth(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

}  // namespace foredraw
