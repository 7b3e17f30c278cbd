#pragma once
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>
#include <peers.h>

#include <stdexcept>

namespace foredraw::testing {

inline Scene read_model(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  auto scene = read_gltf(path, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  return std::move(*scene);
}

/// Runs a pipeline (a line or a preset) on a scene, with our plugins and the peers' to choose from.
inline Result run_pipeline(const std::string& text, const Scene& scene, int threads, const std::string& measure = "") {
  Registry registry;
  add_built_in_plugins(registry);
  add_peers(registry);
  Diagnostics diagnostics;
  auto pipeline = load_pipeline(text, diagnostics);
  if (pipeline && !measure.empty()) pipeline->measure = *parse_stages(measure, "measure", diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(threads);
  Analyses analyses(image_decoder({}));
  return foredraw::optimize(*plan, scene, {executor, analyses});
}

}  // namespace foredraw::testing
