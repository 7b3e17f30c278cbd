// A buffer of Draco's in a sound glTF: whatever it holds is refused, or read, written plain and by Draco and read
// again. The first byte says what the glTF claims to be in it.

#include "claim.h"
#include "support/gltf_builder.h"

#include <foredraw/io/gltf/gltf.h>

namespace {

using foredraw::testing::GltfBuilder;
using foredraw::testing::GltfJson;

GltfBuilder around(std::span<const std::byte> buffer, unsigned claim) {
  GltfBuilder builder;
  GltfJson attributes, ids;
  const auto add = [&](const char* semantic, unsigned id, int component, const char* type) {
    attributes[semantic] = builder.add("accessors", {{"componentType", component}, {"count", 2000}, {"type", type}});
    ids[semantic] = id;
  };
  if ((claim & 1u) != 0) add("POSITION", claim >> 4 & 1u, 5126, "VEC3");
  if ((claim & 2u) != 0) add("TEXCOORD_0", claim >> 5 & 1u, 5126, "VEC2");
  if ((claim & 4u) != 0) add("COLOR_0", claim >> 6 & 1u, 5121, "VEC4");
  if ((claim & 7u) == 0) add("_ID", claim >> 7 & 1u, 5123, "SCALAR");
  const std::size_t indices = builder.add("accessors", {{"componentType", 5123}, {"count", 12000}, {"type", "SCALAR"}});
  GltfJson primitive{{"attributes", attributes}, {"indices", indices}};
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", builder.add_view(buffer)},
                                                           {"attributes", ids}};
  if ((claim & 8u) != 0) primitive["mode"] = 5;
  builder.add_mesh(primitive);
  return builder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  if (size < 2) return 0;
  const auto bytes = std::as_bytes(std::span(data, size));
  Diagnostics diagnostics;
  const auto scene = read_gltf(around(bytes.subspan(1), data[0]).glb(), "input", {}, diagnostics);
  claim(scene.has_value() != diagnostics.has_errors(), "read and not read at once: " + to_text(diagnostics));
  if (!scene) return 0;
  for (const Compression how : {Compression::none, Compression::draco, Compression::draco_edgebreaker}) {
    const auto files = encode_gltf(*scene, "again.glb", diagnostics, {.compression = how});
    claim(files && files->size() == 1, "what was read can not be written: " + to_text(diagnostics));
    const auto again = read_gltf(files->front().bytes, "again.glb", {}, diagnostics);
    claim(again.has_value(), "what was written can not be read: " + to_text(diagnostics));
    if (how == Compression::draco_edgebreaker) continue;  // which sorts as it likes
    const Level& was = scene->draws.at(0).levels[0];
    const Level& is = again->draws.at(0).levels[0];
    claim(is.vertices->stamp() == was.vertices->stamp(), "other vertices");
    claim(is.orders[0].indices == was.orders[0].indices, "other triangles");
  }
  return 0;
}
