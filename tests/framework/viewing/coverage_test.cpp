#include <foredraw/viewing/coverage.h>

#include "support/covers_pixel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>

namespace foredraw::coverage_test {
namespace {

Corner random_corner(int most) {
  const auto coordinate = [most] { return *rc::gen::inRange(0, most + 1); };
  return {coordinate(), coordinate(), static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 24))};
}

RC_GTEST_PROP(Coverage, is_exact, ()) {
  const int size = *rc::gen::element(3, 17);
  const int step = *rc::gen::element(1, 128);  // multiples of 128 lie on centres
  Corner a = random_corner(size * 256 / step);
  Corner b = random_corner(size * 256 / step);
  Corner c = random_corner(size * 256 / step);
  for (Corner* corner : {&a, &b, &c}) {
    corner->x *= step;
    corner->y *= step;
  }
  if (doubled_area(a, b, c) < 0) std::swap(b, c);
  const std::int64_t area = doubled_area(a, b, c);
  RC_PRE(area != 0);

  std::set<std::pair<int, int>> expected;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (covers_pixel(a, b, c, x, y)) expected.emplace(x, y);
    }
  }
  std::set<std::pair<int, int>> covered;
  for_each_covered(a, b, c, PixelBox(a, b, c), [&](int x, int y, const std::array<std::int64_t, 3>& weights) {
    RC_ASSERT(covered.emplace(x, y).second);
    RC_ASSERT(weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0);
    RC_ASSERT(weights[0] + weights[1] + weights[2] == area);
  });
  RC_ASSERT(covered == expected);
}

}  // namespace
}  // namespace foredraw::coverage_test
