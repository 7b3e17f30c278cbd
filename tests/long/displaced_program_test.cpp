// A displaced mesh of ten million triangles, and a map of 16384 x 16384 texels, through the program.
#include "charted_torus.h"

#include "support/expect_numbers.h"

#include <foredraw/io/gltf/gltf.h>

namespace foredraw::displaced_program_test {
namespace {

#ifdef FOREDRAW_PROGRAM
class DisplacedProgram : public testing::InFolder {
 protected:
  /// Goes through the preset within 8 GiB.
  void expect_to_go_through(std::uint64_t triangles, std::uint32_t texels) {
    Diagnostics diagnostics;
    const Scene scene = testing::scene_of(testing::torus_of(triangles), testing::png_map(texels));
    const auto files = encode_gltf(scene, "in.glb", diagnostics);
    ASSERT_TRUE(files) << to_text(diagnostics);
    const auto& bytes = files->front().bytes;
    testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const std::string command = "optimize in.glb -o out.glb -p @displaced --memory-limit 8G";
    const testing::Ended ended = testing::run_program(folder_, command);
    testing::expect_numbers(ended, command);
    EXPECT_NE(ended.err.find("were unequal before, and 0 are now"), std::string::npos) << ended.err;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out.glb"));
  }
};

TEST_F(DisplacedProgram, TakesTenMillionTriangles) { expect_to_go_through(10'000'000, 4096); }

TEST_F(DisplacedProgram, TakesAMapOf16384) { expect_to_go_through(20'000, 16384); }
#endif

}  // namespace
}  // namespace foredraw::displaced_program_test
