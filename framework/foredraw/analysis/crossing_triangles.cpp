#include <foredraw/analysis/crossing_triangles.h>

#include <foredraw/geometry/finite.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

using Corners = std::array<glm::vec3, 3>;

/// On which side of the plane of a, b and c the point d lies: 1 or -1; 0 where doubles do not tell.
/// The bound is that of J. Shewchuk: Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
/// Discrete & Computational Geometry 18(3), 1997, rounded up.
int side(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  constexpr double unsure = 1e-15;
  const glm::dvec3 from(d), u = glm::dvec3(a) - from, v = glm::dvec3(b) - from, w = glm::dvec3(c) - from;
  const double volume = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
  const glm::dvec3 p = glm::abs(u), q = glm::abs(v), r = glm::abs(w);
  const double most = p.x * (q.y * r.z + q.z * r.y) + p.y * (q.z * r.x + q.x * r.z) + p.z * (q.x * r.y + q.y * r.x);
  if (!(std::abs(volume) > unsure * most)) return 0;
  return volume > 0 ? 1 : -1;
}

/// Whether an edge of the one goes through the inside of the other.
bool goes_through(const Corners& edges, const Corners& of) {
  std::array<int, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) sides[i] = side(of[0], of[1], of[2], edges[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (sides[i] * sides[next] >= 0) continue;
    const glm::vec3 &p = edges[i], &q = edges[next];
    const int turn = side(p, q, of[0], of[1]);
    if (turn != 0 && side(p, q, of[1], of[2]) == turn && side(p, q, of[2], of[0]) == turn) return true;
  }
  return false;
}

bool has_common_corner(const Corners& a, const Corners& b) {
  return std::ranges::any_of(a, [&](const glm::vec3& p) { return std::ranges::find(b, p) != b.end(); });
}

/// Where so many triangles lie in the box of one, and it crosses none of them, they lie on each other.
constexpr std::size_t most_asked = 512;

class Crossings {
 public:
  explicit Crossings(const Surface& surface) {
    std::vector<BoxTree::Box> boxes;
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
      Corners corners;
      for (std::size_t c = 0; c < 3; ++c) corners[c] = surface.positions[surface.indices[i + c]];
      if (!is_finite(corners)) continue;
      triangles_.push_back(corners);
      numbers_.push_back(static_cast<std::uint32_t>(i / 3));
      boxes.emplace_back();
      for (const glm::vec3& corner : corners) boxes.back().add(corner);
    }
    tree_ = box_tree(boxes, 4);
  }

  std::size_t size() const { return triangles_.size(); }
  std::uint32_t number(std::size_t of) const { return numbers_[of]; }

  bool crosses(std::size_t asked) const {
    const Corners& own = triangles_[asked];
    BoxTree::Box box;
    for (const glm::vec3& corner : own) box.add(corner);
    std::array<std::uint32_t, BoxTree::most_waiting + BoxTree::width> waiting;
    std::size_t count = 1, asked_of = 0;
    waiting[0] = 0;
    while (count > 0 && asked_of < most_asked) {
      const BoxTree::Node& node = tree_.nodes[waiting[--count]];
      for (std::size_t child = 0; child < BoxTree::width; ++child) {
        if (!overlap(box, node, child)) continue;
        if (node.count[child] == 0) {
          waiting[count++] = node.first[child];
          continue;
        }
        asked_of += node.count[child];
        for (std::uint32_t i = node.first[child]; i < node.first[child] + node.count[child]; ++i) {
          const Corners& other = triangles_[tree_.order[i]];
          if (has_common_corner(own, other)) continue;
          if (goes_through(own, other) || goes_through(other, own)) return true;
        }
      }
    }
    return false;
  }

 private:
  static bool overlap(const BoxTree::Box& box, const BoxTree::Node& node, std::size_t child) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(node.planes[0][axis][child] <= box.max[axis] && node.planes[1][axis][child] >= box.min[axis])) return false;
    }
    return true;
  }

  std::vector<Corners> triangles_;
  std::vector<std::uint32_t> numbers_;
  BoxTree tree_;
};

}  // namespace

std::vector<std::uint8_t> crossing_triangles(const Surface& surface, const Executor& executor,
                                             const std::atomic<bool>* cancel) {
  constexpr std::size_t together = 1024;
  std::vector<std::uint8_t> found(surface.indices.size() / 3, 0);
  const Crossings crossings(surface);
  executor.for_each((crossings.size() + together - 1) / together, [&](std::size_t chunk) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
    const std::size_t end = std::min(crossings.size(), (chunk + 1) * together);
    for (std::size_t t = chunk * together; t < end; ++t) found[crossings.number(t)] = crossings.crosses(t) ? 1 : 0;
  });
  return found;
}

}  // namespace foredraw
