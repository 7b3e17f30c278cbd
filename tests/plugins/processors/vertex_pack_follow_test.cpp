// What becomes of packed vertices behind later stages.
#include "support/packed_scenes.h"

#include <foredraw/packing/packed_precision.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::vertex_pack_follow_test {
namespace {

using testing::framed_scene;
using ::testing::HasSubstr;
using testing::notes_of;
using testing::packed;
using testing::packed_of;

/// A stage behind that renumbers, welds or drops vertices: rows move with them.
TEST(PackedVerticesFollow, RowsMoveWithTheirVertices) {
  Scene scene = framed_scene();
  testing::TestMesh twice = testing::joined(testing::sphere(16, 8), testing::sphere(16, 8));
  scene.draws[1] = testing::framed(testing::draw_of(twice, "plate"));
  for (const char* stages :
       {"vertex-pack, tipsify, vertex-fetch", "vertex-pack, weld", "vertex-pack, weld, vertex-fetch"}) {
    const Result result = testing::run(stages, scene);
    EXPECT_FALSE(result.failed);
    const PackedVertices& all = packed_of(result.scene);
    ASSERT_EQ(all.draws.size(), 2u) << stages;
    for (const PackedVertices::OfDraw& draw : all.draws) {
      for (std::size_t l = 0; l < draw.rows.size(); ++l) {
        const VertexStreams& vertices = *result.scene.draws[draw.draw].levels[l].vertices;
        EXPECT_EQ(broken_promise(vertices, draw.layout, draw.rows[l].view()), "") << stages;
      }
    }
  }
  const Result welded = testing::run("vertex-pack, weld", scene);
  EXPECT_LT(packed_of(welded.scene).draws[1].rows[0].size(), packed_of(packed(scene)).draws[1].rows[0].size());
}

/// A stage that makes other vertices leaves rows behind, and says so.
TEST(PackedVerticesFollow, IsLeftOutWhereVerticesWereMadeAnew) {
  const Result result =
      testing::run("weld, quadric-collapse, vertex-pack, levels", testing::scene_of(testing::sphere(48, 24)));
  EXPECT_FALSE(result.failed);
  EXPECT_FALSE(result.scene.products.has(PackedVertices::product));
  EXPECT_THAT(notes_of(result), HasSubstr("pack them after that stage"));
}

}  // namespace
}  // namespace foredraw::vertex_pack_follow_test
