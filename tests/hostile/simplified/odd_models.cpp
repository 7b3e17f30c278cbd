#include "odd_models.h"

#include "support/collapses.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::testing {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

using Floats = std::vector<float>;

struct Attributes {
  Floats normals, uvs;
};

/// Normals from the first vertex's point of view, textures laid on from above.
Attributes attributes_of(const std::vector<glm::vec3>& positions) {
  Attributes made;
  for (const glm::vec3& p : positions) {
    const float length = glm::length(p);
    const glm::vec3 normal = std::isfinite(length) && length > 0 ? p / length : glm::vec3(0, 0, 1);
    const bool is_unit = std::abs(glm::length(normal) - 1) < 1e-3f;
    for (int k = 0; k < 3; ++k) made.normals.push_back(is_unit ? normal[k] : k == 2 ? 1.0f : 0.0f);
    for (int k = 0; k < 2; ++k) made.uvs.push_back(std::isfinite(p[k]) ? p[k] * 0.1f : 0.0f);
  }
  return made;
}

Floats flat(const std::vector<glm::vec3>& points) {
  Floats values;
  for (const glm::vec3& p : points) values.insert(values.end(), {p.x, p.y, p.z});
  return values;
}

bool are_finite(const Floats& values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

GltfJson& primitive(GltfBuilder& file) { return file.json["meshes"][0]["primitives"][0]; }

GltfBuilder file_of(const TestMesh& mesh, const Attributes& attributes) {
  GltfBuilder file;
  if (mesh.positions.empty()) {
    file.add_mesh({{"attributes", GltfJson::object()}});
    return file;
  }
  GltfJson names{{"POSITION", file.add_values(flat(mesh.positions), "VEC3")}};
  names["NORMAL"] = file.add_values(attributes.normals, "VEC3");
  names["TEXCOORD_0"] = file.add_values(attributes.uvs, "VEC2");
  file.add_mesh({{"attributes", names}});
  if (!mesh.indices.empty()) primitive(file)["indices"] = file.add_values(mesh.indices, "SCALAR");
  return file;
}

OddModel model_of(std::string name, const TestMesh& mesh) {
  const Attributes attributes = attributes_of(mesh.positions);
  return {std::move(name), file_of(mesh, attributes), are_finite(flat(mesh.positions))};
}

/// A torus with something else as one of its attributes.
OddModel torus_with(std::string name, const char* attribute, const char* type, const auto& value_of) {
  const TestMesh mesh = torus(24, 12);
  OddModel model = model_of(std::move(name), mesh);
  Floats values;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const float value : Floats(value_of(v))) values.push_back(value);
  }
  primitive(model.file)["attributes"][attribute] = model.file.add_values(values, type);
  model.is_finite = are_finite(values);
  return model;
}

/// Split again and again in the middles of their triangles: three of them meet at most vertices.
TestMesh of_valence_three() {
  TestMesh mesh{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
  for (int round = 0; round < 5; ++round) {
    std::vector<std::uint32_t> split;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
      const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 2.9f);
      split.insert(split.end(), {a, b, middle, b, c, middle, c, a, middle});
    }
    mesh.indices = split;
  }
  return mesh;
}

TestMesh tetrahedra(int along) {
  TestMesh all;
  for (int i = 0; i < along * along * along; ++i) {
    const glm::vec3 at(8 * (i % along), 8 * (i / along % along), 8 * (i / (along * along)));
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3 corner : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
      all.positions.push_back(at + corner);
    }
    for (const std::uint32_t v : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u}) all.indices.push_back(first + v);
  }
  return all;
}

/// Each triangle has corners of its own, whose texture coordinates differ by `by(triangle)`: six wedges at a point.
OddModel torn(std::string name, const auto& by) {
  const TestMesh whole = closed_torus(20, 10);
  TestMesh apart;
  for (const std::uint32_t v : whole.indices) {
    apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
    apart.positions.push_back(whole.positions[v]);
  }
  Attributes attributes = attributes_of(apart.positions);
  for (std::size_t i = 0; i < attributes.uvs.size(); ++i) attributes.uvs[i] = by(attributes.uvs[i], i / 6);
  return {std::move(name), file_of(apart, attributes), true};
}

