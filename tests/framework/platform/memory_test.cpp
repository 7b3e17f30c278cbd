#include <foredraw/platform/machine.h>
#include <foredraw/platform/memory.h>

#include <gtest/gtest.h>

#include <vector>

namespace foredraw::platform_memory_test {
namespace {

/// Memory that is there: every page of it is touched.
std::size_t touch(std::size_t bytes) {
  std::vector<char> memory(bytes, 1);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < memory.size(); i += 1024) sum += static_cast<std::size_t>(memory[i]);
  return sum;
}

TEST(MemoryWatch, TellsWhatWasHeldAtMostSinceItBegan) {
  constexpr std::size_t large = 64 << 20, small = 8 << 20;
  EXPECT_GT(touch(large), 0u);  // what was held and given back before is not told
  const MemoryWatch watch;
  EXPECT_GT(touch(small), 0u);
  const auto growth = watch.growth();
  if (!growth) GTEST_SKIP() << "this system does not tell";
  EXPECT_GE(*growth, small / 2);
  EXPECT_LT(*growth, large);
}

TEST(MachineText, SaysSomething) { EXPECT_NE(machine_text().find("processor"), std::string::npos); }

}  // namespace
}  // namespace foredraw::platform_memory_test
