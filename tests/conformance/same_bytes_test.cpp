// The same input gives the same, each time and at any thread count.
#include "every_plugin.h"
#include "option_settings.h"
#include "same_results.h"

#include <foredraw/pipeline/parse.h>
#include <foredraw/scene/product_row.h>

#include <algorithm>

namespace foredraw::testing::conformance_same_bytes_test {
namespace {

TEST_P(EveryPlugin, GivesTheSameTwiceAndAtAnyThreadCount) {
  const Pipeline pipeline = pipeline_for(plugin(), few_pictures(plugin()));
  const Result first = run(pipeline, 1).result, again = run(pipeline, 5).result;
  EXPECT_EQ(content(first.scene), content(again.scene));
  EXPECT_EQ(figures(first), figures(again));
  EXPECT_TRUE(same_attachments(first, again));
}

TEST(Conformance, PicturesAndCurvesAreTheSameAtAnyThreadCount) {
  Settings settings = few_pictures(*registry().find("lod-walk"));
  settings["replay"] = true;
  const Pipeline pipeline = pipeline_for(*registry().find("lod-walk"), settings);
  const Result one = run(pipeline, 1).result;
  for (const bool is_film : {false, true}) {
    EXPECT_TRUE(std::ranges::any_of(attachments(one), [&](const AttachmentRecord& record) {
      return std::holds_alternative<Film>(*record.content) == is_film;
    }));
  }
  for (int threads : {2, 8}) EXPECT_TRUE(same_attachments(one, run(pipeline, threads).result)) << threads;
}

TEST(Conformance, AccuraciesOfPicturesAreTheSameAtAnyThreadCountLong) {
  Settings settings = few_pictures(*registry().find("lod-walk"));
  settings["accuracy"] = std::string("pictures");
  settings["renderings"] = true;
  const Pipeline pipeline = pipeline_for(*registry().find("lod-walk"), settings);
  const Result first = run(pipeline, 1).result, again = run(pipeline, 5).result;
  EXPECT_EQ(figures(first), figures(again));
  EXPECT_TRUE(same_attachments(first, again));
}

/// What stages make beside draws is the same, too.
TEST(Conformance, WhatFollowsSequencesOfCollapsesIsTheSameAtAnyThreadCount) {
  Diagnostics diagnostics;
  for (const char* line : {"weld, quadric-collapse, levels(keep-sequences=true), geomorphs",
                           "weld, quadric-collapse(placement=endpoint), progressive-stream"}) {
    const Result one = run(*parse_line(line, diagnostics), 1).result,
                 many = run(*parse_line(line, diagnostics), 8).result;
    EXPECT_FALSE(one.failed) << problems(one);
    EXPECT_FALSE(one.scene.products.empty());
    EXPECT_EQ(content(one.scene), content(many.scene));
    for (const auto& row : registry().products()) {
      EXPECT_TRUE(one.scene.products.same(row->card().name, many.scene.products)) << row->card().name;
    }
  }
}

}  // namespace
}  // namespace foredraw::testing::conformance_same_bytes_test