/// Five sets of joints, whose weights are the same for all vertices.
OddModel skinned(std::string name, float weight) {
  const TestMesh mesh = torus(24, 12);
  OddModel model = model_of(std::move(name), mesh);
  std::vector<std::uint8_t> joints;
  for (std::size_t i = 0; i < 4 * mesh.positions.size(); ++i) joints.push_back(static_cast<std::uint8_t>(i % 3));
  const std::size_t joint_numbers = model.file.add_values(joints, "VEC4");
  const std::size_t weights = model.file.add_values(Floats(4 * mesh.positions.size(), weight), "VEC4");
  for (int set = 0; set < 5; ++set) {
    primitive(model.file)["attributes"]["JOINTS_" + std::to_string(set)] = joint_numbers;
    primitive(model.file)["attributes"]["WEIGHTS_" + std::to_string(set)] = weights;
  }
  GltfJson numbers = GltfJson::array();
  for (int i = 0; i < 3; ++i) numbers.push_back(model.file.add("nodes", {{"name", "joint"}}));
  model.file.add("skins", {{"joints", numbers}});
  model.file.json["nodes"][0]["skin"] = 0;
  model.is_finite = std::isfinite(weight);
  return model;
}

/// A morph target that moves every tenth vertex so far.
OddModel morphed(std::string name, float by) {
  const TestMesh mesh = torus(24, 12);
  OddModel model = model_of(std::move(name), mesh);
  Floats moves(3 * mesh.positions.size(), 0.0f);
  for (std::size_t i = 0; i < moves.size(); i += 30) moves[i] = by;
  primitive(model.file)["targets"] = GltfJson::array({{{"POSITION", model.file.add_values(moves, "VEC3")}}});
  model.is_finite = std::isfinite(by);
  return model;
}

