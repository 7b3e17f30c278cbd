#include "codec_order.h"

#include <algorithm>
#include <array>
#include <optional>

namespace foredraw {

namespace {

constexpr std::size_t remembered = 15;  // of the codec's 16 edges; the last one has no code

/// Triangles by their edges, each edge from a corner to the next. Whoever asks again does not pass by what is drawn.
class Edges {
 public:
  /// A triangle, and its corner across the edge.
  struct Across {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;
  };

  Edges(std::span<const std::uint32_t> indices, std::size_t vertex_count) : first_(vertex_count + 1) {
    for (const std::uint32_t v : indices) ++first_[v + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    edges_.resize(indices.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < indices.size(); ++i) {
      const std::uint32_t triangle = i / 3;
      const std::uint32_t to = indices[3 * triangle + (i + 1) % 3], across = indices[3 * triangle + (i + 2) % 3];
      edges_[next[indices[i]]++] = {to, across, triangle, 0};
    }
    const auto by_end = [](const Edge& a, const Edge& b) { return a.to < b.to; };
    for (std::size_t v = 0; v < vertex_count; ++v) {
      std::stable_sort(edges_.begin() + first_[v], edges_.begin() + first_[v + 1], by_end);
    }
  }

  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Number of the first edge from a to b, behind which are the others; or none.
  std::uint32_t run(std::uint32_t a, std::uint32_t b) const {
    const std::span all = std::span(edges_).subspan(first_[a], first_[a + 1] - first_[a]);
    const auto found = std::ranges::lower_bound(all, b, {}, &Edge::to);
    if (found == all.end() || found->to != b) return none;
    return first_[a] + static_cast<std::uint32_t>(found - all.begin());
  }

  /// The first triangle of a run from `a` that is not drawn.
  std::optional<Across> find(std::uint32_t run, std::uint32_t a, const std::vector<bool>& is_drawn) {
    const std::uint32_t end = first_[a + 1], to = edges_[run].to;
    for (std::uint32_t& passed = edges_[run].drawn; run + passed < end && edges_[run + passed].to == to; ++passed) {
      const Edge& edge = edges_[run + passed];
      if (!is_drawn[edge.triangle]) return Across{edge.triangle, edge.across};
    }
    return std::nullopt;
  }

  /// How many triangles a vertex has that are not drawn, of those from `passed` on, which skips what is.
  std::optional<std::uint32_t> any_at(std::uint32_t vertex, const std::vector<bool>& is_drawn,
                                      std::uint32_t& passed) const {
    const std::uint32_t count = first_[vertex + 1] - first_[vertex];
    while (passed < count && is_drawn[edges_[first_[vertex] + passed].triangle]) ++passed;
    return passed < count ? std::optional(edges_[first_[vertex] + passed].triangle) : std::nullopt;
  }

 private:
  struct Edge {
    std::uint32_t to = 0, across = 0, triangle = 0;
    std::uint32_t drawn = 0;  ///< of the first edge to that vertex: how many of them are drawn
  };
  std::vector<std::uint32_t> first_;  ///< edge of each vertex
  std::vector<Edge> edges_;
};

class Walk {
 public:
  Walk(std::span<const std::uint32_t> indices, std::size_t vertex_count)
      : indices_(indices), edges_(indices, vertex_count), passed_(vertex_count), is_known_(vertex_count) {
    is_drawn_.resize(indices.size() / 3);
  }

  std::vector<std::uint32_t> run() {
    while (order_.size() < is_drawn_.size()) {
      if (const auto next = at_edges()) {
        draw(*next);
      } else {
        draw_alone(elsewhere());
      }
    }
    return std::move(order_);
  }

 private:
  /// A triangle seen from one of its edges, which runs from `a` to `b`.
  struct Seen {
    std::uint32_t a = 0, b = 0;
    Edges::Across across;
  };

  /// An edge of what is drawn as the neighbour runs along it, and its run, looked up once.
  struct Crossed {
    std::uint32_t a = 0, b = 0, run = 0;
  };

  std::optional<Seen> at_edges() {
    std::optional<Seen> with_a_new_vertex;
    for (std::size_t back = 1; back <= std::min(remembered, crossed_); ++back) {
      const auto [a, b, run] = last_[(crossed_ - back) % last_.size()];
      if (run == Edges::none) continue;
      const auto across = edges_.find(run, a, is_drawn_);
      if (!across) continue;
      if (is_known_[across->corner]) return Seen{a, b, *across};
      if (!with_a_new_vertex) with_a_new_vertex = Seen{a, b, *across};
    }
    return with_a_new_vertex;
  }

  /// From a dead end: at the vertex drawn last that has triangles left; else the next one in the old order.
  std::uint32_t elsewhere() {
    for (; !touched_.empty(); touched_.pop_back()) {
      const std::uint32_t v = touched_.back();
      if (const auto triangle = edges_.any_at(v, is_drawn_, passed_[v])) return *triangle;
    }
    while (is_drawn_[next_]) ++next_;
    return next_;
  }

  void draw(const Seen& seen) {
    emit(seen.across.triangle, {seen.a, seen.b, seen.across.corner});
    cross(seen.across.corner, seen.b);
    cross(seen.a, seen.across.corner);
  }

  void draw_alone(std::uint32_t triangle) {
    const auto corners = indices_.subspan(3 * triangle, 3);
    emit(triangle, {corners[0], corners[1], corners[2]});
    cross(corners[1], corners[0]);
    cross(corners[2], corners[1]);
    cross(corners[0], corners[2]);
  }

  /// The neighbour runs along the edge the other way.
  void cross(std::uint32_t from, std::uint32_t to) {
    last_[crossed_++ % last_.size()] = {from, to, edges_.run(from, to)};
  }

  void emit(std::uint32_t triangle, const std::array<std::uint32_t, 3>& corners) {
    order_.push_back(triangle);
    is_drawn_[triangle] = true;
    for (const std::uint32_t v : corners) {
      is_known_[v] = true;
      touched_.push_back(v);
    }
  }

  std::span<const std::uint32_t> indices_;
  Edges edges_;
  std::vector<std::uint32_t> passed_;  ///< of each vertex's triangles
  std::vector<bool> is_known_, is_drawn_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> touched_;  ///< vertices, the last one behind
  std::array<Crossed, 16> last_{};
  std::size_t crossed_ = 0;
  std::uint32_t next_ = 0;
};

}  // namespace

std::vector<std::uint32_t> codec_order(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
  return Walk(indices, vertex_count).run();
}

}  // namespace foredraw
