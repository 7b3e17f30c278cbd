#include <foredraw/scene/shared.h>

#include <gtest/gtest.h>

#include <thread>

namespace foredraw::shared_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(Shared, EqualContentHasEqualStamps) {
  const Shared<std::uint32_t> a(Numbers{1, 2, 3});
  const Shared<std::uint32_t> b(Numbers{1, 2, 3});
  EXPECT_EQ(a.stamp(), b.stamp());
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a.is(b));
}

TEST(Shared, OtherContentHasAnotherStamp) {
  const Shared<std::uint32_t> a(Numbers{1, 2, 3});
  for (const Numbers& other : {Numbers{1, 2, 4}, Numbers{1, 3, 2}, Numbers{1, 2}, Numbers{1, 2, 3, 0}, Numbers{}}) {
    EXPECT_NE(a.stamp(), Shared<std::uint32_t>(other).stamp());
    EXPECT_FALSE(a == Shared<std::uint32_t>(other));
  }
}

TEST(Shared, CopyIsTheSameBlock) {
  const Shared<std::uint32_t> a(Numbers{1, 2, 3});
  const Shared<std::uint32_t> copy = a;
  EXPECT_TRUE(copy.is(a));
  EXPECT_EQ(copy.view().data(), a.view().data());
}

TEST(Shared, OutlivesWhereItCameFrom) {
  Shared<std::uint32_t> kept;
  {
    const Shared<std::uint32_t> first(Numbers{7, 8});
    kept = first;
  }
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept.view()[1], 8u);
}

TEST(Shared, NothingIsAnEmptyArray) {
  const Shared<std::uint32_t> nothing;
  const Shared<std::uint32_t> empty{Numbers{}};
  EXPECT_TRUE(nothing.empty());
  EXPECT_TRUE(nothing.view().empty());
  EXPECT_EQ(nothing.stamp(), empty.stamp());
  EXPECT_TRUE(nothing == empty);
}

TEST(Shared, ManyThreadsAskForOneStamp) {
  const Shared<std::uint32_t> shared(Numbers(100000, 5));
  std::vector<Stamp> stamps(8);
  std::vector<std::thread> threads;
  for (Stamp& stamp : stamps) threads.emplace_back([&] { stamp = Shared(shared).stamp(); });
  for (std::thread& thread : threads) thread.join();
  for (const Stamp& stamp : stamps) EXPECT_EQ(stamp, content_hash(shared.view()));
}

}  // namespace
}  // namespace foredraw::shared_test
