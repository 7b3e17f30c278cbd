#include <foredraw/overdraw/judging_looks.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

bool judges(std::size_t look) {
  constexpr std::uint32_t golden = 2654435769u;  // 2^32 / golden ratio
  return static_cast<std::uint32_t>(look + 1) * golden < ~std::uint32_t{0} / 5;
}

std::vector<std::int64_t> pixel_weights(const SubjectLayers& seen) {
  constexpr double heaviest_pixel = 0x1p20;
  const double heaviest = seen.weights.empty() ? 1 : *std::ranges::max_element(seen.weights);
  std::vector<std::int64_t> weights;
  for (const double weight : seen.weights) {
    weights.push_back(static_cast<std::int64_t>(std::floor(weight / heaviest * heaviest_pixel)));
  }
  return weights;
}

}  // namespace foredraw
