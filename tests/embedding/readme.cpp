// What README.md shows.
#include <plugins/orderers/tipsify/tipsify.h>

#include <cstdio>

int main() {
  const std::vector<std::uint32_t> indices{0, 1, 2, 3, 4, 5, 2, 1, 3};  // a triangle list
  const auto order = foredraw::tipsify(indices, 6, {.cache_size = 24});
  for (std::uint32_t old : order) {  // order[new] = old triangle; corners stay as they are
    std::printf("%u %u %u\n", indices[3 * old], indices[3 * old + 1], indices[3 * old + 2]);
  }
}
