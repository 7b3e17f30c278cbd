// Writes small files for the fuzz targets to begin with: make_seeds FOLDER makes FOLDER/gltf_fuzz/puppet.glb and
// others.

#include "support/draco_gltf.h"
#include "support/gltf_builder.h"
#include "support/image_builder.h"
#include "support/merged_scenes.h"

#include <foredraw/io/meshopt/vertex_codec.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace foredraw;

void write(const fs::path& path, const std::vector<std::byte>& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::vector<std::byte> text(const std::string& line) { return testing::bytes_of(line); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  const fs::path folder = argv[1];
  for (const char* target : {"gltf_fuzz", "optimize_fuzz"}) {
    write(folder / target / "ribbon.glb", testing::ribbon(6).glb());
    write(folder / target / "puppet.glb", testing::puppet().glb());
    testing::GltfBuilder shared = testing::ribbon(4);
    for (const int mode : {5, 6, 1, 4}) {
      testing::GltfJson primitive = shared.json["meshes"][0]["primitives"][0];
      primitive["mode"] = mode;
      shared.json["meshes"][0]["primitives"].push_back(primitive);
    }
    write(folder / target / "shared.glb", shared.glb());
    const testing::MergeByHand how{.frequencies = {6, 3}, .materials = true};
    write(folder / target / "merged.glb", testing::write(testing::merged_yard(testing::read(testing::yard()), how)));
  }
  write(folder / "gltf_fuzz" / "puppet.gltf", testing::puppet().gltf());
  write(folder / "gltf_fuzz" / "draco.glb", testing::draco_compressed(testing::puppet(), {.sequential = true}).glb());
  for (const bool sequential : {false, true}) {
    for (const int bits : {0, 11}) {
      for (const int speed : {0, 5, 10}) {
        const testing::GltfBuilder coded = testing::draco_compressed(testing::ribbon(9), {sequential, bits, speed});
        const auto& told = coded.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
        const auto buffer = testing::view_bytes(coded, told["bufferView"]);
        std::vector<std::byte> seed{std::byte{1}};  // claims positions of floats
        seed.insert(seed.end(), buffer.begin(), buffer.end());
        write(folder / "draco_fuzz" / fmt::format("{}_{}_{}", sequential, bits, speed), seed);
      }
    }
  }

  const ImageFacts eight{9, 7, 3, 8}, sixteen{9, 7, 4, 16}, halves{9, 7, 3, 16, true};
  const std::vector<std::uint16_t> values(9 * 7 * 4, 77);
  const std::vector<float> floats(9 * 7 * 3, 0.25f);
  write(folder / "image_fuzz" / "8.png", testing::png_of(eight, {values.begin(), values.begin() + 189}));
  write(folder / "image_fuzz" / "16.png", testing::png_of(sixteen, values));
  write(folder / "image_fuzz" / "a.jpg", testing::jpeg_of(eight, values));
  write(folder / "image_fuzz" / "a.tga", testing::tga_of(eight, values));
  for (const char* compression : {"none", "rle", "zip", "zips", "piz"}) {
    write(folder / "image_fuzz" / (std::string(compression) + ".exr"), testing::exr_of(halves, floats, compression));
  }

  for (const std::size_t stride : {4u, 12u, 20u}) {
    std::vector<std::byte> elements(40 * stride);
    for (std::size_t i = 0; i < elements.size(); ++i) elements[i] = static_cast<std::byte>(i * i / 7);
    for (const auto version : {meshopt::VertexVersion::v0, meshopt::VertexVersion::v1}) {
      std::vector<std::byte> input{static_cast<std::byte>(stride / 4 - 1), std::byte{40}, std::byte{0}};
      const auto stream = meshopt::encode_vertices(elements, stride, version);
      input.insert(input.end(), stream.begin(), stream.end());
      write(folder / "vertex_codec_fuzz" /
                (std::to_string(stride) + "_" + std::to_string(input[3] == std::byte{0xa0} ? 0 : 1)),
            input);
    }
  }

  write(folder / "pipeline_fuzz" / "line",
        text("weld, tipsify(cache-size=16), linear-clusters(growth=1.05), dot-rule, vertex-fetch"));
  write(folder / "pipeline_fuzz" / "file",
        text("pipeline = 1\nstages = [\n  \"weld\",\n  { use = \"tipsify\", cache-size = 16, only = \"Rock_*\" },\n]\n"
             "[views]\nviews = \"icosphere\"\ncount = 162\n"));
  std::vector<std::byte> waves;
  for (int i = 0; i < 1200; ++i) waves.push_back(static_cast<std::byte>(120 * (1 + std::sin(i * 0.7))));
  write(folder / "orders_fuzz" / "waves", waves);
  return 0;
}
