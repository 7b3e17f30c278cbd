// The example engine walks up to a model and makes it as fine as its way asks for, in three ways.

#include "support/meshes.h"
#include "support/program.h"

#include <regex>

namespace foredraw::level_walk_test {
namespace {

using testing::content;

constexpr char pipeline[] =
    R"('weld, quadric-collapse(placement=endpoint), levels(ratios="0.5, 0.25, 0.12, 0.06", keep-sequences=true), )"
    R"(geomorphs(keep-sequences=true)')";

/// A line of the walk.
struct Frame {
  double away = 0, level = 0, alpha = 0;
  double of_level = 0, singly = 0, selective = 0;  ///< triangles
};

class LevelWalk : public testing::InFolder {
 protected:
  std::string walk(const std::string& arguments) {
    const std::string out = (folder_ / "out").string();
    const std::string command = std::string("'") + FOREDRAW_LEVEL_WALK + "' " + arguments + " > '" + out + "' 2>&1";
    code_ = std::system(command.c_str());
    return content(out);
  }

  std::vector<Frame> frames(const std::string& told) {
    std::vector<Frame> found;
    const std::regex line(R"( *([\d.]+) \| +(\d+) +([\d.]+) +(\d+) +\d+ \| +(\d+) +\d+ \| +(\d+) .*)");
    std::istringstream lines(told);
    for (std::string text; std::getline(lines, text);) {
      std::smatch at;
      if (!std::regex_match(text, at, line)) continue;
      const auto number = [&](std::size_t i) { return std::stod(at[i]); };
      found.push_back({number(1), number(2), number(3), number(4), number(5), number(6)});
    }
    return found;
  }
  int code_ = 0;
};

TEST_F(LevelWalk, MakesAModelFinerAsItComesNearer) {
  const std::string file = testing::project_file("benchmarks/corpus/static/spot.glb").string();
  const testing::Ended made = testing::run_program(folder_, "optimize '" + file + "' -o out.glb -p " + pipeline);
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string told = walk("'" + (folder_ / "out.glb").string() + "' 40");
  ASSERT_EQ(code_, 0) << told;
  const std::vector<Frame> all = frames(told);
  ASSERT_EQ(all.size(), 40u) << told;
  EXPECT_LT(all.front().of_level, 800);
  EXPECT_LT(all.front().singly, 400);
  EXPECT_EQ(all.back().of_level, 5856);
  EXPECT_GT(all.back().singly, 5500);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_LE(all[i].alpha, 1);
    EXPECT_LE(all[i].singly, all[i].of_level);   // the estimate asks for less than what is proved
    EXPECT_LE(all[i].selective, all[i].singly);  // a part is not seen, or from behind
    if (i == 0) continue;
    EXPECT_LT(all[i].away, all[i - 1].away);
    EXPECT_GE(all[i].of_level, all[i - 1].of_level);
    EXPECT_GE(all[i].singly, all[i - 1].singly);
    if (all[i].level == all[i - 1].level) {
      EXPECT_LE(all[i].alpha, all[i - 1].alpha);
    }
  }
  EXPECT_LT(all.back().selective, 0.7 * all.back().singly);
}

TEST_F(LevelWalk, RefusesWhatHasNoLevels) {
  const std::string plain = walk("'" + testing::project_file("benchmarks/corpus/static/spot.glb").string() + "'");
  EXPECT_NE(plain.find("no sequence of collapses"), std::string::npos) << plain;
  EXPECT_NE(code_, 0);
  EXPECT_NE(walk("absent.glb").find("absent.glb"), std::string::npos);
  EXPECT_NE(code_, 0);
  walk("");
  EXPECT_NE(code_, 0);
}

}  // namespace
}  // namespace foredraw::level_walk_test
