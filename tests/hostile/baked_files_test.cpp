// Meshes of many triangles that are none, no surface, inside out or nowhere, baked into cages through the program: each
// ends, and is baked or told why not.
#include "support/expect_numbers.h"
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/base/random.h>

#include <cmath>
#include <limits>

namespace foredraw::baked_files_test {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::TestMesh;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

std::string glb_of(const TestMesh& mesh) {
  testing::GltfBuilder file;
  std::vector<float> positions;
  for (const glm::vec3& at : mesh.positions) positions.insert(positions.end(), {at.x, at.y, at.z});
  file.add_mesh({{"attributes", {{"POSITION", file.add_values(positions, "VEC3")}}},
                 {"indices", file.add_values(mesh.indices, "SCALAR")}});
  const std::vector<std::byte> bytes = file.glb();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TestMesh bumps() {
  TestMesh mesh = testing::sphere(32, 24);
  for (glm::vec3& p : mesh.positions) p *= 1 + 0.05f * std::sin(9 * p.x) * std::sin(7 * p.y) * std::sin(8 * p.z);
  return mesh;
}

template <class Change>
TestMesh changed(const Change& change) {
  TestMesh mesh = bumps();
  std::size_t v = 0;
  for (glm::vec3& at : mesh.positions) change(at, v++);
  return mesh;
}

TestMesh turned(std::size_t every) {
  TestMesh mesh = bumps();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3 * every) std::swap(mesh.indices[i], mesh.indices[i + 1]);
  return mesh;
}

TestMesh twice() {
  TestMesh mesh = bumps();
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const TestMesh once = mesh;
  mesh.positions.insert(mesh.positions.end(), once.positions.begin(), once.positions.end());
  for (const std::uint32_t index : once.indices) mesh.indices.push_back(count + index);
  return mesh;
}

TestMesh lines() {
  TestMesh mesh = bumps();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) mesh.indices[i + 1] = mesh.indices[i];
  return mesh;
}

class BakedFiles : public testing::InFolder {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }
};

TEST_F(BakedFiles, EndBakedOrToldWhyNot) {
  Random random(1);
  const std::vector<std::pair<const char*, TestMesh>> meshes = {
      {"right", bumps()},
      {"inside-out", turned(1)},
      {"half-turned", turned(2)},
      {"soup", testing::soup(1500, 3)},
      {"twice", twice()},
      {"lines", lines()},
      {"noise", changed([&](glm::vec3& at, std::size_t) { at *= 0.5f + static_cast<float>(random.unit()); })},
      {"spikes", changed([](glm::vec3& at, std::size_t v) { at *= v % 101 == 0 ? 50 : 1; })},
      {"some-no-numbers", changed([](glm::vec3& at, std::size_t v) { at.x = v % 97 == 0 ? nan : at.x; })},
      {"no-numbers", changed([](glm::vec3& at, std::size_t) { at = glm::vec3(nan); })},
      {"infinite", changed([](glm::vec3& at, std::size_t) { at.y = inf; })},
      {"a-point", changed([](glm::vec3& at, std::size_t) { at = glm::vec3(1); })},
      {"a-line", changed([](glm::vec3& at, std::size_t) { at.y = at.z = 0; })},
      {"flat", changed([](glm::vec3& at, std::size_t) { at.z = 0; })},
      {"1e30", changed([](glm::vec3& at, std::size_t) { at *= 1e30f; })},
      {"1e-30", changed([](glm::vec3& at, std::size_t) { at *= 1e-30f; })},
      {"far", changed([](glm::vec3& at, std::size_t) { at += 1e6f; })},
  };
  for (const auto& [name, mesh] : meshes) {
    testing::put(folder_ / "a.glb", glb_of(mesh));
    const std::string command =
        "optimize a.glb -o b.glb -p 'weld, quadric-collapse, displacement-bake(rms=0.005, cage=0.2, finest=4)' --with "
        "surface-error";
    const testing::Ended ended = run(command);
    testing::expect_numbers(ended, std::string(name) + ": " + command);
    const auto says = [&](const char* words) { return (ended.out + ended.err).find(words) != std::string::npos; };
    EXPECT_TRUE(says(" heights of ") || says("displacement-bake left the scene alone: ")) << name << ended.err;
  }
}

TEST_F(BakedFiles, OfNoTrianglesAreRefused) {
  TestMesh mesh = bumps();
  mesh.indices.clear();
  testing::put(folder_ / "a.glb", glb_of(mesh));
  const testing::Ended ended = run("optimize a.glb -o b.glb -p 'weld, quadric-collapse, displacement-bake'");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_NE(ended.err.find("a.glb: error: accessors[1].count: is 0"), std::string::npos) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
}
#endif

}  // namespace
}  // namespace foredraw::baked_files_test
