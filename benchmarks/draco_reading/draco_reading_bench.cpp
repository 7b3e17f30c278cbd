// Files compressed by Draco: whether they are read as libdraco alone decodes them, to the last bit, and how much longer
// reading takes, one thread each. Every round does both, so that a noisy moment hits both; the median of seven counts.
//   draco-reading-bench FILES.glb

#include "support/draco_gltf.h"

#include <benchmarks/timing.h>

#include <foredraw/io/scene_file.h>
#include <foredraw/platform/files.h>

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <cstring>
#include <optional>
#include <stdexcept>

namespace foredraw::bench {
namespace {

using testing::GltfJson;
using Bytes = std::vector<std::byte>;

/// A primitive's buffer, and which attribute is which.
struct Coded {
  std::span<const std::byte> buffer;
  GltfJson ids;
};

/// Of a GLB with one buffer.
std::vector<Coded> coded_in(const Bytes& file) {
  const GltfJson json = testing::json_of(file);
  std::uint32_t text = 0;
  std::memcpy(&text, file.data() + 12, 4);
  const std::span<const std::byte> bin = std::span(file).subspan(28 + text);
  std::vector<Coded> found;
  for (const GltfJson& mesh : json["meshes"]) {
    for (const GltfJson& primitive : mesh["primitives"]) {
      const GltfJson& told = primitive["extensions"]["KHR_draco_mesh_compression"];
      const GltfJson& view = json["bufferViews"][told["bufferView"].get<std::size_t>()];
      const auto bytes = bin.subspan(view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
      found.push_back({bytes, told["attributes"]});
    }
  }
  return found;
}

void decode(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!draco::Decoder().DecodeMeshFromBuffer(&buffer).ok()) throw std::runtime_error("libdraco does not decode it");
}

std::size_t differences(const Scene& scene, const std::vector<Coded>& all) {
  std::size_t count = 0;
  for (std::size_t d = 0; d < all.size(); ++d) {
    const auto want = testing::decoded_by_draco(all[d].buffer);
    const Level& level = scene.draws[d].levels[0];
    count += !std::ranges::equal(level.orders[0].indices.view(), want.indices);
    for (const auto& [semantic, id] : all[d].ids.items()) {
      const VertexStream* stream = level.vertices->find(semantic);
      count += stream == nullptr || !std::ranges::equal(stream->bytes.view(), want.attributes.at(id));
    }
  }
  return count;
}

void measure(const std::string& path) {
  Diagnostics diagnostics;
  const auto file = read_file(path, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  const std::vector<Coded> all = coded_in(*file);
  std::optional<Scene> scene;
  const auto read = [&] { scene = read_gltf(*file, path, {}, diagnostics); };
  const auto alone = [&] {
    for (const Coded& coded : all) decode(coded.buffer);
  };
  std::vector<double> ours, theirs, ratios;
  for (int round = 0; round < 7; ++round) {
    theirs.push_back(1000 * seconds_of(alone));
    ours.push_back(1000 * seconds_of(read));
    ratios.push_back(ours.back() / theirs.back());
  }
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  std::size_t triangles = 0;
  for (const Draw& draw : scene->draws) triangles += draw.levels[0].orders[0].triangle_count();
  fmt::print("{}: {} primitives, {} triangles, {} differ; libdraco {:.2f} ms, read {:.2f} ms, ratio {:.3f}\n", path,
             all.size(), triangles, differences(*scene, all), median(theirs), median(ours), median(ratios));
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) foredraw::bench::measure(argv[i]);
  return 0;
}
