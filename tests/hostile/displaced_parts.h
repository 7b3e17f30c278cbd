#pragma once
// A small displaced draw in a file of its own, with all its parts open to harm.

#include "support/gltf_builder.h"
#include "support/image_builder.h"
#include "support/program.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace foredraw::testing {

inline std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline std::vector<std::uint16_t> noise(std::size_t count, std::uint32_t bits) {
  std::vector<std::uint16_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::uint16_t>((i * 2654435761u >> 7) % (1u << bits));
  return values;
}

/// Two strips of squares that meet at x = 2, each laid out in a chart of its own.
struct Parts {
  std::vector<float> positions, uvs, normals, tangents;
  std::vector<float> weights;  ///< of two joints; with some the draw is skinned, and the second joint moves
  std::vector<std::uint16_t> indices;
  GltfJson displacement = {{"displacementGeometryTexture", {{"index", 0}}}, {"displacementGeometryFactor", 0.5}};
  GltfJson sampler = GltfJson::object();
  GltfJson node = GltfJson::object();
  std::string map;  ///< its file; in the draw's own where there is none
  int uv_set = 0;   ///< where the layout is

  Parts() {
    for (int half = 0; half < 2; ++half) {
      for (int y = 0; y <= 4; ++y) {
        for (int x = 0; x <= 2; ++x) {
          const float u = 0.05f + 0.2f * float(x), v = 0.1f + 0.2f * float(y);
          add_vertex({float(x + 2 * half), float(y), 0},
                     half == 0 ? std::array{u, v} : std::array{0.95f - 0.4f * v, 0.95f - u});
        }
      }
      for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 2; ++x) {
          const auto a = static_cast<std::uint16_t>(15 * half + 3 * y + x);
          for (const int step : {0, 1, 3, 1, 4, 3}) indices.push_back(static_cast<std::uint16_t>(a + step));
        }
      }
    }
  }

  std::size_t vertices() const { return positions.size() / 3; }

  void clear() {
    for (auto* values : {&positions, &uvs, &normals, &tangents, &weights}) values->clear();
    indices.clear();
  }
  void add_vertex(const std::array<float, 3>& position, const std::array<float, 2>& uv) {
    positions.insert(positions.end(), position.begin(), position.end());
    uvs.insert(uvs.end(), uv.begin(), uv.end());
    normals.insert(normals.end(), {0, 0, 1});
  }

  /// Of squares, laid out as they are, with `at` their corners' places.
  void become_sheet(int columns, int rows, const std::function<std::array<float, 3>(int x, int y)>& at) {
    clear();
    for (int y = 0; y <= rows; ++y) {
      for (int x = 0; x <= columns; ++x) add_vertex(at(x, y), {float(x) / float(columns), float(y) / float(rows)});
    }
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const int a = y * (columns + 1) + x, b = a + columns + 1;
        for (const int corner : {a, a + 1, b, a + 1, b + 1, b}) indices.push_back(static_cast<std::uint16_t>(corner));
      }
    }
  }

  std::string glb() const {
    GltfBuilder file;
    GltfJson attributes{{"POSITION", file.add_values(positions, "VEC3")}};
    const std::string layout = "TEXCOORD_" + std::to_string(uv_set);
    if (uv_set > 0) attributes["TEXCOORD_0"] = file.add_values(std::vector<float>(2 * vertices(), 0.5f), "VEC2");
    if (!uvs.empty()) attributes[layout] = file.add_values(uvs, "VEC2");
    if (!normals.empty()) attributes["NORMAL"] = file.add_values(normals, "VEC3");
    if (!tangents.empty()) attributes["TANGENT"] = file.add_values(tangents, "VEC4");
    if (!weights.empty()) {
      std::vector<std::uint8_t> joints;
      std::vector<float> all;
      for (std::size_t v = 0; v < vertices(); ++v) {
        joints.insert(joints.end(), {0, 1, 0, 0});
        all.insert(all.end(), {weights[2 * v], weights[2 * v + 1], 0, 0});
      }
      attributes["JOINTS_0"] = file.add_values(joints, "VEC4");
      attributes["WEIGHTS_0"] = file.add_values(all, "VEC4");
    }
    file.add_mesh({{"attributes", attributes}, {"indices", file.add_values(indices, "SCALAR")}, {"material", 0}});
    file.json["nodes"][0].update(node);
    if (!weights.empty()) add_skin(file);
    file.add("materials", {{"extensions", {{"KHR_materials_displacement", displacement}}}});
    if (map.empty()) {
      const std::size_t view = file.add_view(png_of({32, 32, 1, 16}, noise(1024, 16)));
      file.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    } else {
      file.add("images", {{"uri", map}});
    }
    file.add("samplers", sampler);
    file.add("textures", {{"source", 0}, {"sampler", 0}});
    file.json["extensionsUsed"] = {"KHR_materials_displacement", "KHR_texture_transform"};
    return text_of(file.glb());
  }

 private:
  /// Two joints at the origin, the second of which moves by 3 in a second.
  static void add_skin(GltfBuilder& file) {
    std::vector<std::size_t> joints;
    for (const char* name : {"still", "moved"}) joints.push_back(file.add("nodes", {{"name", name}}));
    file.json["nodes"][0]["skin"] = file.add("skins", {{"joints", joints}});
    const std::size_t times = file.add_values(std::vector<float>{0, 1}, "SCALAR");
    file.json["accessors"][times]["min"] = {0};
    file.json["accessors"][times]["max"] = {1};
    const std::size_t places = file.add_values(std::vector<float>{0, 0, 0, 0, 0, 3}, "VEC3");
    file.add("animations",
             {{"name", "away"},
              {"samplers", {{{"input", times}, {"output", places}}}},
              {"channels", {{{"sampler", 0}, {"target", {{"node", joints[1]}, {"path", "translation"}}}}}}});
  }
};

}  // namespace foredraw::testing
