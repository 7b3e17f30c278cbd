#pragma once
// Small plugins, run as stages and evaluators of a pipeline on one line.

#include "support/meshes.h"
#include "support/test_plugins.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::testing {

class RunsStages : public ::testing::Test {
 protected:
  RunsStages() { add_test_plugins(registry_); }

  Plan planned(const std::string& stages, const Scene& scene, const std::string& measure = "") const {
    Diagnostics diagnostics;
    std::optional<Pipeline> pipeline = parse_line(stages, diagnostics);
    if (pipeline && !measure.empty()) pipeline->measure = *parse_stages(measure, "measure", diagnostics);
    std::optional<Plan> plan = pipeline ? foredraw::plan(*pipeline, registry_, scene, diagnostics) : std::nullopt;
    if (!plan) throw std::runtime_error(to_text(diagnostics));
    return std::move(*plan);
  }

  Result run(const std::string& stages, const Scene& scene, const std::string& measure = "",
             const Executor& executor = Executor(2)) const {
    Analyses analyses;
    return optimize(planned(stages, scene, measure), scene, {executor, analyses});
  }

  static std::vector<std::uint32_t> indices(const Scene& scene, DrawId id, std::size_t order = 0) {
    const auto view = scene.draws[id].levels[0].orders[order].indices.view();
    return {view.begin(), view.end()};
  }

  Registry registry_;
  /// A has four triangles, and B two.
  Scene two_ = scene_of({draw_of(grid(2, 1), "A"), draw_of(grid(1, 1), "B")});
};

}  // namespace foredraw::testing
