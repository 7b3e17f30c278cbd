// The bytes are an odd mesh, and the options of the stages: whatever is ordered, the same is drawn, also when it has
// been written and read again.

#include "odd_input.h"
#include "round_trip.h"
#include "support/gltf_builder.h"

#include <cstring>

namespace foredraw {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;
using testing::OddInput;

std::size_t add_floats(GltfBuilder& builder, OddInput& input, std::size_t vertices, const char* type,
                       std::size_t components) {
  std::vector<float> values(vertices * components);
  for (float& value : values) value = input.number();
  return builder.add_values(values, type);
}

GltfJson add_indices(GltfBuilder& builder, OddInput& input, std::size_t vertices, std::size_t count) {
  const std::vector<std::uint32_t> indices = testing::odd_indices(input, vertices, count);
  switch (input.below(3)) {
    case 0: return builder.add_values(std::vector<std::uint8_t>(indices.begin(), indices.end()), "SCALAR");
    case 1: return builder.add_values(std::vector<std::uint16_t>(indices.begin(), indices.end()), "SCALAR");
    default: return builder.add_values(indices, "SCALAR");
  }
}

std::vector<std::byte> mesh_of(OddInput& input) {
  GltfBuilder builder;
  const std::size_t vertices = 1 + input.below(200);
  GltfJson streams = {{"POSITION", add_floats(builder, input, vertices, "VEC3", 3)}};
  if (input.below(2) != 0) streams["NORMAL"] = add_floats(builder, input, vertices, "VEC3", 3);
  if (input.below(2) != 0) streams["_OWN"] = add_floats(builder, input, vertices, "VEC2", 2);
  const std::size_t targets = input.below(3);
  GltfJson morphs = GltfJson::array();
  for (std::size_t t = 0; t < targets; ++t)
    morphs.push_back({{"POSITION", add_floats(builder, input, vertices, "VEC3", 3)}});
  const std::size_t primitives = 1 + input.below(3);
  builder.add("materials", {{"alphaMode", input.below(4) == 0 ? "BLEND" : "OPAQUE"}});
  builder.add("meshes", {{"primitives", GltfJson::array()}});
  for (std::size_t p = 0; p < primitives; ++p) {
    static constexpr int modes[] = {4, 4, 4, 4, 5, 6, 1, 0};
    GltfJson primitive = {{"attributes", streams}, {"mode", modes[input.below(8)]}, {"material", 0}};
    if (!morphs.empty()) primitive["targets"] = morphs;
    if (input.below(8) != 0) primitive["indices"] = add_indices(builder, input, vertices, 3 + input.below(250));
    builder.json["meshes"][0]["primitives"].push_back(primitive);
  }
  builder.add("nodes", {{"mesh", 0}});
  return builder.glb();
}

std::string line_of(OddInput& input) {
  std::string line = input.below(2) != 0 ? "weld(keep-unused=true)" : "weld";
  static constexpr const char* targets[] = {"robust", "fifo", "nvidia", "amd", "intel"};
  const std::string cache_size = "cache-size=" + std::to_string(3 + input.below(60));
  if (input.below(2) != 0) {
    line += ", tipsify(" + cache_size + ")";
  } else {
    line += ", lookahead(candidates=" + std::to_string(input.below(6)) + ", depth=" + std::to_string(input.below(9)) +
            ", target=" + targets[input.below(5)] + ", " + cache_size + ")";
  }
  line += ", linear-clusters(growth=1." + std::to_string(input.below(10)) + "), dot-rule(check=false)";
  if (input.below(2) != 0) line += ", vertex-fetch";
  if (input.below(4) == 0) line += ", tipsify, weld";
  return line;
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  OddInput input(data, size);
  const std::string line = line_of(input);
  Diagnostics diagnostics;
  const auto scene = read_gltf(mesh_of(input), "input", {}, diagnostics);
  if (scene) make_round_trip(*scene, line);  // else an index of all ones, or no whole triangle
  return 0;
}
