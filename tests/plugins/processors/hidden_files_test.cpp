// What is left of a file: every number stays, and a draw of which nothing is seen is no empty one.

#include "hidden_shapes.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

namespace foredraw::hidden_files_test {
namespace {

Scene read_again(const Scene& scene) {
  Diagnostics diagnostics;
  const auto files = encode_gltf(scene, "boxes.glb", diagnostics);
  if (!files) throw std::runtime_error(to_text(diagnostics));
  auto again = read_gltf({files->front().bytes.begin(), files->front().bytes.end()}, "boxes.glb", {}, diagnostics);
  if (!again) throw std::runtime_error(to_text(diagnostics));
  return *again;
}

Result run(const std::string& stages, const Scene& scene) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto pipeline = parse_line(stages, diagnostics);
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(2);
  Analyses analyses;
  return foredraw::optimize(*plan, scene, {executor, analyses});
}

TEST(HiddenFiles, KeepTheirNumbersAndNoDrawIsEmpty) {
  const Scene boxes = read_again(testing::one_mesh({testing::box(), testing::box(0.5f), testing::box(0.2f)}));
  const Result result =
      run("hidden(seen-from=outside, views=80, size=128, checks=20), sides, weld, lookahead, draw-sequence, "
          "occlusion-order, vertex-fetch, merge-instances, gpu-instances",
          boxes);
  EXPECT_FALSE(result.failed);
  const Scene after = read_again(result.scene);
  ASSERT_EQ(after.draws.size(), 3u);
  EXPECT_EQ(after.materials.size(), boxes.materials.size());
  EXPECT_EQ(after.meshes.size(), boxes.meshes.size());
  EXPECT_EQ(after.nodes.size(), boxes.nodes.size());
  EXPECT_EQ(after.draws[0].full().stream().triangle_count(), 12u);
  for (const DrawId id : {1, 2}) {
    const auto corners = after.draws[id].full().stream().indices.view();
    ASSERT_EQ(corners.size(), 3u);
    EXPECT_TRUE(corners[0] == corners[1] && corners[1] == corners[2]);
    EXPECT_EQ(after.draws[id].full().vertices->count, 1u);  // weld left out the others
  }
}

TEST(HiddenFiles, WhatIsNotTouchedComesOutByteForByte) {
  const Scene boxes = read_again(testing::one_mesh({testing::box(), testing::box(0.5f, {3, 0, 0})}));
  Diagnostics diagnostics;
  const Result result = run("hidden(seen-from=outside, views=80, size=128, checks=20)", boxes);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(encode_gltf(result.scene, "boxes.glb", diagnostics)->front().bytes,
            encode_gltf(boxes, "boxes.glb", diagnostics)->front().bytes);
}

TEST(HiddenFiles, NobodyCutsWithoutSayingWhereCamerasAre) {
  const Scene boxes = testing::one_mesh({testing::box()});
  for (const char* stage : {"hidden", "hidden(seen-from=box)", "hidden(seen-from=box, box=\"0 0 0\")",
                            "hidden(seen-from=points)", "hidden(seen-from=points, points=\"1 2 x\")"}) {
    EXPECT_THROW(run(stage, boxes), std::runtime_error) << stage;
  }
  EXPECT_FALSE(run("hidden(seen-from=points, points=\"1 2 3; 4 5 6\", rays=16)", boxes).failed);
}

}  // namespace
}  // namespace foredraw::hidden_files_test
