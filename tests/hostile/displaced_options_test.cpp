// Options of the stages for displaced surfaces and crowds that are no numbers, or none that may be.
#include "displaced_parts.h"

namespace foredraw::displaced_options_test {
namespace {

#ifdef FOREDRAW_PROGRAM
class DisplacedOptions : public testing::InFolder {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }
};

TEST_F(DisplacedOptions, OptionsThatAreNoNumbersAreRefused) {
  testing::put(folder_ / "a.glb", testing::Parts().glb());
  for (const char* option :
       {"tessellate.parts", "tessellate.texels", "tessellate.levels", "tessellate.most",
        "tessellation-levels.triangles", "tessellation-levels.error", "displacement.factor", "displacement.offset",
        "displacement.uv", "displacement-seams.bits", "displacement-seams.iterations", "crowd-levels.characters"}) {
    const std::string stage = std::string(option).substr(0, std::string(option).find('.'));
    const std::string name = std::string(option).substr(stage.size() + 1);
    for (const char* wrong : {"nan", "-inf", "1e300", "-1e31", "text"}) {
      const testing::Ended ended = run("plan a.glb -p '" + stage + '(' + name + '=' + wrong + ")'");
      EXPECT_EQ(ended.code, 1) << option << '=' << wrong;
      EXPECT_NE(ended.err.find('\'' + name + '\''), std::string::npos) << ended.err;
    }
  }
  for (const char* option : {"tessellate(parts=0)", "tessellate(parts=65)", "tessellate(levels=0)",
                             "tessellate(levels=8)", "displacement-seams(bits=17)", "crowd-levels(characters=0)"}) {
    const testing::Ended ended = run("plan a.glb -p '" + std::string(option) + '\'');
    EXPECT_EQ(ended.code, 1) << option;
    EXPECT_NE(ended.err.find("but must be"), std::string::npos) << ended.err;
  }
}
#endif

}  // namespace
}  // namespace foredraw::displaced_options_test
