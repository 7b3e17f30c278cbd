// Whatever scene the reader lets in, our own stages run on it without failing, and draw what was drawn before; so does
// what is written of it.

#include "claim.h"
#include "gltf_mutator.h"

#include <foredraw/analysis/certificate.h>
#include <foredraw/io/gltf.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw {
namespace {

Registry built_in_plugins() {
  Registry registry;
  add_built_in_plugins(registry);
  return registry;
}

std::vector<std::vector<Certificate>> certificates(const Scene& scene) {
  Analyses analyses;
  std::vector<std::vector<Certificate>> all;
  for (const Draw& draw : scene.draws) {
    if (draw.topology == Topology::triangles) all.push_back(certificates_of(draw, analyses));
  }
  return all;
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  static const Registry registry = built_in_plugins();
  static const Executor executor(1);
  Diagnostics diagnostics;
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "input", {}, diagnostics);
  if (!scene) return 0;

  const auto pipeline = parse_line("weld, tipsify, linear-clusters, dot-rule(check=false), vertex-fetch", diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, *scene, diagnostics);
  claim(plan.has_value(), "can not be planned: " + to_text(diagnostics));
  Analyses analyses;
  const Result result = optimize(*plan, *scene, {executor, analyses});
  claim(!result.failed, "a stage failed:\n" + to_text(result.report));
  claim(certificates(result.scene) == certificates(*scene), "something else is drawn");
  const auto files = encode_gltf(result.scene, "again.glb", diagnostics);
  claim(files && files->size() == 1, "what was optimised can not be written: " + to_text(diagnostics));
  const auto again = read_gltf(files->front().bytes, "again.glb", {}, diagnostics);
  claim(again.has_value(), "what was written can not be read: " + to_text(diagnostics));
  claim(certificates(*again) == certificates(*scene), "something else was written");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return foredraw::mutate_gltf(data, size, most, seed);
}
