// A million hairs: all found, in bounded time and memory.

#include "benchmarks/wire_radius/wire_sets.h"
#include "plugins/processors/wire_radius/wire_radius.h"
#include "support/program.h"

#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace foredraw {
namespace {

TEST(MillionHairs, are_found_in_bounded_time_and_memory) {
  constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
  ASSERT_TRUE(testing::is_sanitized || limit_memory(8 * gibibyte));
  const bench::KnownMesh mesh = bench::hairs(1'000'000);
  ASSERT_EQ(mesh.indices.size() / 3, 8'000'000u);
  const std::clock_t begin = std::clock();  // of the processor: another program may want it too
  const FoundWires found = find_wires(mesh.positions, mesh.indices);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(found.wires.size(), 1'000'000u);
  EXPECT_EQ(std::ranges::count(found.wire_of, FoundWires::none), 0);
  EXPECT_LT(seconds, 120);
  EXPECT_LT(peak_memory(), 8 * gibibyte);
  std::printf("%.0f s; %.1f GiB at most\n", seconds,
              static_cast<double>(peak_memory()) / static_cast<double>(gibibyte));
}

}  // namespace
}  // namespace foredraw
