// What an engine needs to draw a displaced surface with its own tessellation: the shaders of a scene's first draw that
// a map of heights moves, in GLSL and HLSL, and the buffers that they read.
//
//   displaced_shaders SCENE.glb FOLDER
//
// The map itself is the image that the scene names, as a texture with its 8 or 16 bits (UNORM), level 0 alone.

#include <foredraw/displaced/cage_buffers.h>
#include <foredraw/displaced/displaced_shader.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

namespace {

using foredraw::DisplacedStage;
using foredraw::ShaderLanguage;

struct DisplacedDraw {
  foredraw::DrawId draw = 0;
  foredraw::LaidOutMap map;
};

DisplacedDraw first_displaced(const foredraw::Scene& scene, foredraw::Analyses& analyses) {
  std::string why = "there is none";
  for (foredraw::DrawId draw = 0; draw < scene.draws.size(); ++draw) {
    auto map = laid_out_map(scene, draw, analyses);
    if (auto* found = std::get_if<foredraw::LaidOutMap>(&map)) return {draw, std::move(*found)};
    why = scene.draws[draw].name + ": " + std::get<std::string>(map);
  }
  throw std::runtime_error("no draw has a map of heights (" + why +
                           "); `foredraw show displacement` says how to get one");
}

/// Of the node that shows the draw; 0: no joints move it.
std::uint32_t joints_of(const foredraw::Scene& scene, foredraw::DrawId draw) {
  for (const foredraw::Node& node : scene.nodes) {
    if (!node.mesh || !node.skin) continue;
    for (const foredraw::DrawId shown : scene.meshes[*node.mesh].draws) {
      if (shown == draw) return static_cast<std::uint32_t>(scene.skins[*node.skin].joints.size());
    }
  }
  return 0;
}

void write(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

void write_shaders(const foredraw::DisplacedShader& shader, const std::filesystem::path& folder) {
  struct File {
    const char* name;
    DisplacedStage stage;
  };
  constexpr File files[] = {{"cage.comp", DisplacedStage::cage},
                            {"vertex.vert", DisplacedStage::vertex},
                            {"vertex_of_cage.vert", DisplacedStage::vertex_of_cage},
                            {"control.tesc", DisplacedStage::control},
                            {"evaluation.tese", DisplacedStage::evaluation}};
  const auto text = [&](const std::string& name, const std::string& content) {
    write(folder / name, std::as_bytes(std::span(content)));
  };
  for (const auto& [name, stage] : files) {
    text(name, "#version 450\n\n" + displaced_shader_text(shader, ShaderLanguage::glsl, stage));
    text(name + std::string(".hlsl"), displaced_shader_text(shader, ShaderLanguage::hlsl, stage));
  }
  text("cage_capture.vert",
       "#version 450\n\n" + displaced_shader_text(shader, ShaderLanguage::glsl, DisplacedStage::cage_capture));
}

void run(const char* path, const std::filesystem::path& folder) {
  foredraw::Diagnostics diagnostics;
  const auto file = foredraw::read_scene(path, diagnostics);
  std::fprintf(stderr, "%s", foredraw::to_text(diagnostics).c_str());
  if (!file) throw std::runtime_error("there is no scene to read");
  foredraw::Analyses analyses(foredraw::image_decoder(path));
  const auto [id, map] = first_displaced(file->scene, analyses);
  const foredraw::Draw& draw = file->scene.draws[id];
  const foredraw::VertexStreams& vertices = *draw.full().vertices;

  foredraw::DisplacedShader shader;
  shader.map = map.sampled();
  shader.factor = map.displacement.factor;
  shader.offset = map.displacement.offset;
  shader.vertices = vertices.count;
  const std::uint32_t joints = joints_of(file->scene, id);
  if (joints > 0) shader.joints = joints + 1;  // and the node's map, for vertices that no joint moves

  const auto rest = foredraw::cage_vertices(decode_vec3(*vertices.find("POSITION")),
                                            displacement_directions(file->scene, id, analyses), map.places);
  std::filesystem::create_directories(folder);
  write_shaders(shader, folder);
  write(folder / "rest.bin", std::as_bytes(std::span(rest)));
  write(folder / "indices.bin", std::as_bytes(draw.full().stream().indices.view()));
  if (joints > 0) {
    const auto skin = foredraw::cage_skin(vertices, joints);
    write(folder / "skin.bin", std::as_bytes(std::span(skin)));
  }
  std::printf("%s: %u vertices, %u joints, a map of %u x %u texels\n", draw.name.c_str(), vertices.count, joints,
              shader.map.width, shader.map.height);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: displaced_shaders SCENE FOLDER\n");
    return 2;
  }
  try {
    run(arguments[1], arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "displaced_shaders: %s: %s\n", arguments[1], error.what());
    return 1;
  }
}
