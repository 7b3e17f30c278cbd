// What the libraries show is what their headers declare, and that of the functions asks for no library but those of the
// language.

#include <support/program.h>

#include <regex>
#include <set>

namespace foredraw::testing::exports_test {
namespace {

class FunctionsLibrary : public InFolder {
 protected:
  /// The first group of the pattern, wherever it is found in what the command prints.
  std::set<std::string> found_in(const std::string& command, const std::string& library,
                                 const std::string& pattern) const {
    const std::filesystem::path out = folder_ / "out";
    EXPECT_EQ(std::system((command + " '" + library + "' >'" + out.string() + "'").c_str()), 0) << command;
    return groups_of(content(out), pattern);
  }

  static std::set<std::string> declared_in(const std::vector<std::string>& headers) {
    std::set<std::string> all;
    for (const std::string& header : headers) {
      const std::string text = content(FOREDRAW_SOURCE_DIR "/framework/foredraw/c/" + header);
      all.merge(groups_of(text, R"(\n(?:int|void|u?int\w+|const char\*|foredraw_\w+\*) (foredraw_\w+)\()"));
    }
    EXPECT_GT(all.size(), 10u);
    return all;
  }

  static inline const std::vector<std::string> of_functions = {"functions.h",      "instances.h", "mesh.h",
                                                               "simplification.h", "sprites.h",   "status.h"};
  static constexpr auto exported = R"( [A-Z] (\S+))";

  static std::set<std::string> groups_of(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> groups;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
      groups.insert((*match)[1]);
    }
    return groups;
  }
};

TEST_F(FunctionsLibrary, ShowsWhatItsHeadersDeclare) {
  EXPECT_EQ(found_in("nm -D --defined-only", FOREDRAW_FUNCTIONS, exported), declared_in(of_functions));
}

TEST_F(FunctionsLibrary, NeedsTheLanguageAlone) {
  for (const std::string& library : found_in("readelf -d", FOREDRAW_FUNCTIONS, R"(NEEDED[^\[]*\[([^.\]]+))")) {
    const std::set<std::string> allowed = {"libstdc++", "libc++",          "libc++abi", "libgcc_s", "libm",
                                           "libc",      "ld-linux-x86-64", "libasan",   "libubsan", "libtsan"};
    EXPECT_TRUE(allowed.contains(library)) << library;
  }
}

using WholeLibrary = FunctionsLibrary;

TEST_F(WholeLibrary, ShowsWhatAllHeadersDeclare) {
  std::vector<std::string> of_all = {"foredraw.h", "plugin.h"};
  of_all.insert(of_all.end(), of_functions.begin(), of_functions.end());
  EXPECT_EQ(found_in("nm -D --defined-only", FOREDRAW_LIBRARY, exported), declared_in(of_all));
}

}  // namespace
}  // namespace foredraw::testing::exports_test
