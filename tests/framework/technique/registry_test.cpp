#include <foredraw/technique/registry.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace foredraw::registry_test {
namespace {

Plugin named(std::string name) {
  Plugin plugin;
  plugin.card.name = std::move(name);
  return plugin;
}

Plugin with_option(OptionSpec option) {
  Plugin plugin = named("sample");
  plugin.options.push_back(std::move(option));
  return plugin;
}

std::string refusal(Plugin plugin) {
  Registry registry;
  try {
    registry.add(std::move(plugin));
  } catch (const std::invalid_argument& problem) {
    EXPECT_TRUE(registry.all().empty());
    return problem.what();
  }
  return "";
}

TEST(Registry, FindsByNameAndListsByName) {
  Registry registry;
  for (const char* name : {"weld", "dot-rule", "k-means2"}) registry.add(named(name));
  ASSERT_NE(registry.find("dot-rule"), nullptr);
  EXPECT_EQ(registry.find("dot-rule")->card.name, "dot-rule");
  EXPECT_EQ(registry.find("dot_rule"), nullptr);
  EXPECT_EQ(registry.find(""), nullptr);
  EXPECT_EQ(registry.names(), (std::vector<std::string>{"dot-rule", "k-means2", "weld"}));
  ASSERT_EQ(registry.all().size(), 3u);
  EXPECT_EQ(registry.all()[2], registry.find("weld"));
}

TEST(Registry, RefusesANameTwice) {
  Registry registry;
  registry.add(named("weld"));
  EXPECT_THROW(registry.add(named("weld")), std::invalid_argument);
  EXPECT_EQ(registry.all().size(), 1u);
}

TEST(Registry, RefusesNamesThatNobodyCanType) {
  for (const char* name : {"", "Weld", "dot_rule", "dot rule", "2d", "-a", "w\xc3\xa4ld", "a.b"}) {
    EXPECT_EQ(refusal(named(name)),
              "plugin name '" + std::string(name) + "': expected lower-case letters, digits and hyphens");
  }
}

TEST(Registry, RefusesOptionsThatCouldNeverBeSet) {
  for (std::string_view word : reserved_words) {
    EXPECT_NE(refusal(with_option({.name = std::string(word), .default_value = std::string()})), "");
  }
  Plugin twice = with_option({.name = "size", .default_value = std::string()});
  twice.options.push_back(twice.options.front());
  EXPECT_EQ(refusal(twice), "sample: option name 'size' is reserved or occurs twice");
}

TEST(Registry, RefusesOddOptionNames) {
  EXPECT_EQ(refusal(with_option({.name = "cache_size", .default_value = std::string()})),
            "sample: option name 'cache_size': expected lower-case letters, digits and hyphens");
}

TEST(Registry, RefusesADefaultThatDoesNotFitItsRow) {
  const OptionSpec small{
      .name = "size", .type = OptionType::integer, .default_value = std::int64_t{2}, .least = 3, .most = 9};
  EXPECT_EQ(refusal(with_option(small)), "sample: default of 'size' is 2, but must be 3 to 9");
  const OptionSpec word{
      .name = "mode", .type = OptionType::choice, .default_value = std::string("c"), .choices = {"a", "b"}};
  EXPECT_EQ(refusal(with_option(word)), "sample: default of 'mode' is c, but must be one of a, b");
  const OptionSpec unset{.name = "limit", .type = OptionType::number, .optional = true};
  EXPECT_EQ(refusal(with_option(unset)), "");
}

TEST(BindOptions, MakesFromSettings) {
  struct Sample {
    int size = 4;
  };
  class SizedOrderer : public DrawOrderer {
   public:
    explicit SizedOrderer(int size) : size_(size) {}
    IndexOrder order(const DrawView&, foredraw::Run&) const override { return {}; }
    int cache_size() const override { return size_; }

   private:
    int size_;
  };
  OptionTable<Sample> table;
  table.row(&Sample::size, "size", "How large", {1, 9});
  Plugin plugin = named("sized");
  bind_options(plugin, table, [](const Sample& options) { return std::make_unique<SizedOrderer>(options.size); });
  const auto made = [&plugin](const Settings& settings) {
    return std::get<std::unique_ptr<DrawOrderer>>(plugin.create(settings))->cache_size();
  };
  EXPECT_EQ(plugin.options.size(), 1u);
  EXPECT_EQ(made({}), 4);
  EXPECT_EQ(made({{"size", std::int64_t{7}}}), 7);
}

TEST(Kinds, HaveWords) {
  EXPECT_EQ(to_text(Kind::orderer), "orderer");
  EXPECT_EQ(to_text(Kind::clusterer), "clusterer");
  EXPECT_EQ(to_text(Kind::processor), "processor");
  EXPECT_EQ(to_text(Kind::evaluator), "evaluator");
}

TEST(Registry, SaysWhyAPluginIsNotThere) {
  Registry registry;
  registry.add(named("sample"));
  registry.leave_out("other", "it needs package x, which was not found");
  EXPECT_EQ(registry.hint_for("other", registry.names()),
            "this build leaves it out: it needs package x, which was not found");
  EXPECT_EQ(registry.hint_for("sampel", registry.names()), "did you mean 'sample'?");
  EXPECT_EQ(registry.hint_for("nothing-like-it", registry.names()), "foredraw list shows all plugins");
}

}  // namespace
}  // namespace foredraw::registry_test
