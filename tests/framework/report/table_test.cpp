#include <foredraw/report/table.h>

#include <gtest/gtest.h>

namespace foredraw::table_test {
namespace {

TEST(Table, ColumnsAreAsWideAsTheirWidestCell) {
  Table table({"stage", "n"});
  table.add({"a", "12345"});
  table.add({"longer", "6"});
  EXPECT_EQ(table.text(),
            "stage   n\n"
            "------  -----\n"
            "a       12345\n"
            "longer  6\n");
}

TEST(Table, NoLineEndsInSpaces) {
  Table table({"head", "wide head"});
  table.add({"", ""});
  EXPECT_EQ(table.text(), "head  wide head\n----  ---------\n\n");
}

TEST(Table, EmptyUntilARowIsAdded) {
  Table table({"head"});
  EXPECT_TRUE(table.empty());
  EXPECT_EQ(table.text(), "head\n----\n");
  table.add({"x"});
  EXPECT_FALSE(table.empty());
}

TEST(Table, CountsCharactersAndNotBytes) {
  EXPECT_EQ(shown_width("1.5 ±0.1"), 8u);
  EXPECT_EQ(shown_width("Fuß"), 3u);
  EXPECT_EQ(shown_width(""), 0u);
  Table table({"a", "b"});
  table.add({"±±", "x"});
  table.add({"yy", "z"});
  EXPECT_EQ(table.text(), "a   b\n--  -\n±±  x\nyy  z\n");
}

}  // namespace
}  // namespace foredraw::table_test
