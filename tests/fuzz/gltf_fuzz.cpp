// Whatever the bytes, reading them ends well; what can be read can be written, and what was written can be read.

#include "claim.h"
#include "gltf_mutator.h"
#include "support/products.h"

#include <foredraw/io/gltf/gltf.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  static const ProductRows rows = testing::built_in_products();
  Diagnostics diagnostics;
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "input", {}, diagnostics, {.products = rows});
  claim(scene.has_value() != diagnostics.has_errors(), "read and not read at once: " + to_text(diagnostics));
  if (!scene) return 0;

  const auto files = encode_gltf(*scene, "again.glb", diagnostics);
  claim(files && files->size() == 1, "what was read can not be written: " + to_text(diagnostics));
  const auto again = read_gltf(files->front().bytes, "again.glb", {}, diagnostics, {.products = rows});
  claim(again.has_value(), "what was written can not be read: " + to_text(diagnostics));
  claim(again->draws.size() == scene->draws.size(), "draws were lost");
  for (const auto& row : rows) {
    const std::string name = row->card().name;
    claim(again->products.same(name, scene->products), name + " were lost");
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return foredraw::mutate_gltf(data, size, most, seed);
}
