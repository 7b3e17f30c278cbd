// Techniques of the caller's own, in pipelines beside the others.

#include "handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <list>
#include <numeric>
#include <vector>

namespace foredraw::testing::own_plugins_test {
namespace {

const std::string spot = FOREDRAW_SOURCE_DIR "/benchmarks/corpus/static/spot.glb";

foredraw_plugin orderer(const char* name, decltype(foredraw_plugin::run) run) {
  return {.size = sizeof(foredraw_plugin),
          .kind = FOREDRAW_TRIANGLE_ORDERER,
          .name = name,
          .summary = "Orders triangles for a test",
          .reference = "own",
          .run = run};
}

/// By falling distance from the origin to some power: what is outside comes first.
int radial(void*, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
           const foredraw_host*) {
  std::vector<double> distances(draw->triangle_count);
  for (std::size_t t = 0; t < distances.size(); ++t) {
    double sum = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const float* p = draw->positions + 3 * draw->indices[3 * t + corner];
      sum += std::sqrt(double{p[0]} * p[0] + double{p[1]} * p[1] + double{p[2]} * p[2]);
    }
    distances[t] = std::pow(sum, options[0].number);
  }
  std::iota(answer->values, answer->values + answer->count, 0u);
  std::stable_sort(answer->values, answer->values + answer->count,
                   [&](std::uint32_t a, std::uint32_t b) { return distances[a] > distances[b]; });
  return FOREDRAW_DONE;
}

class OwnPlugins : public ::testing::Test {
 protected:
  OwnPlugins() {
    foredraw_scene* scene = nullptr;
    EXPECT_EQ(foredraw_read(context_.get(), spot.c_str(), &scene, nullptr), FOREDRAW_DONE);
    scene_.reset(scene);
  }

  /// Which lives as long as the context.
  void add(const foredraw_plugin& plugin) {
    kept_.push_back(plugin);
    ASSERT_EQ(foredraw_add_plugin(context_.get(), &kept_.back(), nullptr), FOREDRAW_DONE);
  }

  /// The report of a run, and what came of it.
  Json optimized(const std::string& pipeline, int status = FOREDRAW_DONE) {
    Told report;
    foredraw_scene* made = nullptr;
    EXPECT_EQ(foredraw_optimize(context_.get(), scene_.get(), pipeline.c_str(), &made, report.out()), status);
    made_.reset(made);
    return report.json();
  }

  /// How the stage failed.
  std::string failure(decltype(foredraw_plugin::run) run) {
    const Context apart(foredraw_context_new(nullptr));
    const foredraw_plugin bad = orderer("bad", run);
    EXPECT_EQ(foredraw_add_plugin(apart.get(), &bad, nullptr), FOREDRAW_DONE);
    Told report;
    EXPECT_EQ(foredraw_optimize(apart.get(), scene_.get(), "bad", nullptr, report.out()), FOREDRAW_FAILED);
    return report.json().at("diagnostics").at(0).at("message");
  }

