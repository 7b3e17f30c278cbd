#include "plugins/processors/progressive_stream/stream_product.h"
#include "support/progressive_streams.h"

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/technique/plugin.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::progressive_stream_stage_test {
namespace {

using ::testing::HasSubstr;
using testing::Sequenced;
using testing::sequenced;
using testing::two_halves;

class StreamStage : public ::testing::Test {
 protected:
  void run(CollapsePlacement placement) {
    Sequenced of = sequenced(two_halves(), placement);
    scene_ = of.scene;
    for (Draw& draw : scene_.draws) draw.full().made.add(traits::progressive);
    scene_.products.set(
        CollapseSequences{{{of.draws, std::make_shared<const CollapseSequence>(std::move(of.sequence))}}});
    const Technique technique = progressive_stream_plugin().create({});
    std::get<std::unique_ptr<Processor>>(technique)->process(scene_, of.draws, fixture_.run);
  }

  Scene scene_;
  testing::RunFixture fixture_;
  const std::shared_ptr<const ProductRow> row_ = stream_product();
};

TEST_F(StreamStage, MakesAProductThatIsProved) {
  run(CollapsePlacement::endpoint);
  ASSERT_NE(scene_.products.find<ProgressiveStreams>(), nullptr);
  EXPECT_EQ(scene_.products.find<CollapseSequences>(), nullptr) << "it is used up";
  EXPECT_EQ(row_->difference(scene_), "");
  ASSERT_EQ(fixture_.findings.measured.size(), 1u);
  const SideFile file = row_->side_file(scene_, ".json", "streams.bin");
  EXPECT_EQ(file.beside.size(), scene_.products.find<ProgressiveStreams>()->meshes[0].bytes.size());
}

TEST_F(StreamStage, StaysWhileTrianglesMoveAndEndsWhereTheyChange) {
  run(CollapsePlacement::endpoint);
  Scene after = scene_;
  std::vector<std::uint32_t> order(after.draws[0].full().stream().triangle_count());
  for (std::size_t t = 0; t < order.size(); ++t) order[t] = static_cast<std::uint32_t>(order.size() - 1 - t);
  after.draws[0].full().stream() = with_triangle_order(after.draws[0].full().stream(), order);
  EXPECT_TRUE(row_->follow(scene_, after).empty());
  EXPECT_EQ(row_->difference(after), "");
  std::vector<std::uint32_t> fewer(after.draws[1].full().stream().indices.view().begin() + 3,
                                   after.draws[1].full().stream().indices.view().end());
  after.draws[1].full().stream().indices = Shared<std::uint32_t>(std::move(fewer));
  EXPECT_THAT(row_->difference(after), HasSubstr("shows other triangles"));
  EXPECT_EQ(row_->follow(scene_, after).size(), 1u);
  EXPECT_EQ(after.products.find<ProgressiveStreams>(), nullptr);
}

TEST_F(StreamStage, SaysWhatItWants) {
  run(CollapsePlacement::optimal);
  EXPECT_EQ(scene_.products.find<ProgressiveStreams>(), nullptr);
  ASSERT_EQ(fixture_.findings.notes.size(), 1u);
  EXPECT_THAT(fixture_.findings.notes[0].message, HasSubstr("endpoint"));
  EXPECT_EQ(scene_.products.find<CollapseSequences>(), nullptr) << "it is used up, whatever came of it";
}

}  // namespace
}  // namespace foredraw::progressive_stream_stage_test
