// What every plugin has to do, tested once over the registry. The runner checks each answer (permutation, partition,
// certificate) and reports a failure where it is none, so a run that did not fail is a run with right answers.

#include "all_plugins.h"
#include "odd_scenes.h"
#include "support/sprite_scenes.h"

#include <foredraw/analysis/vertex_rows.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/scene/levels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw {
namespace {

const Registry& registry() {
  static const Registry all = [] {
    Registry registry;
    add_all_plugins(registry);
    return registry;
  }();
  return all;
}

/// A pipeline with the plugin as its last stage, behind whatever provides what it needs.
Pipeline pipeline_for(const Plugin& plugin, const Settings& settings) {
  Pipeline pipeline;
  Stage stage;
  stage.use = plugin.card.name;
  stage.settings = settings;
  if (plugin.kind == Kind::evaluator) {
    pipeline.measure.push_back(stage);
    return pipeline;
  }
  for (const std::string& need : plugin.card.needs) {
    for (const Plugin* other : registry().all()) {
      if (!other->card.provides.has(need)) continue;
      pipeline.stages.push_back({.use = other->card.name});
      break;
    }
  }
  pipeline.stages.push_back(stage);
  return pipeline;
}

/// Lends whatever is asked for.
class Generous final : public Lender {
 public:
  std::optional<Loan<Scene>> scene(const std::string&, Diagnostics&) const override {
    return Loan<Scene>{std::make_shared<const Scene>(testing::odd_scene()), 1, {}};
  }
  std::optional<Loan<Image>> image(const std::string&, Diagnostics&) const override {
    return Loan<Image>{std::make_shared<const Image>(testing::odd_scene().images.front()), 1, {}};
  }
};

struct Outcome {
  Result result;
  Plan plan;
};

/// What is measured for orders, is so in few small pictures.
Outcome run(Pipeline pipeline, int threads) {
  pipeline.views.count = 12;
  pipeline.views.size = 48;
  Diagnostics diagnostics;
  const Scene scene = testing::odd_scene();
  const Generous lender;
  auto plan = foredraw::plan(pipeline, registry(), scene, diagnostics, &lender);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor(threads);
  Analyses analyses(testing::stored_texels());
  Result result = foredraw::optimize(*plan, scene, {executor, analyses});
  return {std::move(result), std::move(*plan)};
}

std::string problems(const Result& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.report.diagnostics) text += to_text(diagnostic) + '\n';
  return text;
}

/// Stamps of all that a scene draws.
std::vector<Stamp> content(const Scene& scene) {
  std::vector<Stamp> stamps;
  for (const Draw& draw : scene.draws) {
    for (const Level& level : draw.levels) {
      stamps.push_back(level.vertices->stamp());
      for (const IndexStream& stream : level.orders) stamps.push_back(stream.indices.stamp());
    }
  }
  return stamps;
}

std::vector<double> figures(const Result& result) {
  std::vector<double> values;
  for (const auto& [plugin, metrics] : result.report.after.metrics.all()) {
    for (const auto& [metric, figure] : metrics) {
      values.push_back(figure.numerator);
      values.push_back(figure.denominator.value_or(-1));
      values.push_back(figure.error);
    }
  }
  return values;
}

bool same(const Attachment& a, const Attachment& b) {
  if (a.index() != b.index() || name_of(a) != name_of(b)) return false;
  if (const auto* film = std::get_if<Film>(&a)) return film->frames == std::get<Film>(b).frames;
  const auto same_value = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  const auto same_line = [&](const Chart::Line& x, const Chart::Line& y) {
    return x.name == y.name && std::ranges::equal(x.values, y.values, same_value);
  };
  const Chart &x = std::get<Chart>(a), &y = std::get<Chart>(b);
  return std::ranges::equal(x.lines, y.lines, same_line) && x.mark.has_value() == y.mark.has_value() &&
         (!x.mark || x.mark->value == y.mark->value);
}

/// Pictures and curves that techniques attached, in their sequence.
std::vector<AttachmentRecord> attachments(const Result& result) {
  std::vector<AttachmentRecord> all;
  for (const auto* records : {&result.report.stages, &result.report.measures}) {
    for (const StageRecord& record : *records) {
      all.insert(all.end(), record.attachments_before.begin(), record.attachments_before.end());
      all.insert(all.end(), record.attachments.begin(), record.attachments.end());
    }
  }
  return all;
}

