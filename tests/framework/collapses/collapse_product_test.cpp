#include <foredraw/collapses/collapse_product.h>

#include "support/meshes.h"

#include <foredraw/collapses/collapse_sequences.h>

#include <gtest/gtest.h>

namespace foredraw::collapse_product_test {
namespace {

class CollapseProduct : public ::testing::Test {
 protected:
  CollapseProduct() {
    scene_ = testing::scene_of(testing::grid(1, 1));  // 0 1 / 2 3
    const auto indices = scene_.draws[0].full().stream().indices.view();
    sequence_.collapses = {{indices[0], indices[1], 0, 0}};
    sequence_.pairs = {{indices[0], indices[1]}};
    sequence_.first_pair = {0, 1};
    set();
  }

  void set(std::vector<DrawsCollapse> more = {}) {
    more.insert(more.begin(), {{0}, std::make_shared<const CollapseSequence>(sequence_)});
    scene_.products.set(CollapseSequences{std::move(more)});
  }

  Scene scene_;
  CollapseSequence sequence_;
  const std::shared_ptr<const ProductRow> row_ = collapse_product();
};

TEST_F(CollapseProduct, IsProvedByRunningIt) {
  EXPECT_EQ(row_->difference(scene_), "");
  sequence_.collapses[0].kept = 99;
  set();
  EXPECT_NE(row_->difference(scene_), "");
}

TEST_F(CollapseProduct, ADrawHasOne) {
  set({{{0}, std::make_shared<const CollapseSequence>(sequence_)}});
  EXPECT_NE(row_->difference(scene_), "");
  set({{{7}, std::make_shared<const CollapseSequence>(sequence_)}});
  EXPECT_NE(row_->difference(scene_), "");
}

TEST_F(CollapseProduct, EndsWhereVerticesAreChanged) {
  Scene after = scene_;
  EXPECT_TRUE(row_->follow(scene_, after).empty());
  EXPECT_NE(after.products.find<CollapseSequences>(), nullptr);
  after.draws[0].full().vertices = std::make_shared<const VertexStreams>(*after.draws[0].full().vertices);
  EXPECT_EQ(row_->follow(scene_, after).size(), 1u);
  EXPECT_EQ(after.products.find<CollapseSequences>(), nullptr);
}

TEST_F(CollapseProduct, IsTold) {
  const ProductText text = row_->told(scene_);
  ASSERT_EQ(text.lines.size(), 1u);
  EXPECT_EQ(text.lines[0], "mesh: edges that collapse: 1");
}

}  // namespace
}  // namespace foredraw::collapse_product_test
