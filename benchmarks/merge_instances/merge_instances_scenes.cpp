// Writes a scene of many instances, made of a kit of the corpus.
//
//     merge-instances-scenes --output=FILE.glb [--kit=city|space] [--instances=N] [--seed=N] [--mirrored=PART]
//                            [--gpu-instancing]
//
// The same options give the same file, byte for byte, on every machine. --gpu-instancing places each mesh by one node
// with EXT_mesh_gpu_instancing.

#include "gpu_instancing.h"
#include "layout.h"

#include <foredraw/io/gltf/gltf.h>

#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <stdexcept>

namespace foredraw::bench {
namespace {

struct Wanted {
  std::string output;
  std::string kit = "city";
  LayoutOptions layout;
  bool gpu_instancing = false;
};

template <class T>
bool read_number(std::string_view text, T& number, T least, T most) {
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
  if (name == "--kit") {
    wanted.kit = value;
    return value == "city" || value == "space";
  }
  if (name == "--instances") {
    return read_number<std::uint64_t>(value, wanted.layout.instances, 1, 4'000'000);
  }
  if (name == "--seed") return read_number<std::uint64_t>(value, wanted.layout.seed, 0, ~std::uint64_t{0});
  if (name == "--mirrored") return read_number(value, wanted.layout.mirrored, 0.0, 1.0);
  if (name == "--gpu-instancing") wanted.gpu_instancing = true;
  return word == "--gpu-instancing";
}

void write(const Wanted& wanted) {
  const std::filesystem::path scenes = std::filesystem::path(FOREDRAW_SOURCE_DIR) / "benchmarks/corpus/scenes";
  const bool is_city = wanted.kit == "city";
  const Kit kit = read_kit(scenes / (is_city ? "kaykit_city" : "kenney_space_kit"));
  const std::vector<Placement> placements =
      is_city ? city_layout(kit, wanted.layout) : space_layout(kit, wanted.layout);
  Scene scene = placed_scene(kit, placements, wanted.output);
  std::uint64_t instances = 0;
  for (const Placement& placement : placements) instances += kit.models[placement.model].primitives;
  if (wanted.gpu_instancing) scene = with_gpu_instancing(scene);
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, wanted.output, diagnostics);
  if (!files || !write_files(*files, diagnostics)) throw std::runtime_error(to_text(diagnostics));
  fmt::print("{}: {} models placed, {} placed primitives of {} meshes and {} materials, {} bytes\n", wanted.output,
             placements.size(), instances, scene.meshes.size(), scene.materials.size(), files->front().bytes.size());
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  foredraw::bench::Wanted wanted;
  for (const std::string_view word : std::span(argv + 1, argv + argc)) {
    if (foredraw::bench::read_argument(word, wanted)) continue;
    std::cerr << argv[0] << ": '" << word
              << "' is unknown or out of range; use --output=FILE.glb, --kit=city|space, --instances=1..4000000, "
                 "--seed=N, --mirrored=0..1, --gpu-instancing\n";
    return 1;
  }
  if (wanted.output.empty()) {
    std::cerr << argv[0] << ": no output file; --output=FILE.glb sets it\n";
    return 1;
  }
  try {
    foredraw::bench::write(wanted);
  } catch (const std::exception& problem) {
    std::cerr << argv[0] << ": " << problem.what() << '\n';
    return 2;
  }
}
