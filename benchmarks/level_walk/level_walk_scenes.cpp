// Writes a scene that a camera walks through.
//
//     level-walk-scenes --output=FILE.glb --scene=city|field|building [--instances=N] [--characters=N] [--seed=N]
//                       [--gpu-instancing]
//
// The same options give the same file, byte for byte, on every machine. --gpu-instancing places each mesh by one node
// with EXT_mesh_gpu_instancing.

#include "walk_scene.h"

#include <foredraw/io/gltf/gltf.h>

#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <span>
#include <stdexcept>

namespace foredraw::bench {
namespace {

struct Wanted {
  std::string output;
  std::string scene;
  WalkOptions options;
};

bool read_number(std::string_view text, std::uint64_t& number, std::uint64_t least, std::uint64_t most) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= least && number <= most;
}

/// Whether the argument is one that there is, with a value that it may have.
bool read_argument(std::string_view word, Wanted& wanted) {
  const std::string_view name = word.substr(0, word.find('='));
  const std::string_view value = word.substr(std::min(name.size() + 1, word.size()));
  if (name == "--output") {
    wanted.output = value;
    return value.ends_with(".glb");
  }
  if (name == "--scene") {
    wanted.scene = value;
    return value == "city" || value == "field" || value == "building";
  }
  if (name == "--instances") return read_number(value, wanted.options.instances, 1, 4'000'000);
  if (name == "--characters") return read_number(value, wanted.options.characters, 0, 10'000);
  if (name == "--seed") return read_number(value, wanted.options.seed, 0, ~std::uint64_t{0});
  if (name == "--gpu-instancing") wanted.options.gpu_instancing = true;
  return word == "--gpu-instancing";
}

void write(const Wanted& wanted) {
  const Scene scene = wanted.scene == "city"    ? city_walk(wanted.options)
                      : wanted.scene == "field" ? field_walk(wanted.options)
                                                : building_walk(wanted.options);
  std::uint64_t triangles = 0, placed = 0, placed_triangles = 0;
  for (const Draw& draw : scene.draws) triangles += draw.full().stream().triangle_count();
  for (const Node& node : scene.nodes) {
    if (!node.mesh) continue;
    const std::uint64_t times = std::max<std::size_t>(node.instances.view().size(), 1);
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      placed += times;
      placed_triangles += times * (scene.draws[draw].full().stream().triangle_count());
    }
  }
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, wanted.output, diagnostics);
  if (!files || !write_files(*files, diagnostics)) throw std::runtime_error(to_text(diagnostics));
  fmt::print(
      "{}: {} meshes of {} primitives and {} triangles, {} materials; {} placed primitives of {} triangles, {} nodes, "
      "{} "
      "skins, {} bytes\n",
      wanted.output, scene.meshes.size(), scene.draws.size(), triangles, scene.materials.size(), placed,
      placed_triangles, scene.nodes.size(), scene.skins.size(), files->front().bytes.size());
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  foredraw::bench::Wanted wanted;
  wanted.options.corpus = std::filesystem::path(FOREDRAW_SOURCE_DIR) / "benchmarks/corpus";
  for (const std::string_view word : std::span(argv + 1, argv + argc)) {
    if (foredraw::bench::read_argument(word, wanted)) continue;
    std::cerr << argv[0] << ": '" << word
              << "' is unknown or out of range; use --output=FILE.glb, --scene=city|field|building, "
                 "--instances=1..4000000, --characters=0..10000, --seed=N, --gpu-instancing\n";
    return 1;
  }
  if (wanted.output.empty() || wanted.scene.empty()) {
    std::cerr << argv[0] << ": --output=FILE.glb and --scene=city|field|building are needed\n";
    return 1;
  }
  try {
    foredraw::bench::write(wanted);
  } catch (const std::exception& problem) {
    std::cerr << argv[0] << ": " << problem.what() << '\n';
    return 2;
  }
}
