// Whatever scene the reader lets in, our own stages run on it without failing, and draw what was drawn before; so does
// what is written of it.

#include "gltf_mutator.h"
#include "round_trip.h"
#include "support/products.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  static const ProductRows rows = testing::built_in_products();
  Diagnostics diagnostics;
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "input", {}, diagnostics, {.products = rows});
  if (scene) make_round_trip(*scene, "weld, tipsify, linear-clusters, dot-rule(check=false), vertex-fetch");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return foredraw::mutate_gltf(data, size, most, seed);
}
