#include <foredraw/scene/traits.h>

#include <gtest/gtest.h>

namespace foredraw::traits_test {
namespace {

TEST(Traits, AddAndRemove) {
  Traits traits = {traits::triangles, traits::uv0};
  EXPECT_TRUE(traits.has(traits::uv0));
  EXPECT_FALSE(traits.has(traits::normals));
  traits.add(traits::normals);
  traits.remove(traits::uv0);
  EXPECT_EQ(traits, (Traits{traits::normals, traits::triangles}));
  traits.remove("never-there");
  EXPECT_EQ(traits, (Traits{traits::normals, traits::triangles}));
}

TEST(Traits, AddAndRemoveSeveral) {
  Traits traits = {"a", "b", "c"};
  traits.remove(Traits{"b", "z"});
  traits.add(Traits{"c", "d"});
  EXPECT_EQ(traits, (Traits{"a", "c", "d"}));
  traits.remove(Traits{"a", "c", "d"});
  EXPECT_TRUE(traits.empty());
}

TEST(Traits, HoldTheNamesThemselves) {
  Traits traits;
  {
    std::string name = "a-name-that-goes-out-of-scope";
    traits.add(name);
    name.assign(name.size(), 'x');
  }
  EXPECT_TRUE(traits.has("a-name-that-goes-out-of-scope"));
}

TEST(Traits, AreInNameOrder) {
  const Traits traits = {"c", "a", "b", "a"};
  EXPECT_EQ(std::vector<std::string>(traits.begin(), traits.end()), (std::vector<std::string>{"a", "b", "c"}));
}

}  // namespace
}  // namespace foredraw::traits_test
