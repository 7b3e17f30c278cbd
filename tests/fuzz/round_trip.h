#pragma once
// A scene optimised, written and read again, with the certificate as oracle.

#include "claim.h"

#include <foredraw/analysis/certificate.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw {

inline std::vector<std::vector<Certificate>> certificates(const Scene& scene) {
  Analyses analyses;
  std::vector<std::vector<Certificate>> all;
  for (const Draw& draw : scene.draws) {
    if (draw.topology == Topology::triangles) all.push_back(certificates_of(draw, analyses));
  }
  return all;
}

/// Claims that the stages of the line run without failing, and that they and the writer draw what was drawn before.
inline void make_round_trip(const Scene& scene, const std::string& line) {
  static const Registry registry = [] {
    Registry all;
    add_built_in_plugins(all);
    return all;
  }();
  static const Executor executor(1);
  Diagnostics diagnostics;
  const auto pipeline = parse_line(line, diagnostics);
  claim(pipeline.has_value(), line + " does not parse: " + to_text(diagnostics));
  const auto plan = foredraw::plan(*pipeline, registry, scene, diagnostics);
  claim(plan.has_value(), line + " can not be planned: " + to_text(diagnostics));
  Analyses analyses;
  const Result result = optimize(*plan, scene, {executor, analyses});
  claim(!result.failed, line + ": a stage failed:\n" + to_text(result.report) + to_text(diagnostics));
  claim(certificates(result.scene) == certificates(scene), line + ": something else is drawn");
  const auto files = encode_gltf(result.scene, "again.glb", diagnostics);
  claim(files && files->size() == 1, line + ": what was optimised can not be written: " + to_text(diagnostics));
  const auto again = read_gltf(files->front().bytes, "again.glb", {}, diagnostics);
  claim(again.has_value(), line + ": what was written can not be read: " + to_text(diagnostics));
  claim(certificates(*again) == certificates(scene), line + ": something else was written");
}

}  // namespace foredraw
