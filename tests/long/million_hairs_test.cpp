// A million hairs: all found, in bounded memory. The square of them would take days.

#include "benchmarks/wire_radius/wire_sets.h"
#include "plugins/processors/wire_radius/wire_radius.h"
#include "support/program.h"

#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace foredraw::million_hairs_test {
namespace {

TEST(MillionHairs, are_found_in_bounded_memory) {
  constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
  ASSERT_TRUE(testing::is_sanitized || limit_memory(8 * gibibyte));
  const bench::KnownMesh mesh = bench::hairs(1'000'000);
  ASSERT_EQ(mesh.indices.size() / 3, 8'000'000u);
  const FoundWires found = find_wires(mesh.positions, mesh.indices);
  EXPECT_EQ(found.wires.size(), 1'000'000u);
  EXPECT_EQ(std::ranges::count(found.wire_of, FoundWires::none), 0);
  EXPECT_LT(peak_memory(), 8 * gibibyte);
  std::printf("%.1f GiB at most\n", static_cast<double>(peak_memory()) / static_cast<double>(gibibyte));
}

}  // namespace
}  // namespace foredraw::million_hairs_test