  std::list<foredraw_plugin> kept_;
  const Context context_{foredraw_context_new(nullptr)};
  SceneHandle scene_, made_;
};

TEST_F(OwnPlugins, AnOrdererRunsBesideTheOthers) {
  const foredraw_option power{.name = "power",
                              .doc = "Of the distance",
                              .type = FOREDRAW_NUMBER,
                              .initial = {.number = 1},
                              .least = .1,
                              .most = 4};
  foredraw_plugin plugin = orderer("my-radial", radial);
  plugin.options = &power, plugin.option_count = 1, plugin.provides = "overdraw-ordered",
  plugin.breaks = "cache-ordered";
  add(plugin);
  const Json report = optimized("weld, tipsify, my-radial(power=2), vertex-fetch");
  EXPECT_EQ(report.at("stages").at(2).at("changed"), 1);
  foredraw_draw draw{.size = sizeof draw};
  ASSERT_EQ(foredraw_scene_draw(made_.get(), 0, &draw), FOREDRAW_DONE);
  std::vector<std::uint32_t> order(draw.triangle_count), in_order(draw.triangle_count);
  std::iota(in_order.begin(), in_order.end(), 0u);
  foredraw_answer answer{order.data(), order.size()};
  const foredraw_value two{.number = 2};
  ASSERT_EQ(radial(nullptr, &draw, &two, &answer, nullptr), FOREDRAW_DONE);
  EXPECT_EQ(order, in_order) << "the scene is in the order that the technique makes";
  const Json wrong = optimized("my-radial(power=9)", FOREDRAW_MISTAKE);
  EXPECT_NE(wrong.at("diagnostics").at(0).at("message").get<std::string>().find("0.1 to 4"), std::string::npos);
  const Json near = optimized("my-radail", FOREDRAW_MISTAKE);
  EXPECT_NE(near.at("diagnostics").at(0).at("hint").get<std::string>().find("my-radial"), std::string::npos);
}

TEST_F(OwnPlugins, WhatIsWrongIsRefusedAndTheDrawStays) {
  using Draw = const foredraw_draw*;
  using Values = const foredraw_value*;
  using Answer = foredraw_answer*;
  using Asked = const foredraw_host*;
  EXPECT_NE(failure([](void*, Draw, Values, Answer, Asked) -> int { return FOREDRAW_DONE; }).find("permutation"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer answer, Asked) -> int {
              std::fill_n(answer->values, answer->count, 0u);
              return FOREDRAW_DONE;
            }).find("permutation"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer answer, Asked) -> int {
              answer->count = 1;
              answer->values[0] = 0;
              return FOREDRAW_DONE;
            }).find("permutation"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer answer, Asked) -> int {
              ++answer->count;
              return FOREDRAW_DONE;
            }).find("there is room for 5856"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer, Asked) -> int { return 77; }).find("it returned 77"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer, Asked host) -> int {
              host->fail(host->self, "the moon is full\x1b[2J\xff");
              return FOREDRAW_DONE;
            }).find("the moon is full"),
            std::string::npos);
  EXPECT_NE(failure([](void*, Draw, Values, Answer, Asked host) -> int {
              host->measure(host->self, "mine", 1, 0, NAN);
              return FOREDRAW_DONE;
            }).find("not a finite number"),
            std::string::npos);
}

TEST_F(OwnPlugins, MayKeepWhatThereIs) {
  add(orderer("content",
              [](void*, const foredraw_draw*, const foredraw_value*, foredraw_answer*, const foredraw_host* host) {
                host->note(host->self, "seen", "it was looked at");
                host->keep(host->self, "it is good already");
                return static_cast<int>(FOREDRAW_DONE);
              }));
  const Json report = optimized("content");
  EXPECT_NE(report.dump().find("it is good already"), std::string::npos);
  EXPECT_NE(report.dump().find("it was looked at"), std::string::npos);
}

