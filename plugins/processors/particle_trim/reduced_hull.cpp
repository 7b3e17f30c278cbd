#include "reduced_hull.h"

#include <limits>
#include <queue>

namespace foredraw::processors::particle_trim {

namespace {

struct Removal {
  double growth;
  std::size_t edge;
  std::size_t before, behind;  ///< its neighbours when the growth was found
  friend bool operator>(const Removal& a, const Removal& b) {
    return a.growth != b.growth ? a.growth > b.growth : a.edge > b.edge;
  }
};

}  // namespace

std::vector<std::size_t> reduced_hull(const Pockets& pockets, std::size_t most) {
  const std::size_t edges = pockets.edges();
  std::vector<std::size_t> before(edges), behind(edges);
  for (std::size_t i = 0; i < edges; ++i) {
    before[i] = (i + edges - 1) % edges;
    behind[i] = (i + 1) % edges;
  }
  std::priority_queue<Removal, std::vector<Removal>, std::greater<>> removals;
  const auto propose = [&](std::size_t edge) {
    const std::size_t a = before[edge], b = behind[edge];
    const double without = pockets.between(a, b);
    if (without < std::numeric_limits<double>::infinity()) {
      removals.push({without - pockets.between(a, edge) - pockets.between(edge, b), edge, a, b});
    }
  };
  for (std::size_t i = 0; i < edges; ++i) propose(i);
  std::vector<bool> is_there(edges, true);
  std::size_t left = edges;
  while (left > most && left > 3 && !removals.empty()) {
    const Removal removal = removals.top();
    removals.pop();
    const auto [growth, edge, a, b] = removal;
    if (!is_there[edge] || before[edge] != a || behind[edge] != b) continue;  // its neighbours have changed since
    is_there[edge] = false;
    --left;
    behind[a] = b;
    before[b] = a;
    propose(a);
    propose(b);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < edges; ++i) {
    if (is_there[i]) kept.push_back(i);
  }
  return kept;
}

}  // namespace foredraw::processors::particle_trim
