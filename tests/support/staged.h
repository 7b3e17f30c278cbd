#pragma once
// Stages on a scene, with the built-in plugins.

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <stdexcept>

namespace foredraw::testing {

/// Stages on one line.
inline Result run(const std::string& stages, const Scene& scene) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto plan = foredraw::plan(*parse_line(stages, diagnostics), registry, scene, diagnostics);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(2);
  Analyses analyses;
  return optimize(*plan, scene, {executor, analyses});
}

}  // namespace foredraw::testing
