#include <foredraw/base/content_hash.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <vector>

namespace foredraw::content_hash_test {
namespace {

Stamp stamp_of(const std::vector<std::uint32_t>& values, std::uint64_t seed = 0) {
  return content_hash(std::span<const std::uint32_t>(values), seed);
}

TEST(ContentHash, IsXxh3AsPublished) {
  // The published XXH3 128-bit value of nothing.
  EXPECT_EQ(to_text(content_hash(std::span<const std::byte>{})), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, EqualContentHasEqualStamps) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint32_t>& values) {
    const std::vector<std::uint32_t> copy = values;
    RC_ASSERT(stamp_of(values) == stamp_of(copy));
  }));
}

TEST(ContentHash, AnyChangedValueShows) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint32_t>& values) {
    RC_PRE(!values.empty());
    std::vector<std::uint32_t> changed = values;
    changed[*rc::gen::inRange<std::size_t>(0, values.size())] ^= 1u << *rc::gen::inRange(0, 32);
    RC_ASSERT(stamp_of(values) != stamp_of(changed));
    changed = values;
    changed.push_back(0);
    RC_ASSERT(stamp_of(values) != stamp_of(changed));
  }));
}

TEST(ContentHash, SeedsMakeOtherStamps) {
  std::set<Stamp> stamps;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) stamps.insert(stamp_of({1, 2, 3}, seed));
  EXPECT_EQ(stamps.size(), 1000u);
}

TEST(ContentHash, CombiningGoesByTheSequence) {
  const Stamp a = stamp_of({1}), b = stamp_of({2});
  EXPECT_EQ(combine(std::vector{a, b}), combine(std::vector{a, b}));
  EXPECT_NE(combine(std::vector{a, b}), combine(std::vector{b, a}));
  EXPECT_NE(combine(std::vector{a}), a);
  EXPECT_NE(combine(std::vector{a}), combine(std::vector{a, a}));
}

TEST(ContentHash, IsToldInThirtyTwoDigits) {
  EXPECT_EQ(to_text(Stamp{0x1, 0xabcdef}), "00000000000000010000000000abcdef");
}

}  // namespace
}  // namespace foredraw::content_hash_test
