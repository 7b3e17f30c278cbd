#include <foredraw/base/diagnostics.h>

#include <gtest/gtest.h>

namespace foredraw::diagnostics_test {
namespace {

TEST(Diagnostics, AreToldWithPlaceAndHint) {
  Diagnostics diagnostics;
  diagnostics.error({"props.toml", 5, 23, "stages[1]"}, "unknown-option", "'tipsify' has no option 'cache'",
                    "did you mean 'cache-size'?");
  diagnostics.warning({.file = "rock.glb"}, "odd", "is odd");
  diagnostics.note({.inside = "meshes[3]"}, "seen", "was seen");
  diagnostics.note({}, "bare", "stands alone");
  EXPECT_EQ(to_text(diagnostics),
            "props.toml:5:23: error: stages[1]: 'tipsify' has no option 'cache'\n"
            "    hint: did you mean 'cache-size'?\n"
            "rock.glb: warning: is odd\n"
            "note: meshes[3]: was seen\n"
            "note: stands alone\n");
}

TEST(Diagnostics, OnlyErrorsAreErrors) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.empty());
  diagnostics.note({}, "a", "a");
  diagnostics.warning({}, "b", "b");
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_FALSE(diagnostics.empty());
  diagnostics.error({}, "c", "c");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.all().size(), 3u);
  EXPECT_EQ(diagnostics.all().back().code, "c");
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> words{"only", "required", "enabled", "cache-size", "tipsify", "dot-rule"};
  EXPECT_EQ(nearest("tipsfy", words), "tipsify");
  EXPECT_EQ(nearest("requierd", words), "required");
  EXPECT_EQ(nearest("dotrule", words), "dot-rule");
  EXPECT_EQ(nearest("cache", words), "cache-size");
  EXPECT_EQ(nearest("cachesize", words), "cache-size");
  EXPECT_EQ(nearest("only", words), "only");
}

TEST(Nearest, GuessesNothingFarOff) {
  const std::vector<std::string> words{"only", "required", "enabled", "cache-size", "tipsify"};
  const std::vector<std::string> few{"weld", "dot-rule"}, none;
  EXPECT_EQ(nearest("simplify", few), "");
  EXPECT_EQ(nearest("xyz", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("tipsify", none), "");
}

TEST(Nearest, AnExactMatchStandsAboveALongerWord) {
  const std::vector<std::string> longer{"weld-all", "weld"}, alike{"cache-size", "sizes"};
  EXPECT_EQ(nearest("weld", longer), "weld");
  EXPECT_EQ(nearest("size", alike), "cache-size");  // equally near: the first
}

}  // namespace
}  // namespace foredraw::diagnostics_test
