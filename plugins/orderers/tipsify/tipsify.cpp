#include "tipsify.h"

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

// What costs time here is waiting for memory, and the memory is laid out for the walk: a corner knows the other two
// vertices of its triangle, so that a fan reads its own corners, which lie together, and the state of the vertices
// around it, and never an index. A triangle is drawn exactly when one of its vertices has no live triangle left: no
// flag needed. The way back from a dead end is what has been drawn, backwards: no stack of vertices needed.

constexpr std::uint32_t none = ~std::uint32_t{0};

/// What a vertex is asked for lies in one word: below, its corners in triangles not yet drawn; above, the time at which
/// it last entered the cache. `Word` is 32 bits (8 live, 24 of time) wherever that is enough, or 64 (32 and 32).
template <class Word>
struct Vertex {
  std::uint32_t corners = 0;  ///< where its corners begin; they end where the next vertex's begin
  Word state = 0;

  static constexpr int time_from = sizeof(Word) == 4 ? 8 : 32;
  static constexpr Word tick = Word{1} << time_from;
  static constexpr Word live_mask = tick - 1;

  Word live() const { return state & live_mask; }
  /// `now` has all bits of the count set: then nothing is borrowed from the difference of times.
  Word age(Word now) const { return (now - state) >> time_from; }
  void enter(Word now) { state += (now - state) & ~live_mask; }
};

/// The other two vertices of a corner's triangle, in the triangle's own sequence; the top bit of each says that it
/// comes before the corner's own.
struct Spoke {
  std::uint32_t first_bits, second_bits;

  Spoke() {}  // arrays of corners are written before they are read
  Spoke(std::uint32_t first_bits, std::uint32_t second_bits) : first_bits(first_bits), second_bits(second_bits) {}

  static constexpr std::uint32_t before = std::uint32_t{1} << 31;
  std::uint32_t first() const { return first_bits & ~before; }
  std::uint32_t second() const { return second_bits & ~before; }
  std::uint32_t first_is_before() const { return first_bits >> 31; }    ///< 1 or 0
  std::uint32_t second_is_before() const { return second_bits >> 31; }  ///< 1 or 0
};

/// The answer as indices: a spoke and what it is around are the whole triangle.
struct NewIndices {
  using Corner = Spoke;
  static Corner corner(std::uint32_t, Spoke spoke) { return spoke; }

  std::uint32_t* indices;

  void draw(std::size_t place, std::uint32_t center, Corner corner) {
    std::uint32_t* const triangle = indices + 3 * place;
    triangle[1 - corner.first_is_before()] = corner.first();
    triangle[2 - corner.second_is_before()] = corner.second();
    triangle[corner.first_is_before() + corner.second_is_before()] = center;
  }
};

/// The answer as an order: a corner has its triangle's number besides. The indices are written all the same, for the
/// way back reads them.
struct NewOrder : NewIndices {
  struct Corner : Spoke {
    std::uint32_t triangle;
    Corner() {}
    Corner(std::uint32_t triangle, Spoke spoke) : Spoke(spoke), triangle(triangle) {}
  };
  static Corner corner(std::uint32_t triangle, Spoke spoke) { return {triangle, spoke}; }

  std::uint32_t* order;

  void draw(std::size_t place, std::uint32_t center, const Corner& corner) {
    NewIndices::draw(place, center, corner);
    order[place] = corner.triangle;
  }
};

/// Whether it is too large for the processor's second-level cache, so that it pays to call for what will be wanted.
template <class T>
bool is_far(std::span<T> memory) {
  return memory.size_bytes() > (1u << 19);
}

/// Counts the corners of each vertex and gives them room; answers with the most that one has. `vertices` has one past
/// the last, in no triangle. `corners` is where the room ends, until find_corners() has filled it.
template <class Word>
std::uint32_t make_room(std::span<const std::uint32_t> indices, std::span<Vertex<Word>> vertices) {
  std::size_t i = 0;
  if (is_far(vertices)) {
    for (; i + 64 < indices.size(); ++i) {
      __builtin_prefetch(&vertices[indices[i + 64]], 1);
      ++vertices[indices[i]].corners;
    }
  }
  for (; i < indices.size(); ++i) ++vertices[indices[i]].corners;
  std::uint32_t end = 0;
  std::uint32_t most = 0;
  for (Vertex<Word>& v : vertices) {
    const std::uint32_t count = v.corners;
    most = std::max(most, count);
    v.state = count;
    v.corners = end += count;
  }
  return most;
}

