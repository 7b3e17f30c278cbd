#pragma once
// Small meshes and scenes made on the spot, and a Run to call techniques with.

#include <foredraw/base/random.h>
#include <foredraw/scene/scene.h>
#include <foredraw/technique/run.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::testing {

struct TestMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

TestMesh grid(std::uint32_t columns, std::uint32_t rows);  ///< in the xy plane, 2 * columns * rows triangles
TestMesh sphere(std::uint32_t slices, std::uint32_t stacks, float radius = 1, glm::vec3 centre = glm::vec3(0));
TestMesh torus(std::uint32_t slices, std::uint32_t sides, float radius = 1, float tube = 0.4f);
TestMesh soup(std::uint32_t triangles, std::uint64_t seed);  ///< random triangles that share no vertex
TestMesh shuffled(TestMesh mesh, std::uint64_t seed);        ///< triangles in random order
TestMesh joined(const TestMesh& a, const TestMesh& b);

std::shared_ptr<const VertexStreams> vertex_streams(const std::vector<glm::vec3>& positions);
Draw draw_of(const TestMesh& mesh, std::string name = "mesh");
Scene scene_of(std::vector<Draw> draws);  ///< one mesh for each draw
Scene scene_of(const TestMesh& mesh);

/// Everything that a Run refers to.
struct RunFixture {
  Analyses analyses;
  Executor executor{2};
  Findings findings;
  Views views;
  Run run{analyses, executor, findings, views};
};

/// A file that ships with the project: "benchmarks/corpus/spot.glb".
std::filesystem::path project_file(const std::string& name);

}  // namespace foredraw::testing
