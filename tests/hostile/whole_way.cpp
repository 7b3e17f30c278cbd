#include "whole_way.h"

#include <foredraw/analysis/certificate.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

namespace foredraw::testing {

namespace {

Registry built_in_plugins() {
  Registry registry;
  add_built_in_plugins(registry);
  return registry;
}

ProductRows products() {
  static const ProductRows rows = built_in_plugins().products();
  return rows;
}

void expect_clear_lines(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.all()) {
    EXPECT_EQ(d.where.file, "file");
    EXPECT_EQ(d.message.find('\n'), std::string::npos) << d.message;
    EXPECT_LT(to_text(d).size(), 1000u) << to_text(d).substr(0, 1000);
    const bool whole_file =
        d.code == "not-gltf" || d.code.compare(0, 5, "json-") == 0 || d.code.compare(0, 5, "more-") == 0;
    EXPECT_TRUE(!d.where.inside.empty() || d.where.line > 0 || whole_file) << to_text(d);
  }
}

void expect_optimised_and_written(const Scene& scene) {
  static const Registry registry = built_in_plugins();
  static const Executor executor(1);
  Diagnostics diagnostics;
  const auto pipeline = parse_line("weld, tipsify, linear-clusters, dot-rule(check=false), vertex-fetch", diagnostics);
  const auto plan = foredraw::plan(*pipeline, registry, scene, diagnostics);
  ASSERT_TRUE(plan) << to_text(diagnostics);
  Analyses analyses;
  const Result result = optimize(*plan, scene, {executor, analyses});
  EXPECT_FALSE(result.failed) << to_text(result.report);
  const auto files = encode_gltf(result.scene, "out.glb", diagnostics, {.products = products()});
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "out.glb", {}, diagnostics, {.products = products()});
  ASSERT_TRUE(again) << to_text(diagnostics);
  ASSERT_EQ(again->draws.size(), scene.draws.size());
  for (std::size_t i = 0; i < scene.draws.size(); ++i) {
    if (scene.draws[i].topology != Topology::triangles) continue;
    EXPECT_EQ(certificates_of(again->draws[i], analyses), certificates_of(scene.draws[i], analyses));
  }
}

}  // namespace

std::vector<std::string> go_the_whole_way(std::span<const std::byte> bytes, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "file", folder, diagnostics, {.products = products()});
  EXPECT_EQ(scene.has_value(), !diagnostics.has_errors()) << to_text(diagnostics);
  expect_clear_lines(diagnostics);
  if (scene) expect_optimised_and_written(*scene);
  std::vector<std::string> codes;
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity == Severity::error) codes.push_back(d.code);
  }
  return codes;
}

}  // namespace foredraw::testing
