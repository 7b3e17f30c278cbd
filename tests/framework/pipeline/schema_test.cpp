#include <foredraw/pipeline/schema.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw::schema_test {
namespace {

using Json = nlohmann::json;

enum class Shape { round, square };

struct SampleOptions {
  bool quick = true;
  int cache_size = 16;
  std::optional<double> limit;
  double growth = 1.25;
  std::string label = "plain";
  Shape shape = Shape::square;
  std::string views = "icosphere";
};

Plugin sample(std::string name, Kind kind) {
  Plugin plugin;
  plugin.card.name = std::move(name);
  plugin.card.summary = "A sample";
  plugin.kind = kind;
  OptionTable<SampleOptions> table;
  table.row(&SampleOptions::quick, "quick", "Whether it hurries");
  table.row(&SampleOptions::cache_size, "cache-size", "Size of the cache", {3, 1024, "entries"});
  table.row(&SampleOptions::limit, "limit", "Where it stops", {0.5, 3});
  table.row(&SampleOptions::growth, "growth", "How it grows", {1});
  table.row(&SampleOptions::label, "label", "What it is called");
  table.choice(&SampleOptions::shape, "shape", "Its shape", {{"round", Shape::round}, {"square", Shape::square}});
  table.number_or_text(&SampleOptions::views, "views", "Where to look from");
  plugin.options = table.specs();
  return plugin;
}

Registry samples() {
  Registry registry;
  registry.add(sample("arrange", Kind::orderer));
  registry.add(sample("measure", Kind::evaluator));
  Plugin service = sample("serve", Kind::evaluator);
  service.overdraw_service = [](const Settings&) { return nullptr; };
  registry.add(std::move(service));
  return registry;
}

std::vector<std::string> names_offered(const Json& schema, const std::string& list) {
  return schema["$defs"][list]["anyOf"][0]["enum"].get<std::vector<std::string>>();
}

TEST(Schema, HoldsEveryOptionOfEveryPlugin) {
  const Registry registry = samples();
  const Json schema = Json::parse(pipeline_schema(registry));
  for (const Plugin* plugin : registry.all()) {
    const Json& stage = schema["$defs"][plugin->card.name];
    EXPECT_EQ(stage["additionalProperties"], false);
    EXPECT_EQ(stage["required"], Json({"use"}));
    EXPECT_EQ(stage["properties"]["use"]["const"], plugin->card.name);
    for (const OptionSpec& option : plugin->options) {
      ASSERT_TRUE(stage["properties"].contains(option.name)) << option.name;
      EXPECT_NE(stage["properties"][option.name]["description"].get<std::string>().find(option.doc), std::string::npos);
    }
    for (const char* reserved : {"only", "required", "enabled", "blended", "level"}) {
      EXPECT_TRUE(stage["properties"].contains(reserved)) << reserved;
    }
    EXPECT_EQ(stage["properties"].size(), plugin->options.size() + 6);
  }
}

TEST(Schema, TellsTypesRangesAndDefaults) {
  const Json schema = Json::parse(pipeline_schema(samples()));
  const Json& options = schema["$defs"]["arrange"]["properties"];
  EXPECT_EQ(options["quick"],
            Json::parse(R"json({"description": "Whether it hurries", "type": "boolean", "default": true})json"));
  EXPECT_EQ(options["cache-size"], Json::parse(R"json({"description": "Size of the cache (entries)", "type": "integer",
                                                   "minimum": 3, "maximum": 1024, "default": 16})json"));
  EXPECT_EQ(
      options["limit"],
      Json::parse(R"json({"description": "Where it stops", "type": "number", "minimum": 0.5, "maximum": 3})json"));
  EXPECT_EQ(options["growth"],
            Json::parse(R"json({"description": "How it grows", "type": "number", "minimum": 1, "default": 1.25})json"));
  EXPECT_EQ(options["label"],
            Json::parse(R"json({"description": "What it is called", "type": "string", "default": "plain"})json"));
  EXPECT_EQ(options["shape"],
            Json::parse(R"json({"description": "Its shape", "type": "string", "enum": ["round", "square"],
                                              "default": "square"})json"));
  EXPECT_EQ(options["views"]["type"], Json({"integer", "string"}));
}

TEST(Schema, OffersEachPluginWhereItBelongs) {
  const Json schema = Json::parse(pipeline_schema(samples()));
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["required"], Json({"pipeline"}));
  EXPECT_EQ(schema["properties"]["views"]["additionalProperties"], false);
  EXPECT_EQ(schema["properties"]["services"]["additionalProperties"], false);
  EXPECT_EQ(schema["properties"]["output"]["additionalProperties"], false);
  EXPECT_EQ(schema["properties"].size(), 13u);
  EXPECT_EQ(names_offered(schema, "any_stage"), std::vector<std::string>{"arrange"});
  EXPECT_EQ(names_offered(schema, "any_measure"), (std::vector<std::string>{"measure", "serve"}));
  EXPECT_EQ(names_offered(schema, "any_overdraw_service"), std::vector<std::string>{"serve"});
}

TEST(Schema, EveryReferenceLeadsSomewhere) {
  const Json schema = Json::parse(pipeline_schema(samples()));
  const Json flat = schema.flatten();
  int references = 0;
  for (const auto& [place, value] : flat.items()) {
    if (!place.ends_with("/$ref")) continue;
    ++references;
    EXPECT_TRUE(schema.contains(Json::json_pointer(value.get<std::string>().substr(1)))) << value;
  }
  EXPECT_EQ(references, 8);  // four lists, and a plugin each time that one may be named
}

TEST(Schema, IsWholeWithoutPlugins) {
  const Json schema = Json::parse(pipeline_schema(Registry()));
  EXPECT_EQ(schema["$defs"]["any_stage"], false);
}

}  // namespace
}  // namespace foredraw::schema_test