/// The corners of every vertex, in triangle order. A corner that repeats one of its own triangle names the vertex past
/// the last, which has no live triangle, and so counts as drawn.
template <class Word, class Answer>
void find_corners(std::span<const std::uint32_t> indices, std::span<Vertex<Word>> vertices,
                  std::span<typename Answer::Corner> corners) {
  const auto nobody = static_cast<std::uint32_t>(vertices.size() - 1);
  const Spoke repeated(nobody, nobody);
  const bool is_waited_for = is_far(corners);
  for (std::size_t triangle = indices.size() / 3; triangle-- > 0;) {  // from the back, as room is filled from its end
    if (is_waited_for && triangle >= 24) {
      // The vertices of a triangle to come are called for, and twelve triangles later the room that they name.
      for (const std::uint32_t v : indices.subspan(3 * (triangle - 24), 3)) __builtin_prefetch(&vertices[v], 1);
      for (const std::uint32_t v : indices.subspan(3 * (triangle - 12), 3)) {
        __builtin_prefetch(corners.data() + vertices[v].corners, 1);
      }
    }
    const std::uint32_t a = indices[3 * triangle], b = indices[3 * triangle + 1], c = indices[3 * triangle + 2];
    const auto add = [&](std::uint32_t v, bool repeats, Spoke spoke) {
      corners[--vertices[v].corners] = Answer::corner(static_cast<std::uint32_t>(triangle), repeats ? repeated : spoke);
    };
    add(c, c == a || c == b, {a | Spoke::before, b | Spoke::before});
    add(b, b == a, {a | Spoke::before, c});
    add(a, false, {b, c});
  }
}

/// False, with nothing done, where a vertex has more corners than Word can count.
template <class Word, class Answer>
bool draw_fans(Answer answer, std::span<const std::uint32_t> indices, std::size_t vertex_count,
               std::uint32_t cache_size, std::pmr::memory_resource& memory) {
  using Vertex = foredraw::Vertex<Word>;
  using Corner = typename Answer::Corner;
  std::pmr::vector<Vertex> vertices(vertex_count + 1, &memory);
  const std::uint32_t most = make_room<Word>(indices, vertices);
  if (most > Vertex::live_mask) return false;
  std::pmr::vector<Corner> corners(indices.size(), &memory);
  find_corners<Word, Answer>(indices, vertices, corners);
  std::pmr::vector<Corner> fan(most + std::size_t{1}, &memory);  // the one that is drawn

  Word now = (cache_size + Word{1}) * Vertex::tick | Vertex::live_mask;  // a tick for each vertex that enters the cache
  std::size_t drawn = 0;                                                 // triangles
  std::uint32_t cursor = 0;                                              // all vertices before it are used up

  const auto is_live = [&](std::uint32_t v) { return vertices[v].live() != 0; };
  // Whoever enters the cache will before long be fanned around, so that its corners are called for.
  const auto touch = [&](std::uint32_t v) {
    if (vertices[v].age(now) <= cache_size) return;
    vertices[v].enter(now);
    now += Vertex::tick;
    __builtin_prefetch(&corners[vertices[v].corners]);
  };

  /// Draws what is left around a vertex; answers with the number of triangles, which `fan` then holds.
  const auto draw_fan = [&](std::uint32_t center) {
    // Two corners in three are drawn already, with no pattern: they are written over instead of branched around.
    std::size_t count = 0;
    for (std::uint32_t i = vertices[center].corners; i < vertices[center + 1].corners; ++i) {
      const Corner corner = corners[i];
      fan[count] = corner;
      count += std::size_t{is_live(corner.first())} & std::size_t{is_live(corner.second())};
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Corner& corner = fan[i];
      --vertices[corner.first()].state;
      --vertices[corner.second()].state;
      if (vertices[center].age(now) + 2 <= cache_size) {  // stays in the cache, whatever the spoke brings in
        touch(corner.first());
        touch(corner.second());
      } else {
        if (!corner.first_is_before()) touch(center);
        touch(corner.first());
        if (corner.first_is_before() && !corner.second_is_before()) touch(center);
        touch(corner.second());
        if (corner.second_is_before()) touch(center);
      }
      answer.draw(drawn++, center, corner);
    }
    vertices[center].state &= ~Vertex::live_mask;
    return count;
  };

  /// Of the vertices around the fan the one that entered the cache longest ago and would still be in it after its own
  /// fan, which brings in two vertices a triangle at most.
  const auto best_in_cache = [&](std::size_t count) {
    std::uint32_t best = none;
    Word best_rank = 0;
    const auto consider = [&](std::uint32_t v) {
      const Word live = vertices[v].live();
      if (live == 0) return;
      const Word age = vertices[v].age(now);
      const Word rank = age + 2 * live <= cache_size ? age + 1 : 1;
      if (rank <= best_rank) return;
      best = v;
      best_rank = rank;
    };
    for (std::size_t i = 0; i < count; ++i) {
      consider(fan[i].first());
      consider(fan[i].second());
    }
    return best;
  };

  /// Corners from `back_to` to `from` have been looked at, and none of them is live nor ever will be.
  struct Used {
    std::uint32_t back_to, from;
  };
  std::pmr::vector<Used> used(&memory);

  /// Where those are used up: the vertex drawn last that still has triangles, else the next in input order.
  const auto skip_dead_end = [&] {
    const auto end = static_cast<std::uint32_t>(3 * drawn);
    for (std::uint32_t back = end;;) {
      const std::uint32_t stop = used.empty() ? 0 : used.back().from;
      while (back > stop && !is_live(answer.indices[back - 1])) --back;
      if (back > stop || used.empty()) {
        if (back < end) used.push_back({back, end});
        if (back > 0) return answer.indices[back - 1];
        break;
      }
      back = used.back().back_to;
      used.pop_back();
    }
    while (cursor < vertex_count && !is_live(cursor)) ++cursor;
    return cursor < vertex_count ? cursor : none;
  };

  for (std::size_t count = 0;;) {
    std::uint32_t center = best_in_cache(count);
    if (center == none) center = skip_dead_end();
    if (center == none) return true;
    count = draw_fan(center);
  }
}

