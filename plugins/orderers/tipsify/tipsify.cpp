#include "tipsify.h"

#include <algorithm>

namespace foredraw {

namespace {

// What costs time here is waiting for memory, and the memory is laid out for the walk: a corner knows the other two
// vertices of its triangle, so that a fan reads its own corners, which lie together, and the state of the vertices
// around it, and never an index. A triangle is drawn exactly when one of its vertices has no live triangle left: no
// flag needed. Corner and Spoke have empty constructors, for arrays of them are written before they are read.

constexpr std::uint32_t none = ~std::uint32_t{0};

struct Vertex {
  std::uint32_t corners = 0;    ///< where its corners begin; they end where the next vertex's begin
  std::uint32_t live = 0;       ///< its corners in triangles not yet drawn
  std::uint32_t cached_at = 0;  ///< the time at which it last entered the cache
};

/// What a triangle of a fan has besides the vertex that the fan is around, in the triangle's own sequence.
struct Spoke {
  std::uint32_t first, second;

  Spoke() {}
  Spoke(std::uint32_t first, std::uint32_t second) : first(first), second(second) {}
};

struct Corner {
  std::uint32_t number;  ///< 3 * triangle + place in the triangle
  Spoke others;

  Corner() {}
  Corner(std::uint32_t number, Spoke others) : number(number), others(others) {}
};

/// The corners of every vertex, in triangle order, and how many there are. `vertices` has one past the last, which is
/// in no triangle: a corner that repeats one of its own triangle names it, and so counts as drawn. Answers with the
/// most corners of a vertex.
std::uint32_t find_corners(std::span<const std::uint32_t> indices, std::span<Vertex> vertices,
                           std::span<Corner> corners) {
  for (std::uint32_t v : indices) ++vertices[v].live;
  std::uint32_t end = 0;
  std::uint32_t most = 0;
  for (Vertex& v : vertices) {
    v.corners = end += v.live;
    most = std::max(most, v.live);
  }
  const auto nobody = static_cast<std::uint32_t>(vertices.size() - 1);
  for (std::size_t triangle = indices.size() / 3; triangle-- > 0;) {  // from the back, as lists are filled from theirs
    const auto number = static_cast<std::uint32_t>(3 * triangle);
    const std::uint32_t a = indices[number], b = indices[number + 1], c = indices[number + 2];
    corners[--vertices[c].corners] = c == a || c == b ? Corner{0, {nobody, nobody}} : Corner{number + 2, {a, b}};
    corners[--vertices[b].corners] = b == a ? Corner{0, {nobody, nobody}} : Corner{number + 1, {a, c}};
    corners[--vertices[a].corners] = Corner{number, {b, c}};
  }
  return most;
}

}  // namespace

void tipsify(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const TipsifyOptions& options, std::pmr::memory_resource& memory) {
  std::pmr::vector<Vertex> vertices(vertex_count + 1, &memory);
  std::pmr::vector<Corner> corners(indices.size(), &memory);
  std::pmr::vector<std::uint32_t> fan(find_corners(indices, vertices, corners) + std::size_t{1}, &memory);
  std::pmr::vector<Spoke> spokes(order.size() + 1, &memory);  // of drawn triangles, the latest last: the way back

  const auto cache_size = static_cast<std::uint32_t>(options.cache_size);
  std::uint32_t time = cache_size + 1;  // how many vertices have entered the cache
  std::uint32_t cursor = 0;             // all vertices before it are used up
  std::size_t drawn = 0;
  std::size_t seen = 0;  // spokes

  const auto age = [&](std::uint32_t v) { return time - vertices[v].cached_at; };
  // Whoever enters the cache will before long be fanned around, so that its corners are called for.
  const auto touch = [&](std::uint32_t v) {
    const bool misses = age(v) > cache_size;
    vertices[v].cached_at = misses ? time : vertices[v].cached_at;
    time += misses;
    __builtin_prefetch(&corners[vertices[v].corners]);
  };

  /// Draws what is left around a vertex; answers with the number of triangles.
  const auto draw_fan = [&](std::uint32_t center) {
    // Two corners in three are drawn already, with no pattern: they are written over instead of branched around.
    std::size_t count = 0;
    for (std::uint32_t i = vertices[center].corners; i < vertices[center + 1].corners; ++i) {
      const Corner& corner = corners[i];
      fan[count] = corner.number;
      spokes[seen + count] = corner.others;
      count += (vertices[corner.others.first].live != 0) & (vertices[corner.others.second].live != 0);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Spoke& spoke = spokes[seen + i];
      --vertices[spoke.first].live;
      --vertices[spoke.second].live;
      if (age(center) + 2 <= cache_size) {  // stays in the cache, whatever the spoke brings in
        touch(spoke.first);
        touch(spoke.second);
      } else {
        const std::uint32_t place = fan[i] % 3;
        if (place == 0) touch(center);
        touch(spoke.first);
        if (place == 1) touch(center);
        touch(spoke.second);
        if (place == 2) touch(center);
      }
      order[drawn + i] = fan[i] / 3;
    }
    vertices[center].live = 0;
    return count;
  };

  /// Of the vertices around a fan the one that entered the cache longest ago and would still be in it after its own
  /// fan, which brings in two vertices a triangle at most.
  const auto best_in_cache = [&](std::span<const Spoke> around) {
    std::uint32_t best = none;
    std::uint32_t best_rank = 0;
    const auto consider = [&](std::uint32_t v) {
      const std::uint32_t live = vertices[v].live;
      const std::uint32_t rank = live == 0 ? 0 : 1 + (age(v) + 2 * live <= cache_size ? age(v) : 0);
      best = rank > best_rank ? v : best;
      best_rank = std::max(rank, best_rank);
    };
    for (const Spoke& spoke : around) {
      consider(spoke.first);
      consider(spoke.second);
    }
    return best;
  };

  /// Where they are used up: the vertex seen last that still has triangles, else the next in input order.
  const auto skip_dead_end = [&] {
    for (; seen > 0; --seen) {
      if (vertices[spokes[seen - 1].second].live > 0) return spokes[seen - 1].second;
      if (vertices[spokes[seen - 1].first].live > 0) return spokes[seen - 1].first;
    }
    while (cursor < vertex_count && vertices[cursor].live == 0) ++cursor;
    return cursor < vertex_count ? cursor : none;
  };

  for (std::size_t last = 0;;) {  // the spokes from here on are the last fan's
    std::uint32_t center = best_in_cache({&spokes[last], seen - last});
    if (center == none) center = skip_dead_end();
    if (center == none) break;
    const std::size_t count = draw_fan(center);
    last = seen;
    seen += count;
    drawn += count;
  }
}

std::vector<std::uint32_t> tipsify(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const TipsifyOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  tipsify(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

}  // namespace foredraw
