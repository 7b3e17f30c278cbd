// Wires of meshes whose positions are whole numbers.
#include "plugins/processors/wire_radius/wires_product.h"

#include "benchmarks/wire_radius/wire_sets.h"
#include "support/gltf_builder.h"
#include "support/staged.h"

#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw::wire_radius_whole_numbers_test {
namespace {

bench::KnownMesh antenna() {
  for (bench::KnownMesh& mesh : bench::made_meshes(201)) {
    if (mesh.name == "antenna on a body") return std::move(mesh);
  }
  throw std::invalid_argument("antenna on a body");
}

Scene read_built(const testing::GltfBuilder& builder) {
  Diagnostics diagnostics;
  auto scene = read_gltf(builder.glb(), "scene.glb", {}, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return std::move(*scene);
}

/// KHR_mesh_quantization: a node scales back, so radii are in steps, as positions are.
TEST(WireRadiusFiles, WiresOfWholeNumbersAreInTheirSteps) {
  const bench::KnownMesh mesh = antenna();
  glm::vec3 least = mesh.positions[0], most = least;
  for (const glm::vec3& at : mesh.positions) {
    least = glm::min(least, at);
    most = glm::max(most, at);
  }
  const float step = std::max({most.x - least.x, most.y - least.y, most.z - least.z}) / 16383;
  std::vector<std::uint16_t> whole;
  for (const glm::vec3& at : mesh.positions) {
    for (int i = 0; i < 3; ++i) whole.push_back(static_cast<std::uint16_t>(std::lround((at[i] - least[i]) / step)));
    whole.push_back(0);  // rows of eight bytes
  }
  testing::GltfBuilder builder;
  const std::size_t view = builder.add_view(std::as_bytes(std::span(whole)), 8);
  const std::size_t at = builder.add_accessor(view, 0, 5123, "VEC3", mesh.positions.size());
  builder.json["accessors"][at]["min"] = {0, 0, 0};
  builder.json["accessors"][at]["max"] = {16383, 16383, 16383};
  builder.add_mesh({{"attributes", {{"POSITION", at}}}, {"indices", builder.add_values(mesh.indices, "SCALAR")}});
  builder.json["nodes"][0]["scale"] = {step, step, step};
  builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};

  Diagnostics diagnostics;
  const Scene of_whole = testing::run("wire-radius", read_built(builder)).scene;
  const auto files = encode_gltf(of_whole, "out.glb", diagnostics, {.products = {wires_product()}});
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics, {.products = {wires_product()}});
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_EQ(again->draws[0].full().vertices->find("POSITION")->format.component, Component::uint16);
  testing::GltfBuilder plain;
  std::vector<float> values;
  for (const glm::vec3& place : mesh.positions) values.insert(values.end(), {place.x, place.y, place.z});
  const std::size_t floats = plain.add_values(values, "VEC3");
  plain.json["accessors"][floats]["min"] = {-100, -100, -100};
  plain.json["accessors"][floats]["max"] = {100, 100, 100};
  plain.add_mesh({{"attributes", {{"POSITION", floats}}}, {"indices", plain.add_values(mesh.indices, "SCALAR")}});
  const Scene of_floats = testing::run("wire-radius", read_built(plain)).scene;
  const Wires *found = again->products.find<Wires>(), *want = of_floats.products.find<Wires>();
  ASSERT_TRUE(found != nullptr && want != nullptr);
  ASSERT_EQ(found->draws[0].wires.size(), want->draws[0].wires.size());
  const double radius = want->draws[0].wires[0].radius;
  EXPECT_NEAR(found->draws[0].wires[0].radius * step, radius, .03 * radius);
}

}  // namespace
}  // namespace foredraw::wire_radius_whole_numbers_test
