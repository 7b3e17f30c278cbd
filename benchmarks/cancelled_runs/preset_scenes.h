#pragma once
// A scene for each preset, in which every stage of it has something to do.

#include <foredraw/c/foredraw.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {

struct MeshForPreset {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;
};

/// A bumpy torus of 2 * n * n triangles, in an order that no cache likes.
inline MeshForPreset ring(std::uint32_t n) {
  MeshForPreset mesh;
  constexpr float turn = 6.2831853f;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const float u = turn * static_cast<float>(i / n) / static_cast<float>(n);
    const float v = turn * static_cast<float>(i % n) / static_cast<float>(n);
    const float radius = 0.4f + 0.02f * std::sin(9 * u) * std::sin(7 * v);
    for (const float value :
         {(1 + radius * std::cos(v)) * std::cos(u), radius * std::sin(v), (1 + radius * std::cos(v)) * std::sin(u)}) {
      mesh.positions.push_back(value);
    }
    for (const float value : {std::cos(v) * std::cos(u), std::sin(v), std::cos(v) * std::sin(u)}) {
      mesh.normals.push_back(value);
    }
    mesh.texcoords.push_back(u / turn), mesh.texcoords.push_back(v / turn);
  }
  constexpr std::uint64_t stride = 2654435761u;  // prime to every n * n here
  for (std::uint64_t k = 0; k < std::uint64_t{n} * n; ++k) {
    const auto i = static_cast<std::uint32_t>(k * stride % (std::uint64_t{n} * n));
    const std::uint32_t row = i / n, column = i % n;
    const std::uint32_t b = (row + 1) % n * n + column, c = row * n + (column + 1) % n;
    const std::uint32_t d = (row + 1) % n * n + (column + 1) % n;
    for (const std::uint32_t corner : {i, c, b, b, c, d}) mesh.indices.push_back(corner);
  }
  return mesh;
}

/// So many wires beside each other, of 720 triangles each.
inline MeshForPreset wires(std::uint32_t count) {
  MeshForPreset mesh;
  constexpr std::uint32_t sides = 6, rings = 61;
  constexpr float turn = 6.2831853f, radius = 0.01f;
  for (std::uint32_t i = 0; i < count * rings * sides; ++i) {
    const auto wire = static_cast<float>(i / (rings * sides)), ring = static_cast<float>(i / sides % rings);
    const float angle = turn * static_cast<float>(i % sides) / sides;
    const float x = std::cos(angle), y = std::sin(angle);
    for (const float value : {wire + radius * x, 0.1f * std::sin(0.1f * ring) + radius * y, 0.1f * ring}) {
      mesh.positions.push_back(value);
    }
    for (const float value : {x, y, 0.0f}) mesh.normals.push_back(value);
    mesh.texcoords.push_back(angle / turn), mesh.texcoords.push_back(ring / rings);
    if (i / sides % rings + 1 == rings) continue;
    const std::uint32_t beside = i / sides * sides + (i + 1) % sides;
    for (const std::uint32_t corner : {i, beside, i + sides, i + sides, beside, beside + sides}) {
      mesh.indices.push_back(corner);
    }
  }
  return mesh;
}

inline foredraw_scene* scene_with(foredraw_context* context, const MeshForPreset& mesh) {
  const foredraw_stream streams[] = {{"NORMAL", mesh.normals.data(), 0, FOREDRAW_FLOAT32, 3, 0},
                                     {"TEXCOORD_0", mesh.texcoords.data(), 0, FOREDRAW_FLOAT32, 2, 0}};
  foredraw_draw draw{};
  draw.size = sizeof draw;
  draw.vertex_count = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  draw.triangle_count = mesh.indices.size() / 3;
  draw.indices = mesh.indices.data();
  draw.positions = mesh.positions.data();
  draw.streams = streams;
  draw.stream_count = 2;
  foredraw_scene* scene = nullptr;
  if (foredraw_make_scene(context, &draw, 1, &scene, nullptr) != FOREDRAW_DONE) throw std::runtime_error("no scene");
  return scene;
}

/// `size`: of the mesh, where it is made; vertices around a torus. The caller frees the scene.
inline foredraw_scene* scene_for(foredraw_context* context, const std::string& preset, const std::string& corpus,
                                 std::uint32_t size) {
  foredraw_scene* scene = nullptr;
  const auto read = [&](const std::string& file) {
    if (foredraw_read(context, (corpus + file).c_str(), &scene, nullptr) != FOREDRAW_DONE) {
      throw std::runtime_error(file);
    }
    return scene;
  };
  if (preset == "sprites") return read("particles/atlas_smoke15frames.json");
  if (preset == "character") return read("animated/cesium_man_notex.glb");
  if (preset == "city") return read("scenes/house.glb");
  if (preset == "wires") return scene_with(context, wires(size * size / 80));
  if (preset != "displaced") return scene_with(context, ring(size));
  foredraw_scene* plain = scene_with(context, ring(size));
  const std::string pipeline = "displacement(map=\"" + corpus + "particles/kenney_dirt_03.png\")";
  const int status = foredraw_optimize(context, plain, pipeline.c_str(), &scene, nullptr);
  foredraw_scene_free(plain);
  if (status != FOREDRAW_DONE) throw std::runtime_error(pipeline);
  return scene;
}

}  // namespace foredraw::bench
