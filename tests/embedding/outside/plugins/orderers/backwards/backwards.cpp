#include "backwards.h"

#include <numeric>

namespace foredraw {

std::vector<std::uint32_t> backwards(std::size_t triangles) {
  std::vector<std::uint32_t> order(triangles);
  std::iota(order.rbegin(), order.rend(), 0u);
  return order;
}

}  // namespace foredraw
