// Displaced draws whose layout, shape, normals, weights or numbers are not what they should be, through the program:
// read and measured as far as they go, and told; and nothing that is no number comes out.
#include "displaced_cases.h"

#include "support/expect_numbers.h"

namespace foredraw::displaced_files_test {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::DisplacedCase;
using testing::Parts;

const std::vector<std::string> pipelines = {
    "@displaced' --with 'seam-gap, vertex-precision",
    "@crowd",
    "displacement-seams(table=true), tessellation-levels, vertex-pack' --with 'vertex-cache",
    "displacement-seams(method=average), tessellate(texels=2, levels=3)' --with 'vertex-cache",
    "tessellate(parts=5, spacing=fractional-even)' --with 'vertex-cache",
    "displacement(factor=2), weld, quadric-collapse, levels, crowd-levels' --with 'crowd-cost(frames=3)"};

class DisplacedFiles : public testing::InFolder,
                       public ::testing::WithParamInterface<const std::vector<DisplacedCase>& (*)()> {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }
};

/// Whole folders at once. Each file comes out, and no figure of it is no number.
TEST_P(DisplacedFiles, GoThroughEveryPipeline) {
  std::filesystem::create_directory(folder_ / "in");
  for (const DisplacedCase& one : GetParam()()) {
    Parts parts;
    one.harm(parts);
    testing::put(folder_ / "in" / (std::string(one.name) + ".glb"), parts.glb());
  }
  for (const std::string& stages : pipelines) {
    std::filesystem::remove_all(folder_ / "out");
    const std::string command = "optimize in -o out -p '" + stages + "' --threads 2";
    testing::expect_numbers(run(command), command);
    ASSERT_TRUE(std::filesystem::is_directory(folder_ / "out")) << command;
    EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {})),
              GetParam()().size())
        << command;
    const std::string again =
        "measure out --with 'seam-gap, vertex-precision, surface-error, crowd-cost(frames=3)' --threads 2";
    testing::expect_numbers(run(again), again + " after " + stages);
  }
}

TEST_P(DisplacedFiles, AreTold) {
  for (const DisplacedCase& one : GetParam()()) {
    if (*one.says == '\0') continue;
    SCOPED_TRACE(one.name);
    Parts parts;
    one.harm(parts);
    testing::put(folder_ / "a.glb", parts.glb());
    const testing::Ended ended = run("optimize a.glb -o b.glb -p '" + std::string(one.pipeline) + '\'');
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE((ended.out + ended.err).find(one.says), std::string::npos) << ended.out << ended.err;
  }
}

/// Pipelines beside one another.
TEST_P(DisplacedFiles, AreCompared) {
  const DisplacedCase& one = GetParam()().front();
  Parts parts;
  one.harm(parts);
  testing::put(folder_ / "a.glb", parts.glb());
  const std::string command = "compare a.glb -p @displaced -p @crowd -p 'tessellate(parts=3)'";
  testing::expect_numbers(run(command), command);
}

INSTANTIATE_TEST_SUITE_P(Cases, DisplacedFiles,
                         ::testing::Values(testing::displaced_layouts, testing::displaced_normals,
                                           testing::displaced_numbers, testing::displaced_shapes,
                                           testing::displaced_vertices));
#endif

}  // namespace
}  // namespace foredraw::displaced_files_test
