// Reading and writing models without images (which the peer would decode) against tinygltf's own load and save, from
// memory to memory, one thread. Ours checks all that a file claims, and writes a scene whose every draw got a new
// triangle order.

#include "ratio_table.h"
#include "support/meshes.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/scene/reorder.h>

#include <tiny_gltf.h>

#include <fmt/format.h>

#include <numeric>
#include <sstream>
#include <stdexcept>

namespace foredraw::bench {
namespace {

/// What the work costs at the least: the file's bytes are read once and written once.
struct Model {
  std::string name;
  std::vector<std::byte> bytes;
  Scene changed;
  std::size_t triangles = 0;
};

Model load(const std::string& name) {
  Diagnostics diagnostics;
  Model model{.name = name, .bytes = *read_file(testing::project_file("benchmarks/corpus/" + name), diagnostics)};
  model.changed = *read_gltf(model.bytes, name, {}, diagnostics);
  for (Draw& draw : model.changed.draws) {
    if (!draw.traits.has(traits::triangles)) continue;
    IndexOrder backwards(draw.levels[0].orders[0].indices.view().size() / 3);
    std::iota(backwards.rbegin(), backwards.rend(), 0u);
    draw = with_triangle_order(draw, backwards);
    model.triangles += backwards.size();
  }
  return model;
}

void ours(const Model& model) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(model.bytes, model.name, {}, diagnostics);
  const auto files = encode_gltf(model.changed, "out.glb", diagnostics);
  if (!scene || !files) throw std::runtime_error(to_text(diagnostics));
  benchmark::DoNotOptimize(files->front().bytes.data());
}

void peer(const Model& model) {
  tinygltf::TinyGLTF gltf;
  tinygltf::Model loaded;
  std::string problem;
  std::string warning;
  const auto* data = reinterpret_cast<const unsigned char*>(model.bytes.data());
  std::ostringstream out;
  if (!gltf.LoadBinaryFromMemory(&loaded, &problem, &warning, data, static_cast<unsigned>(model.bytes.size())) ||
      !gltf.WriteGltfSceneToStream(&loaded, out, false, true)) {
    throw std::runtime_error(problem);
  }
  benchmark::DoNotOptimize(out.str().size());
}

}  // namespace

void add_file_contests(RatioTable& table) {
  for (const char* name :
       {"static/chess_board_notex.glb", "static/flight_helmet_notex.glb", "static/dutch_ship_medium_notex.glb"}) {
    const auto model = std::make_shared<Model>(load(name));
    for (const auto& [side, work] : {std::pair{"ours", &ours}, std::pair{"peer", &peer}}) {
      const std::string run = fmt::format("reading and writing against tinygltf's load and save|{}|{}", name, side);
      table.expect(run);
      benchmark::RegisterBenchmark(run.c_str(), [model, work = work](benchmark::State& state) {
        for (auto _ : state) work(*model);
        state.counters["triangles"] = static_cast<double>(model->triangles);
      });
    }
  }
}

}  // namespace foredraw::bench
