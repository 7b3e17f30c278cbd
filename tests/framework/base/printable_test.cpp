#include <foredraw/base/printable.h>

#include <gtest/gtest.h>

namespace foredraw::printable_test {
namespace {

constexpr const char* bad = "\xef\xbf\xbd";

TEST(Printable, LeavesTextAlone) {
  for (const char* text : {"", "rock.glb", "Größe ±0.5 % 日本 🪨", "<b>&\"'"}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, ReplacesWhatATerminalObeys) {
  EXPECT_EQ(printable("a\x1b[31mb"), std::string("a") + bad + "[31mb");
  EXPECT_EQ(printable("a\nb\x7f"), std::string("a") + bad + "b" + bad);
  EXPECT_EQ(printable("a\nb\t", "\n\t"), "a\nb\t");
  EXPECT_EQ(printable("\xc2\x9b"), bad);  // the same as ESC [
  EXPECT_EQ(printable(std::string_view("\0", 1)), bad);
}

TEST(Printable, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(printable("a\xff\xfe"), std::string("a") + bad + bad);
  EXPECT_EQ(printable("\xc0\xaf"), std::string(bad) + bad);                      // longer than it need be
  EXPECT_EQ(printable("\xed\xa0\x80"), std::string(bad) + bad + bad);            // half of a pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), std::string(bad) + bad + bad + bad);  // beyond U+10FFFF
  EXPECT_EQ(printable("\xe6\x97"), std::string(bad) + bad);                      // cut off
}

}  // namespace
}  // namespace foredraw::printable_test
