// A copy for which there is no memory throws, and what was there stays.

#include <foredraw/base/copy_safe_variant.h>

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <string>
#include <vector>

namespace foredraw::copy_safe_variant_test {
namespace {

bool exhausted = false;

/// Has memory until it is exhausted.
template <class T>
struct Scarce {
  using value_type = T;
  Scarce() = default;
  template <class Other>
  Scarce(const Scarce<Other>&) noexcept {}
  T* allocate(std::size_t count) {
    if (exhausted) throw std::bad_alloc();
    return std::allocator<T>().allocate(count);
  }
  void deallocate(T* memory, std::size_t count) noexcept { std::allocator<T>().deallocate(memory, count); }
  bool operator==(const Scarce&) const = default;
};

using Text = std::basic_string<char, std::char_traits<char>, Scarce<char>>;
using Numbers = std::vector<int, Scarce<int>>;
using Value = CopySafeVariant<std::monostate, double, Text, Numbers>;

class CopySafeVariants : public ::testing::Test {
 protected:
  ~CopySafeVariants() override { exhausted = false; }

  const Text long_text_{"a text of more than fifteen characters"};
  const Value text_{long_text_};
  const Value numbers_{Numbers(100, 7)};
};

TEST_F(CopySafeVariants, AreCopiedAsVariantsAre) {
  for (const Value& value : {text_, numbers_, Value(2.5), Value()}) {
    const Value copy = value;
    EXPECT_TRUE(copy == value);
    Value assigned(1.0);
    assigned = copy;
    EXPECT_TRUE(assigned == value);
  }
  EXPECT_EQ(std::get<Text>(text_), long_text_);
}

TEST_F(CopySafeVariants, CopiesWithoutMemoryThrow) {
  exhausted = true;
  EXPECT_THROW(Value{text_}, std::bad_alloc);
  EXPECT_THROW(Value{numbers_}, std::bad_alloc);
}

TEST_F(CopySafeVariants, WithoutMemoryWhatWasThereStays) {
  Value short_text(Text("short")), number(2.5);
  exhausted = true;
  EXPECT_THROW(short_text = text_, std::bad_alloc);
  EXPECT_THROW(short_text = numbers_, std::bad_alloc);
  EXPECT_THROW(number = text_, std::bad_alloc);
  EXPECT_EQ(std::get<Text>(short_text), "short");
  EXPECT_EQ(std::get<double>(number), 2.5);
}

/// A value as a tree has them.
struct Tree {
  CopySafeVariant<double, std::vector<Tree>> value;
};

TEST_F(CopySafeVariants, APartTakesThePlaceOfTheWhole) {
  Tree tree{std::vector<Tree>{{std::vector<Tree>{{7.0}, {8.0}}}, {9.0}}};
  tree = std::get<1>(tree.value)[0];
  ASSERT_EQ(std::get<1>(tree.value).size(), 2u);
  EXPECT_EQ(std::get<0>(std::get<1>(tree.value)[1].value), 8.0);
  tree = std::move(std::get<1>(tree.value)[0]);
  EXPECT_EQ(std::get<0>(tree.value), 7.0);
}

}  // namespace
}  // namespace foredraw::copy_safe_variant_test
