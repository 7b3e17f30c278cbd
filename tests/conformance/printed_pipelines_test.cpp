// A pipeline with any plugin at any setting is printed and parsed back.
#include "every_plugin.h"
#include "option_settings.h"

#include <foredraw/pipeline/parse.h>

namespace foredraw::testing::printed_pipelines_test {
namespace {

TEST_P(EveryPlugin, PrintsAndParsesBackAtEveryOption) {
  for (const Settings& settings : settings_of(plugin())) {
    const Pipeline pipeline = pipeline_for(plugin(), settings);
    Diagnostics diagnostics;
    const auto from_file = parse_file(print_file(pipeline), "printed", diagnostics);
    ASSERT_TRUE(from_file) << to_text(diagnostics);
    EXPECT_TRUE(same_pipeline(pipeline, *from_file)) << print_file(pipeline);
    if (const auto line = print_line(pipeline)) {
      const auto from_line = parse_line(*line, diagnostics);
      ASSERT_TRUE(from_line) << to_text(diagnostics);
      EXPECT_TRUE(same_pipeline(pipeline, *from_line)) << *line;
    }
  }
}

}  // namespace
}  // namespace foredraw::testing::printed_pipelines_test
