// OBJ, PLY, OFF or STL, by the first byte. Whatever the others, reading them ends well; what can be read comes out byte
// for byte where nothing moved, draws the same where all was turned round and written, and can be written as glTF.

#include "claim.h"
#include "support/mesh_reading.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/scene_file.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  if (size == 0) return 0;
  const auto kind = static_cast<MeshKind>(data[0] % 4);
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  auto [scene, diagnostics] = testing::read_mesh(kind, text);
  claim(scene.has_value() != diagnostics.has_errors(), "read and not read at once: " + to_text(diagnostics));
  if (!scene) return 0;

  const std::string name = "again" + std::string(extension_of(kind));
  const auto as_it_was = encode_mesh_file(*scene, kind, name, diagnostics);
  claim(as_it_was && testing::text_of(*as_it_was) == text, "the file changed though nothing moved");

  const Scene turned = testing::reversed(*scene);
  Diagnostics refusals;
  if (const auto file = encode_mesh_file(turned, kind, name, refusals)) {
    const auto again = testing::read_mesh(kind, testing::text_of(*file));
    claim(again.scene.has_value(), "what was written can not be read: " + to_text(again.diagnostics));
    claim(testing::drawn(*again.scene) == testing::drawn(*scene), "something else is drawn");
  } else {
    claim(refusals.has_errors(), "not written, and nobody says why");
  }

  const auto files = encode_scene(turned, "again.glb", diagnostics);
  claim(files && files->size() == 1, "can not be written as glTF: " + to_text(diagnostics));
  const auto again = read_gltf(files->front().bytes, "again.glb", {}, diagnostics);
  claim(again.has_value(), "what was written as glTF can not be read: " + to_text(diagnostics));
  claim(testing::drawn(*again).size() == testing::drawn(*scene).size(), "triangles were lost");
  return 0;
}
