// The example writes what an engine needs to draw a scene's displaced surface.

#include "support/compiled_shader.h"
#include "support/meshes.h"

namespace foredraw::displaced_shaders_test {
namespace {

class DisplacedShaders : public testing::InFolder {
 protected:
  int run(const std::string& scene) {
    std::string command = "'" FOREDRAW_DISPLACED_SHADERS "'";
    for (const std::string& argument : {" '" + scene, "' '" + (folder_ / "out").string(), "' > '" + told_path()})
      command += argument;
    command += "' 2>&1";
    const int status = std::system(command.c_str());
    told_ = testing::content(told_path());
    return WEXITSTATUS(status);
  }
  std::string told_path() const { return (folder_ / "told").string(); }
  std::string written(const std::string& name) const { return testing::content(folder_ / "out" / name); }

  std::string told_;
};

TEST_F(DisplacedShaders, OfASkinnedModelWithAMap) {
  const std::string model = testing::project_file("benchmarks/corpus/animated/fox.glb").string(),
                    map = testing::project_file("benchmarks/corpus/particles/kenney_scorch_02.png").string();
  const testing::Ended made = testing::run_program(
      folder_, "optimize '" + model + "' -o moved.glb -p 'displacement(map=\"" + map + "\", factor=0.5)'");
  ASSERT_EQ(made.code, 0) << made.err;
  ASSERT_EQ(run((folder_ / "moved.glb").string()), 0) << told_;
  unsigned vertices = 0, joints = 0, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(told_.c_str() + told_.find(": "), ": %u vertices, %u joints, a map of %u x %u", &vertices,
                        &joints, &width, &height),
            4)
      << told_;
  EXPECT_GT(vertices, 1000u);
  EXPECT_EQ(joints, 24u);
  EXPECT_EQ(written("rest.bin").size(), 32 * vertices);
  EXPECT_EQ(written("skin.bin").size(), 32 * vertices);
  EXPECT_GT(written("indices.bin").size(), 0u);
  EXPECT_NE(written("vertex.vert").find("const uint displaced_joints = 25u;"), std::string::npos);
  EXPECT_NE(written("evaluation.tese").find("const float displaced_factor = 0.5;"), std::string::npos);
  if (!testing::has_shader_compiler()) GTEST_SKIP() << "there is no glslangValidator";
  for (const std::string name :
       {"cage.comp", "cage_capture.vert", "vertex.vert", "vertex_of_cage.vert", "control.tesc", "evaluation.tese"}) {
    const std::string glsl = written(name), stage = name.substr(name.find('.') + 1);
    ASSERT_EQ(glsl.find("#version 450\n"), 0u);  // the compiler's is in front of what it gets here
    EXPECT_FALSE(testing::compiled_shader(glsl.substr(13), ShaderLanguage::glsl, stage).empty());
    if (name == "cage_capture.vert") continue;
    EXPECT_FALSE(testing::compiled_shader(written(name + ".hlsl"), ShaderLanguage::hlsl, stage).empty());
  }
}

TEST_F(DisplacedShaders, SaysWhatIsMissing) {
  EXPECT_EQ(run(testing::project_file("benchmarks/corpus/static/spot.glb").string()), 1);
  EXPECT_NE(told_.find("no draw has a map of heights"), std::string::npos) << told_;
  EXPECT_EQ(run("nowhere.glb"), 1);
}

}  // namespace
}  // namespace foredraw::displaced_shaders_test
