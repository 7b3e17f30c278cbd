// Every plugin answers right, whatever it is given.
#include "every_plugin.h"
#include "option_settings.h"

#include <foredraw/pipeline/parse.h>

#include <algorithm>

namespace foredraw::testing::conformance_answers_test {
namespace {

/// What is not on the card has no unit. Asked at the defaults: at others some figures are many of a kind, as
/// `shaded-times.3` is.
void expect_figures_of_the_card(const Result& result) {
  for (const auto& [name, metrics] : result.report.after.metrics.all()) {
    for (const auto& [metric, figure] : metrics) EXPECT_FALSE(figure.unit.empty()) << metric << " is not on the card";
  }
}

TEST_P(EveryPlugin, AnswersRightOnOddDrawsAtEveryOption) {
  const std::vector<Settings> all = settings_of(plugin());
  for (const Settings& settings : all) {
    const Pipeline pipeline = pipeline_for(plugin(), settings);
    const Outcome outcome = run(pipeline, 2);
    EXPECT_FALSE(outcome.result.failed) << print_file(pipeline) << problems(outcome.result);
    if (&settings == &all.front()) expect_figures_of_the_card(outcome.result);
  }
}

std::vector<std::string> names_with_pictures() {
  std::vector<std::string> names = registry().names();
  std::erase_if(names, [](const std::string& name) {
    return std::ranges::none_of(registry().find(name)->options, is_of_pictures);
  });
  return names;
}

class PluginWithPictures : public EveryPlugin {};

TEST_P(PluginWithPictures, AnswersRightWithTheMostAndTheLargest) {
  for (const OptionSpec& option : plugin().options) {
    if (!is_of_pictures(option)) continue;
    const Pipeline pipeline = pipeline_for(plugin(), with_the_largest(plugin(), option));
    const Outcome outcome = run(pipeline, 2);
    EXPECT_FALSE(outcome.result.failed) << print_file(pipeline) << problems(outcome.result);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, PluginWithPictures, ::testing::ValuesIn(names_with_pictures()), test_name);

}  // namespace
}  // namespace foredraw::testing::conformance_answers_test