template <class Answer>
void draw_fans_of(Answer answer, std::span<const std::uint32_t> indices, std::size_t vertex_count,
                  const TipsifyOptions& options, std::pmr::memory_resource& memory) {
  const auto cache_size = static_cast<std::uint32_t>(options.built_for.value_or(options.cache_size));
  const bool is_short = indices.size() + cache_size + 3 < std::size_t{1} << 24;  // time: every index may miss
  if (is_short && draw_fans<std::uint32_t>(answer, indices, vertex_count, cache_size, memory)) return;
  draw_fans<std::uint64_t>(answer, indices, vertex_count, cache_size, memory);
}

}  // namespace

void tipsify(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
             const TipsifyOptions& options, std::pmr::memory_resource& memory) {
  if (!tipsify_takes(indices.size(), vertex_count, options)) return std::iota(order.begin(), order.end(), 0u);
  std::pmr::vector<std::uint32_t> ordered(indices.size(), &memory);
  draw_fans_of(NewOrder{{ordered.data()}, order.data()}, indices, vertex_count, options, memory);
}

void tipsify_indices(std::span<std::uint32_t> ordered, std::span<const std::uint32_t> indices, std::size_t vertex_count,
                     const TipsifyOptions& options, std::pmr::memory_resource& memory) {
  if (!tipsify_takes(indices.size(), vertex_count, options)) {
    std::ranges::copy(indices, ordered.begin());
    return;
  }
  draw_fans_of(NewIndices{ordered.data()}, indices, vertex_count, options, memory);
}

std::vector<std::uint32_t> tipsify(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                   const TipsifyOptions& options) {
  std::vector<std::uint32_t> order(indices.size() / 3);
  tipsify(order, indices, vertex_count, options, *std::pmr::get_default_resource());
  return order;
}

std::vector<std::uint32_t> tipsify_indices(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                                           const TipsifyOptions& options) {
  std::vector<std::uint32_t> ordered(indices.size());
  tipsify_indices(ordered, indices, vertex_count, options, *std::pmr::get_default_resource());
  return ordered;
}

}  // namespace foredraw
