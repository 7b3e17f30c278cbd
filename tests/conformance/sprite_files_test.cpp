// A sheet of sprites cut into frames, written as glTF and read back.

#include "support/image_builder.h"
#include "support/sprite_scenes.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gtest/gtest.h>

namespace foredraw::sprite_files_test {
namespace {

Scene sheet_of_two() {
  const ImageFacts facts{8, 4, 2, 8, false};
  std::vector<std::uint16_t> values;
  for (int row = 0; row < 4; ++row) {
    for (const std::uint16_t alpha : {0, 200, 0, 0, 0, 0, 200, 0}) values.insert(values.end(), {255, alpha});
  }
  Image image;
  image.media_type = "image/png";
  image.bytes = Shared<std::byte>(testing::png_of(facts, values));
  image.facts = facts;
  return testing::sprite_scene(std::move(image), "sheet");
}

TEST(SpriteFiles, frames_of_a_sheet_are_written_and_read_back_each_as_a_node_with_its_mesh) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  Pipeline pipeline = *parse_line("sprite-frames(find=true)", diagnostics);
  pipeline.measure = *parse_stages("sprite-fill(scales=\"1\", turns=5)", "measure", diagnostics);
  const Scene sheet = sheet_of_two();
  const auto plan = foredraw::plan(pipeline, registry, sheet, diagnostics);
  ASSERT_TRUE(plan) << to_text(diagnostics);
  const Executor executor(2);
  Analyses analyses(image_decoder({}));
  const Result result = optimize(*plan, sheet, {executor, analyses});
  ASSERT_FALSE(result.failed);

  ASSERT_EQ(result.report.draws.size(), 2u);
  const Figure* whole = result.report.before.metrics.find("sprite-fill", "needed");
  const Figure* frames = result.report.after.metrics.find("sprite-fill", "needed");
  ASSERT_TRUE(whole != nullptr && frames != nullptr);
  EXPECT_EQ(whole->value(), frames->value());
  EXPECT_EQ(result.report.draws[1].name, "sheet/1");
  EXPECT_NE(result.report.draws[1].after.metrics.find("sprite-fill", "fill"), nullptr);

  const auto files = encode_gltf(result.scene, "sheet.glb", diagnostics);
  ASSERT_TRUE(files) << to_text(diagnostics);
  const auto again = read_gltf(files->front().bytes, "sheet.glb", {}, diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  ASSERT_EQ(again->draws.size(), 2u);
  ASSERT_EQ(again->nodes.size(), 3u);
  EXPECT_EQ(again->nodes[0].children, (std::vector<NodeId>{1, 2}));
  EXPECT_EQ(again->nodes[2].name, "sheet/1");
  for (DrawId id = 0; id < 2; ++id) {
    EXPECT_EQ(again->draws[id].name, result.scene.draws[id].name);
    EXPECT_EQ(again->draws[id].levels[0].vertices->stamp(), result.scene.draws[id].levels[0].vertices->stamp());
    EXPECT_EQ(again->draws[id].material, 0u);
    EXPECT_TRUE(again->draws[id].traits.has(traits::sprite));
  }
  EXPECT_EQ(again->images[0].bytes, result.scene.images[0].bytes);
}

}  // namespace
}  // namespace foredraw::sprite_files_test
