#pragma once
// Any plugin of the registry, run on odd draws. The runner checks each answer (permutation, partition, certificate) and
// reports a failure where it is none, so a run that did not fail is a run with right answers.

#include <foredraw/pipeline/runner.h>

#include <gtest/gtest.h>

#include <string>

namespace foredraw::testing {

/// All plugins that have to conform.
const Registry& registry();

/// A pipeline with the plugin as its last stage, behind whatever provides what it needs.
Pipeline pipeline_for(const Plugin& plugin, const Settings& settings);

struct Outcome {
  Result result;
  Plan plan;
};

/// On odd_scene(). What is measured for orders, is so in few small pictures. Throws std::runtime_error where the
/// pipeline cannot be planned.
Outcome run(Pipeline pipeline, int threads);

/// Everything that was said, a line each.
std::string problems(const Result& result);

/// A plugin's name as tests are called.
std::string test_name(const ::testing::TestParamInfo<std::string>& info);

/// Its tests lie in several files, each of which asks one thing of every plugin.
class EveryPlugin : public ::testing::TestWithParam<std::string> {
 protected:
  const Plugin& plugin() const { return *registry().find(GetParam()); }
};

}  // namespace foredraw::testing
