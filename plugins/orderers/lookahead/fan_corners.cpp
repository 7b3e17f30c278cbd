// The mesh as a walk of fans wants it: the corners of every vertex in the sequence in which they lie around it.

#include "fan_walk.h"

#include <algorithm>

namespace foredraw {

namespace {

/// Corners renumbered by the vertices of the walk: those that are used, in their sequence, each as many times as it
/// takes for none to have more than `largest_fan` corners. Answers with their number.
std::uint32_t split_fans(std::span<std::uint32_t> walked, std::span<const std::uint32_t> indices,
                         std::size_t vertex_count, std::uint32_t largest_fan, std::pmr::memory_resource& memory) {
  std::pmr::vector<std::uint32_t> first(vertex_count, 0, &memory), seen(vertex_count, 0, &memory);
  for (const std::uint32_t v : indices) ++seen[v];
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    first[v] = count;
    count += (seen[v] + largest_fan - 1) / largest_fan;
    seen[v] = 0;
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t v = indices[i];
    walked[i] = first[v] + seen[v]++ / largest_fan;
  }
  return count;
}

}  // namespace

/// Two vertices stand behind the real ones. Nobody has no triangles, so that a corner which names it counts as drawn;
/// somebody always has. A degenerate triangle is seen once from each vertex that it has, together with somebody.
void FanWalk::find_corners(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                           std::pmr::memory_resource& memory) {
  std::pmr::vector<std::uint32_t> walked(indices.size(), &memory);
  const std::uint32_t nobody = split_fans(walked, indices, vertex_count, largest_fan, memory), somebody = nobody + 1;
  vertices_.resize(nobody + std::size_t{2});
  corners_.resize(indices.size());
  for (const std::uint32_t v : walked) ++vertices_[v].corners;
  std::uint32_t end = 0;
  for (Vertex& v : vertices_) v.corners = end += v.corners;
  for (std::size_t triangle = indices.size() / 3; triangle-- > 0;) {  // from the back, as lists are filled from theirs
    for (std::uint32_t place = 3; place-- > 0;) {
      const std::uint32_t* t = &walked[3 * triangle];
      const std::uint32_t v = t[place];
      std::uint32_t next = t[(place + 1) % 3], last = t[(place + 2) % 3];
      const bool again = (place > 0 && t[0] == v) || (place > 1 && t[1] == v);
      if (again) {
        next = last = nobody;
      } else if (next == v || last == v || next == last) {
        if (last == v || next == last) last = somebody;
        if (next == v) next = somebody;
      }
      corners_[--vertices_[v].corners] = Corner(static_cast<std::uint32_t>(3 * triangle + place), next, last);
      vertices_[v].live += !again;
    }
  }
  vertices_[somebody].live = ~std::uint32_t{0};
  for (std::uint32_t v = 0; v < nobody; ++v) {
    sort_around({&corners_[vertices_[v].corners], vertices_[v + 1].corners - vertices_[v].corners});
  }
}

/// Corners as the triangles lie around their vertex: each begins where the one before ends, as far as they meet.
void FanWalk::sort_around(std::span<Corner> corners) const {
  for (std::size_t begin = 0; begin < corners.size();) {
    // The one that follows upon no other, if there is one: an open fan is walked from its end.
    std::size_t start = begin;
    for (std::size_t i = begin; i < corners.size(); ++i) {
      const auto leads_here = [&](const Corner& c) { return c.last == corners[i].next; };
      if (std::none_of(corners.begin() + begin, corners.end(), leads_here)) {
        start = i;
        break;
      }
    }
    for (std::size_t next = start; next < corners.size();) {
      std::swap(corners[begin], corners[next]);
      const std::uint32_t last = corners[begin++].last;
      next = begin;
      while (next < corners.size() && corners[next].next != last) ++next;
    }
  }
}

}  // namespace foredraw
