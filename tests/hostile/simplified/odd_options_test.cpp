// Options of what makes meshes coarser, as far out as anyone may set them: done, or refused in a line before any file
// is touched.
#include "odd_models.h"
#include "plain_messages.h"

#include <string>
#include <vector>

namespace foredraw::odd_options_test {
namespace {

using testing::Ended;

struct Setting {
  std::string preset, option, value;
  std::string refusal = {};  ///< what the line says; empty: it is done
};

std::vector<Setting> settings() {
  const std::string numbers = "must be numbers", finite = "must be a finite number";
  return {
      {"@simplify", "simplify.ratio", "0"},
      {"@simplify", "simplify.ratio", "1e-300"},
      {"@simplify", "simplify.ratio", "1"},
      {"@simplify", "simplify.ratio", "1.5", "'ratio' is 1.5, but must be 0 to 1"},
      {"@simplify", "simplify.ratio", "-1", "must be 0 to 1"},
      {"@simplify", "simplify.ratio", "nan", finite},
      {"@simplify", "simplify.ratio", "inf", finite},
      {"@simplify", "simplify.ratio", "half", finite},
      {"@simplify", "simplify.triangles", "0"},
      {"@simplify", "simplify.triangles", "18446744073709551615", "must be a whole number"},
      {"@simplify", "simplify.triangles", "-1", "must be at least 0"},
      {"@simplify", "simplify.error", "0"},
      {"@simplify", "simplify.error", "1e-308"},
      {"@simplify", "simplify.error", "1e308"},
      {"@simplify", "simplify.error", "nan", finite},
      {"@simplify", "simplify.pixels", "0"},
      {"@simplify", "simplify.distance", "0"},
      {"@levels", "levels.ratios", "\"0.1, 0.5\"", "must fall"},
      {"@levels", "levels.ratios", "\"0.5, 0.5\"", "must fall"},
      {"@levels", "levels.ratios", "\"0\"", "above 0 and below 1"},
      {"@levels", "levels.ratios", "\"1\"", "above 0 and below 1"},
      {"@levels", "levels.ratios", "\"2\"", "above 0 and below 1"},
      {"@levels", "levels.ratios", "\"1e-30\""},
      {"@levels", "levels.ratios", "\"nan\"", numbers},
      {"@levels", "levels.ratios", "\"0.5,,0.1\"", numbers},
      {"@levels", "levels.ratios", "\"\"", "give at least one"},
      {"@levels", "levels.errors", "\"0\""},
      {"@levels", "levels.errors", "\"0.1, 0.01\"", "must rise"},
      {"@levels", "levels.errors", "\"inf\"", numbers},
      {"@levels", "levels.errors", "\"-1\"", "must be a distance"},
      {"@levels", "levels.distances", "\"10, 1\"", "above 0 and rise"},
      {"@levels", "levels.pixels", "0", "must be at least 0.001"},
      {"@levels", "levels.saving", "1"},
      {"@levels", "quadric-collapse.border", "1e30", "must be 0 to 1000"},
      {"@levels", "quadric-collapse.border", "1000"},
      {"@levels", "quadric-collapse.seam", "1000"},
      {"@levels", "quadric-collapse.normals", "1000"},
      {"@levels", "quadric-collapse.texcoords", "1000"},
      {"@levels", "quadric-collapse.texcoords", "nan", finite},
      {"@levels", "quadric-collapse.memory", "1"},
      {"@levels", "quadric-collapse.parts", "1"},
      {"@levels", "quadric-collapse.until", "1"},
      {"@streaming", "progressive-stream.position-bits", "4"},
      {"@streaming", "progressive-stream.position-bits", "33", "must be 4 to 20 bits"},
      {"@streaming", "progressive-stream.chunk-size", "1", "must be 1024 to"},
      {"@streaming", "progressive-stream.growth", "nan", finite},
  };
}

class OddOptions : public testing::InFolder {
 protected:
  OddOptions() {
    const std::vector<std::byte> bytes = testing::plain_model(16, 8).glb();
    testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  Ended run(const std::string& arguments) {
    const Ended ended = testing::run_program(folder_, arguments + " --with vertex-cache");
    testing::expect_plain_messages(ended, arguments);
    return ended;
  }
};

TEST_F(OddOptions, AreDoneOrRefusedInALine) {
  for (const Setting& one : settings()) {
    const std::string set = one.option + '=' + one.value;
    SCOPED_TRACE(one.preset + ' ' + set);
    std::filesystem::remove(folder_ / "out.glb");
    const Ended ended = run("optimize in.glb -o out.glb -p " + one.preset + " --set '" + set + '\'');
    EXPECT_EQ(ended.code, one.refusal.empty() ? 0 : 1) << ended.err;
    EXPECT_EQ(std::filesystem::exists(folder_ / "out.glb"), one.refusal.empty());
    if (one.refusal.empty()) {
      EXPECT_EQ(testing::content(folder_ / "out.glb").find("FOREDRAW_progressive_mesh"), std::string::npos)
          << "a sequence that nobody asked for";
    } else {
      EXPECT_NE(ended.err.find(one.refusal), std::string::npos) << ended.err;
      EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    }
  }
}

/// Pieces of work are more than triangles, then.
TEST_F(OddOptions, ThreadsMayBeManyMoreThanTriangles) {
  std::string first;
  for (const char* threads : {"1", "1024"}) {
    ASSERT_EQ(run(std::string("optimize in.glb -o out.glb -p @levels --threads ") + threads).code, 0);
    if (first.empty()) first = testing::content(folder_ / "out.glb");
    EXPECT_EQ(testing::content(folder_ / "out.glb"), first);
  }
}

}  // namespace
}  // namespace foredraw::odd_options_test