bool same_attachments(const Result& a, const Result& b) {
  return std::ranges::equal(attachments(a), attachments(b), [](const AttachmentRecord& x, const AttachmentRecord& y) {
    return x.about == y.about && same(*x.content, *y.content);
  });
}

/// How far pictures and samples go: a hundred thousand views show no more than a thousand, but take a device minutes.
struct Pictures {
  double views, pixels, points, frames;
};
constexpr Pictures some_pictures{100, 512, 2000, 6};
constexpr Pictures largest_pictures{1000, 4096, 100'000, 300};

bool is_size(const OptionSpec& option) {
  return option.unit == "pixels" && (option.name == "size" || option.name == "width" || option.name == "height");
}

double most_of(const OptionSpec& option, const Pictures& pictures) {
  if (option.unit == "views") return std::min(option.most, pictures.views);
  if (option.unit == "points") return std::min(option.most, pictures.points);
  if (option.unit == "frames") return std::min(option.most, pictures.frames);
  return is_size(option) ? std::min(option.most, pictures.pixels) : option.most;
}

std::optional<OptionValue> extreme(const OptionSpec& option, bool most, const Pictures& pictures = some_pictures) {
  // The least error takes the most views, and leaves the other options of views unused.
  if (option.name == "error" && !most) return std::nullopt;
  const double bound = most ? most_of(option, pictures) : option.least;
  if (option.type == OptionType::boolean) return most;
  if (option.type == OptionType::choice) return most ? option.choices.back() : option.choices.front();
  if (!std::isfinite(bound)) return std::nullopt;
  if (option.type == OptionType::integer) return static_cast<std::int64_t>(bound);
  if (option.type == OptionType::number) return bound;
  return std::nullopt;
}

/// The options that a plugin may not do without: those that name files, and choices without a default.
Settings what_must_be_said(const Plugin& plugin) {
  Settings said;
  for (const OptionSpec& option : plugin.options) {
    if (option.type == OptionType::scene || option.type == OptionType::image) said[option.name] = std::string("lent");
    const bool has_default = !std::holds_alternative<std::monostate>(option.default_value);
    if (option.type == OptionType::choice && !has_default) said[option.name] = option.choices.front();
  }
  return said;
}

/// The defaults, but for pictures and samples: a few small ones are made by the same code as many large ones, in a
/// hundredth of the time.
Settings few_pictures(const Plugin& plugin) {
  Settings settings = what_must_be_said(plugin);
  for (const OptionSpec& option : plugin.options) {
    if (option.unit == "views") settings[option.name] = std::int64_t{12};
    if (option.unit == "points") settings[option.name] = std::int64_t{100};
    if (option.unit == "frames") settings[option.name] = std::int64_t{3};
    if (is_size(option)) settings[option.name] = std::int64_t{48};
  }
  return settings;
}

/// Everything at its least.
Settings least_of(const Plugin& plugin) {
  Settings least = what_must_be_said(plugin);
  for (const OptionSpec& option : plugin.options) {
    if (const auto value = extreme(option, false)) least[option.name] = *value;
  }
  return least;
}

/// The defaults; everything at its least; and each option at its most with the others at their least.
std::vector<Settings> settings_of(const Plugin& plugin) {
  const Settings least = least_of(plugin);
  std::vector<Settings> all{few_pictures(plugin), least};
  for (const OptionSpec& option : plugin.options) {
    if (const auto value = extreme(option, true)) {
      all.push_back(least);
      all.back()[option.name] = *value;
    }
  }
  return all;
}

class EveryPlugin : public ::testing::TestWithParam<std::string> {
 protected:
  const Plugin& plugin() const { return *registry().find(GetParam()); }
};

TEST_P(EveryPlugin, AnswersRightOnOddDrawsAtEveryOption) {
  for (const Settings& settings : settings_of(plugin())) {
    const Pipeline pipeline = pipeline_for(plugin(), settings);
    const Outcome outcome = run(pipeline, 2);
    EXPECT_FALSE(outcome.result.failed) << print_file(pipeline) << problems(outcome.result);
  }
}

TEST_P(EveryPlugin, GivesTheSameTwiceAndAtAnyThreadCount) {
  const Pipeline pipeline = pipeline_for(plugin(), few_pictures(plugin()));
  const Result first = run(pipeline, 1).result;
  for (int threads : {1, 5}) {
    const Result again = run(pipeline, threads).result;
    EXPECT_EQ(content(first.scene), content(again.scene));
    EXPECT_EQ(figures(first), figures(again));
    EXPECT_TRUE(same_attachments(first, again));
  }
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

/// Whether the draw is what the trait says, as far as that can be seen from the draw.
bool holds(const std::string& trait, const Draw& draw) {
  const Level& level = draw.levels[0];
  if (trait == traits::clustered) return level.orders[0].clusters.has_value();
  if (trait == traits::welded) {
    const VertexRows rows(*level.vertices);
    std::set<Stamp> different;
    for (std::size_t v = 0; v < rows.size(); ++v) different.insert(content_hash(rows[v]));
    return different.size() == rows.size();
  }
  return true;
}

TEST_P(EveryPlugin, ProvidesWhatItsCardSays) {
  if (plugin().kind == Kind::evaluator) return;
  const Outcome outcome = run(pipeline_for(plugin(), few_pictures(plugin())), 2);
  const PlannedStage& stage = outcome.plan.stages.back();
  for (const Draw& draw : outcome.result.scene.draws) {
    for (const std::string& trait : plugin().card.provides) {
      EXPECT_TRUE(!traits_of(draw).has(trait) || holds(trait, draw)) << draw.name << ' ' << trait;
    }
    EXPECT_EQ(traits_of(draw).has(traits::clustered), draw.levels[0].orders[0].clusters.has_value()) << draw.name;
  }
  // Every draw that it was planned for has it now, but for those that vertices shared with others hold back. A stage
  // that finds nothing to gain in the scene as a whole has provided nothing.
  const StageRecord& record = outcome.result.report.stages.back();
  const auto is_of_all = [](const SkipRecord& skip) { return skip.code == "nothing-to-gain"; };
  if (record.changed == 0 && record.candidates == 1 && std::ranges::any_of(record.skipped, is_of_all)) return;
  for (DrawId id : stage.draws) {
    const Draw& draw = outcome.result.scene.draws[id];
    const bool held = draw.name.starts_with("held back");
    for (const std::string& trait : plugin().card.provides) {
      EXPECT_TRUE(held || traits_of(draw).has(trait)) << draw.name << ' ' << trait;
    }
  }
}

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

TEST_P(EveryPlugin, SaysWhatItIs) {
  const Card& card = plugin().card;
  EXPECT_FALSE(card.summary.empty());
  EXPECT_FALSE(card.reference.empty());
  EXPECT_NE(card.summary.back(), '.');
  for (const OptionSpec& option : plugin().options) EXPECT_FALSE(option.doc.empty()) << option.name;
  EXPECT_TRUE(plugin().kind != Kind::evaluator || !card.metrics.empty());
  for (const std::string& name : card.measured_by) {
    const Plugin* evaluator = registry().find(name);
    ASSERT_NE(evaluator, nullptr) << name;
    EXPECT_EQ(evaluator->kind, Kind::evaluator) << name;
  }
  for (const Traits* asked : {&card.wants, &card.uses}) {
    for (const std::string& trait : *asked) {
      const auto provides = [&](const Plugin* other) { return other->card.provides.has(trait); };
      EXPECT_TRUE(std::ranges::any_of(registry().all(), provides)) << "nobody makes draws " << trait;
    }
  }
}

TEST_P(EveryPlugin, MeasuresWhatItsCardLists) {
  const Result result = run(pipeline_for(plugin(), few_pictures(plugin())), 2).result;
  for (const auto& [name, metrics] : result.report.after.metrics.all()) {
    for (const auto& [metric, figure] : metrics) EXPECT_FALSE(figure.unit.empty()) << metric << " is not on the card";
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryPlugin, ::testing::ValuesIn(registry().names()), test_name);

bool is_of_pictures(const OptionSpec& option) {
  return option.unit == "views" || option.unit == "frames" || is_size(option);
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
    Settings settings = least_of(plugin());
    settings[option.name] = *extreme(option, true, largest_pictures);
    const Pipeline pipeline = pipeline_for(plugin(), settings);
    const Outcome outcome = run(pipeline, 2);
    EXPECT_FALSE(outcome.result.failed) << print_file(pipeline) << problems(outcome.result);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, PluginWithPictures, ::testing::ValuesIn(names_with_pictures()), test_name);

}  // namespace
}  // namespace foredraw
