#include <foredraw/base/counted.h>

#include <gtest/gtest.h>

namespace foredraw::counted_test {
namespace {

TEST(Counted, ThousandsStandApart) {
  EXPECT_EQ(counted(0), "0");
  EXPECT_EQ(counted(999), "999");
  EXPECT_EQ(counted(1000), "1,000");
  EXPECT_EQ(counted(1234567), "1,234,567");
}

TEST(Counted, OneThingIsSingular) {
  EXPECT_EQ(counted(1, "draw"), "1 draw");
  EXPECT_EQ(counted(0, "draw"), "0 draws");
  EXPECT_EQ(counted(1200, "draw"), "1,200 draws");
  EXPECT_EQ(counted(1, "mesh", "meshes"), "1 mesh");
  EXPECT_EQ(counted(2, "mesh", "meshes"), "2 meshes");
}

}  // namespace
}  // namespace foredraw::counted_test
