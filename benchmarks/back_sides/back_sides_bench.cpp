// How many pixels pipelines with `sides` change, and what they take: seconds of the processor, triangles, draws.
//
//   back-sides-bench [--pictures=300] [--size=1024] [--seed=20261123] PIPELINE... MODEL.glb...

#include "support/same_look.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {
namespace {

std::size_t triangles(const Scene& scene) {
  std::size_t sum = 0;
  for (const Draw& draw : scene.draws) sum += draw.full().stream().triangle_count();
  return sum;
}

void contest(const std::string& line, const std::string& model, const testing::LookOptions& options,
             const Executor& executor) {
  Diagnostics diagnostics;
  const auto before = read_gltf(model, diagnostics);
  Registry registry;
  add_built_in_plugins(registry);
  auto pipeline = load_pipeline(line, diagnostics);
  if (pipeline) pipeline->measure.clear();
  const auto plan = pipeline && before ? foredraw::plan(*pipeline, registry, *before, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  Analyses analyses(image_decoder({}));
  const std::clock_t begin = std::clock();
  const Result result = optimize(*plan, *before, {executor, analyses});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const testing::Looks looks = testing::compared(*before, result.scene, options, executor);
  const std::size_t was = triangles(*before), is = triangles(result.scene);
  fmt::print(
      "{:<28} {:<36} {:6.2f} s  {:+7.2f} % triangles  {} draws  of {:.1f} million pixels {} lost, {} moved = "
      "{:.3f} of a million; {} of another colour\n",
      line, model.substr(model.rfind('/') + 1), seconds, 100 * (static_cast<double>(is) / static_cast<double>(was) - 1),
      result.scene.draws.size(), 1e-6 * static_cast<double>(looks.shown), looks.lost, looks.moved, looks.wrong(),
      looks.coloured);
  std::fflush(stdout);
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** arguments) {
  using namespace foredraw;
  testing::LookOptions options;
  std::vector<std::string> lines, models;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto value = [&] { return word.substr(word.find('=') + 1); };
    if (word.starts_with("--pictures="))
      options.pictures = std::stoi(value());
    else if (word.starts_with("--size="))
      options.size = std::stoi(value());
    else if (word.starts_with("--seed="))
      options.seed = std::stoull(value());
    else
      (word.ends_with(".glb") ? models : lines).push_back(word);
  }
  const Executor executor;
  for (const std::string& model : models) {
    for (const std::string& line : lines) bench::contest(line, model, options, executor);
  }
}
