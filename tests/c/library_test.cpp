// What the library shows is what its header declares, and it asks for no library but those of the language.

#include <support/program.h>

#include <regex>
#include <set>

namespace foredraw::testing {
namespace {

class FunctionsLibrary : public InFolder {
 protected:
  /// The first group of the pattern, wherever it is found in what the command prints.
  std::set<std::string> found_in(const std::string& command, const std::string& pattern) const {
    const std::filesystem::path out = folder_ / "out";
    EXPECT_EQ(std::system((command + " '" FOREDRAW_FUNCTIONS "' >'" + out.string() + "'").c_str()), 0) << command;
    return groups_of(content(out), pattern);
  }

  static std::set<std::string> groups_of(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> groups;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
      groups.insert((*match)[1]);
    }
    return groups;
  }
};

TEST_F(FunctionsLibrary, ShowsWhatItsHeaderDeclares) {
  const std::string header = content(FOREDRAW_SOURCE_DIR "/framework/foredraw/c/functions.h");
  const auto declared = groups_of(header, R"((?:^|\n)(?:int|const char\*) (foredraw_\w+)\()");
  EXPECT_GT(declared.size(), 10u);
  EXPECT_EQ(found_in("nm -D --defined-only", R"( [A-Z] (\S+))"), declared);
}

TEST_F(FunctionsLibrary, NeedsTheLanguageAlone) {
  for (const std::string& library : found_in("readelf -d", R"(NEEDED[^\[]*\[([^.\]]+))")) {
    const std::set<std::string> allowed = {"libstdc++", "libc++",          "libc++abi", "libgcc_s", "libm",
                                           "libc",      "ld-linux-x86-64", "libasan",   "libubsan", "libtsan"};
    EXPECT_TRUE(allowed.contains(library)) << library;
  }
}

}  // namespace
}  // namespace foredraw::testing
