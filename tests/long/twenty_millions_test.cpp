// A mesh of twenty million triangles that does not fit into the memory that the program may have: told in a line, and
// nothing is written.

#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/program.h"

namespace foredraw::twenty_millions_test {
namespace {

#ifdef FOREDRAW_PROGRAM
class TwentyMillions : public testing::InFolder {
 protected:
  TwentyMillions() {
    const testing::TestMesh torus = testing::torus(5000, 2000);
    triangles_ = torus.indices.size() / 3;
    testing::GltfBuilder file;
    std::vector<float> positions;
    for (const glm::vec3& p : torus.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
    const std::size_t at = file.add_values(positions, "VEC3");
    file.add_mesh({{"attributes", {{"POSITION", at}}}, {"indices", file.add_values(torus.indices, "SCALAR")}});
    const std::vector<std::byte> bytes = file.glb();
    testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  std::size_t triangles_ = 0;
};

TEST_F(TwentyMillions, that_exceed_the_memory_limit_are_refused_in_a_line) {
  if (testing::is_sanitized) GTEST_SKIP() << "no limit can be set";
  ASSERT_EQ(triangles_, 20'000'000u);
  for (const char* preset : {"@simplify", "@levels", "@streaming"}) {
    const testing::Ended ended = testing::run_program(
        folder_, std::string("optimize in.glb -o out.glb --report report.json --memory-limit 3G -p ") + preset);
    EXPECT_EQ(ended.code, 2) << preset;
    EXPECT_EQ(ended.err,
              "in.glb: error: there is not enough memory to work on it: --memory-limit is 3,221,225,472 bytes\n"
              "    hint: raise --memory-limit\n")
        << preset;
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(files(), std::vector<std::string>{"in.glb"}) << preset;
  }
}
#endif

}  // namespace
}  // namespace foredraw::twenty_millions_test