void add_odd_meshes(std::vector<OddModel>& models) {
  int number = 0;
  for (const TestMesh& mesh : odd_meshes()) models.push_back(model_of("mesh " + std::to_string(number++), mesh));
  models.push_back(model_of("a hub of 10000", spokes(10'000)));
  models.push_back(model_of("valence of three", of_valence_three()));
  models.push_back(model_of("tetrahedra", tetrahedra(13)));
  TestMesh one_place = grid(12, 12);
  std::ranges::fill(one_place.positions, glm::vec3(2, 3, 4));
  models.push_back(model_of("one place", one_place));
  TestMesh pair = grid(1, 1);
  for (int i = 0; i < 6; ++i) pair.indices.insert(pair.indices.end(), pair.indices.begin(), pair.indices.end());
  models.push_back(model_of("one square again and again", pair));
  TestMesh nowhere = torus(24, 12);
  std::ranges::fill(nowhere.positions, glm::vec3(nan));
  models.push_back(model_of("nowhere", nowhere));
  TestMesh extremes = torus(24, 12);
  for (std::size_t v = 0; v < extremes.positions.size(); ++v) extremes.positions[v] *= v % 2 == 0 ? 2e38f : 1e-38f;
  models.push_back(model_of("the ends of floats", extremes));
}

void add_odd_attributes(std::vector<OddModel>& models) {
  const auto all = [](Floats values) { return [values](std::size_t) { return values; }; };
  const auto some = [](Floats values, Floats odd) {
    return [values, odd](std::size_t v) { return v % 7 == 3 ? odd : values; };
  };
  models.push_back(torus_with("texture coordinates of 0", "TEXCOORD_0", "VEC2", all({0, 0})));
  models.push_back(torus_with("texture coordinates not a number", "TEXCOORD_0", "VEC2", all({nan, nan})));
  models.push_back(
      torus_with("some texture coordinates not a number", "TEXCOORD_0", "VEC2", some({0.5f, 0}, {nan, 1})));
  models.push_back(
      torus_with("some texture coordinates infinite", "TEXCOORD_0", "VEC2", some({0.5f, 0}, {infinity, -infinity})));
  models.push_back(torus_with("texture coordinates of 1e30", "TEXCOORD_0", "VEC2", [](std::size_t v) {
    return Floats{1e30f * float(v % 5), -1e30f * float(v % 3)};
  }));
  models.push_back(torus_with("texture coordinates at the ends of floats", "TEXCOORD_0", "VEC2", [](std::size_t v) {
    return Floats{v % 2 == 0 ? 3e38f : -3e38f, v % 3 == 0 ? 3e38f : 0};
  }));
  models.push_back(torus_with("normals of 0", "NORMAL", "VEC3", all({0, 0, 0})));
  models.push_back(torus_with("some normals of 0", "NORMAL", "VEC3", some({0, 0, 1}, {0, 0, 0})));
  models.push_back(torus_with("normals not a number", "NORMAL", "VEC3", all({nan, nan, nan})));
  models.push_back(torus_with("some normals not a number", "NORMAL", "VEC3", some({0, 0, 1}, {nan, 0, 0})));
  models.push_back(torus_with("normals of 1e20", "NORMAL", "VEC3", all({1e20f, -1e20f, 1e20f})));
  models.push_back(torus_with("normals of 1e-30", "NORMAL", "VEC3", all({1e-30f, 0, 0})));
  models.push_back(torus_with("opposite normals", "NORMAL", "VEC3", [](std::size_t v) {
    return Floats{0, 0, v % 2 == 0 ? 1.0f : -1.0f};
  }));
  models.push_back(
      torus_with("some colours not a number", "COLOR_0", "VEC4", some({1, 0, 0, 1}, {nan, 2, -1, infinity})));
  models.push_back(torus_with("odd numbers of its own", "_HEAT", "SCALAR", some({1}, {-infinity})));
  models.push_back(torn("six wedges at a point", [](float uv, std::size_t t) { return uv + float(t % 11); }));
  models.push_back(torn("wedges that differ in a bit",
                        [](float uv, std::size_t t) { return t % 2 == 0 ? uv : std::nextafter(uv, 9.0f); }));
  models.push_back(skinned("five sets of joints", 0.05f));
  models.push_back(skinned("joints without weight", 0));
  models.push_back(skinned("weights not a number", nan));
  models.push_back(morphed("a target that moves by a million", 1e6f));
  models.push_back(morphed("a target to nowhere", nan));
}

void add_odd_nodes(std::vector<OddModel>& models) {
  for (const double scale : {0.0, 1e-30, 1e30, -1.0}) {
    OddModel model{"a node scaled by " + std::to_string(models.size()), plain_model(24, 12)};
    model.file.json["nodes"][0]["scale"] = {scale, scale, scale};
    models.push_back(std::move(model));
  }
  for (const int mode : {0, 1, 4, 5, 6}) {
    OddModel model{"mode " + std::to_string(mode), plain_model(12, 8)};
    primitive(model.file)["mode"] = mode;
    models.push_back(std::move(model));
  }
  OddModel shared{"one accessor twice", plain_model(24, 12)};
  shared.file.json["meshes"][0]["primitives"].push_back(primitive(shared.file));
  models.push_back(std::move(shared));
}

}  // namespace

GltfBuilder plain_model(std::uint32_t slices, std::uint32_t sides) { return model_of("", torus(slices, sides)).file; }

GltfBuilder model_with_indices_out_of_range() {
  TestMesh mesh = torus(24, 12);
  mesh.indices[100] = static_cast<std::uint32_t>(mesh.positions.size());
  return model_of("", mesh).file;
}

std::vector<OddModel> odd_models() {
  std::vector<OddModel> models;
  add_odd_meshes(models);
  add_odd_attributes(models);
  add_odd_nodes(models);
  return models;
}

}  // namespace foredraw::testing