TEST_F(OwnPlugins, RoundingIsAsItWas) {
  add(orderer("upwards",
              [](void*, const foredraw_draw*, const foredraw_value*, foredraw_answer* answer, const foredraw_host*) {
                std::fesetround(FE_UPWARD);
                std::iota(answer->values, answer->values + answer->count, 0u);
                return static_cast<int>(FOREDRAW_DONE);
              }));
  optimized("upwards");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST_F(OwnPlugins, VertexOrderersClusterersAndEvaluatorsToo) {
  foredraw_plugin reverse = orderer("reverse", [](void*, const foredraw_draw* draw, const foredraw_value*,
                                                  foredraw_answer* answer, const foredraw_host*) {
    for (std::uint32_t i = 0; i < draw->vertex_count; ++i) answer->values[i] = draw->vertex_count - 1 - i;
    return static_cast<int>(FOREDRAW_DONE);
  });
  reverse.kind = FOREDRAW_VERTEX_ORDERER;
  foredraw_plugin pairs = orderer("pairs", [](void*, const foredraw_draw* draw, const foredraw_value*,
                                              foredraw_answer* answer, const foredraw_host*) {
    answer->count = 0;
    for (std::uint32_t t = 0; t < draw->triangle_count; t += 2) answer->values[answer->count++] = t;
    answer->values[answer->count++] = static_cast<std::uint32_t>(draw->triangle_count);
    return static_cast<int>(FOREDRAW_DONE);
  });
  pairs.kind = FOREDRAW_CLUSTERER, pairs.provides = "clustered";
  foredraw_plugin sizes = orderer("cluster-size", [](void*, const foredraw_draw* draw, const foredraw_value*,
                                                     foredraw_answer*, const foredraw_host* host) {
    host->measure(host->self, "mean", static_cast<double>(draw->triangle_count), std::max(draw->cluster_count, 1u), 0);
    host->count(host->self, "streams", draw->stream_count);
    return static_cast<int>(FOREDRAW_DONE);
  });
  const foredraw_metric metrics[] = {{"mean", "triangles", "Triangles of a cluster", 0},
                                     {"streams", "", "Besides positions", 0}};
  sizes.kind = FOREDRAW_EVALUATOR, sizes.metrics = metrics, sizes.metric_count = 2;
  for (const foredraw_plugin& plugin : {reverse, pairs, sizes}) add(plugin);
  const Json report = optimized("pipeline = 1\nstages = [\"reverse\", \"pairs\"]\nmeasure = [\"cluster-size\"]\n");
  const Json& figures = report.at("totals").at("metrics").at("cluster-size");
  EXPECT_EQ(figures.at("mean").at("value"), 2);
  EXPECT_GT(figures.at("streams").at("value"), 0);
  foredraw_draw before{.size = sizeof before}, after{.size = sizeof after};
  ASSERT_EQ(foredraw_scene_draw(scene_.get(), 0, &before), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_scene_draw(made_.get(), 0, &after), FOREDRAW_DONE);
  EXPECT_EQ(after.indices[0], before.vertex_count - 1 - before.indices[0]);
  EXPECT_EQ(after.cluster_count, before.triangle_count / 2);
}

TEST_F(OwnPlugins, OneAtATimeUnlessTheySayOtherwise) {
  static std::atomic<int> inside, most;
  add(orderer("alone",
              [](void*, const foredraw_draw*, const foredraw_value*, foredraw_answer* answer, const foredraw_host*) {
                most = std::max<int>(most, ++inside);
                std::iota(answer->values, answer->values + answer->count, 0u);
                --inside;
                return static_cast<int>(FOREDRAW_DONE);
              }));
  const std::string knight = FOREDRAW_SOURCE_DIR "/benchmarks/corpus/animated/kaykit_knight.glb";
  foredraw_scene* scene = nullptr;
  ASSERT_EQ(foredraw_read(context_.get(), knight.c_str(), &scene, nullptr), FOREDRAW_DONE);
  scene_.reset(scene);
  optimized("alone");
  EXPECT_EQ(most, 1);
}

TEST_F(OwnPlugins, WrongOnesAreNotAdded) {
  const foredraw_plugin good = orderer("good", radial);
  const auto problem = [&](const foredraw_plugin& plugin) {
    Told told;
    EXPECT_EQ(foredraw_add_plugin(context_.get(), &plugin, told.out()), FOREDRAW_MISTAKE);
    return told.json().at("diagnostics").at(0).at("message").get<std::string>();
  };
  foredraw_plugin bad = good;
  bad.size = 8;
  EXPECT_TRUE(problem(bad).starts_with("size is 8"));
  bad = good, bad.name = nullptr;
  EXPECT_EQ(problem(bad), "the plugin has no name");
  bad = good, bad.name = "Good One";
  EXPECT_NE(problem(bad).find("lower-case"), std::string::npos);
  bad = good, bad.name = "tipsify";
  EXPECT_EQ(problem(bad), "there is already a plugin 'tipsify'");
  bad = good, bad.kind = 9;
  EXPECT_EQ(problem(bad), "kind is 9; expected FOREDRAW_TRIANGLE_ORDERER to FOREDRAW_REMESHER");
  bad = good, bad.run = nullptr;
  EXPECT_EQ(problem(bad), "run is NULL");
  bad = good, bad.option_count = 1;
  EXPECT_EQ(problem(bad), "options or metrics are NULL");
  bad = good, bad.metric_count = 1u << 31;
  EXPECT_NE(problem(bad).find("more than 1000"), std::string::npos);
  foredraw_option option{
      .name = "power", .doc = "", .type = FOREDRAW_NUMBER, .initial = {.number = 9}, .least = 0, .most = 4};
  bad = good, bad.options = &option, bad.option_count = 1;
  EXPECT_NE(problem(bad).find("0 to 4"), std::string::npos);
  option.type = FOREDRAW_CHOICE;
  EXPECT_NE(problem(bad).find("initial text is NULL"), std::string::npos);
  option.initial.text = "one";
  EXPECT_NE(problem(bad).find("no choices"), std::string::npos);
  option.type = 77;
  EXPECT_NE(problem(bad).find("type is not one"), std::string::npos);
  EXPECT_EQ(foredraw_add_plugin(nullptr, &good, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_add_plugin(context_.get(), nullptr, nullptr), FOREDRAW_NULL_POINTER);
}

}  // namespace
}  // namespace foredraw::testing::own_plugins_test
