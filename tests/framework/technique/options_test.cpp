#include <foredraw/measuring/view_options.h>
#include <foredraw/technique/options.h>

#include <gtest/gtest.h>

namespace foredraw::options_test {
namespace {

enum class Shape { round, square };

struct SampleOptions {
  bool quick = true;
  int cache_size = 16;
  std::uint8_t bits = 8;
  double growth = 1.25;
  float threshold = 0.5f;
  std::string label = "plain";
  Shape shape = Shape::square;
  std::string views = "icosphere";
  std::vector<double> steps = {0.5, 2, 1e-3};
  std::optional<int> count;
  std::optional<double> limit = 2.5;
  std::optional<std::string> file;
};

OptionTable<SampleOptions> sample_table() {
  OptionTable<SampleOptions> table;
  table.row(&SampleOptions::quick, "quick", "Whether it hurries");
  table.row(&SampleOptions::cache_size, "cache-size", "Size of the cache", {3, 1024, "entries"});
  table.row(&SampleOptions::bits, "bits", "How fine", {1, 16});
  table.row(&SampleOptions::growth, "growth", "How it grows", {1});
  table.row(&SampleOptions::threshold, "threshold", "Where it turns",
            {-std::numeric_limits<double>::infinity(), 0.75, "pixels"});
  table.row(&SampleOptions::label, "label", "What it is called");
  table.choice(&SampleOptions::shape, "shape", "Its shape", {{"round", Shape::round}, {"square", Shape::square}});
  table.number_or_text(&SampleOptions::views, "views", "Where to look from");
  table.row(&SampleOptions::steps, "steps", "How far each goes");
  table.row(&SampleOptions::count, "count", "How many", {1, 10});
  table.row(&SampleOptions::limit, "limit", "Where it stops");
  table.row(&SampleOptions::file, "file", "Where it is read from");
  return table;
}

OptionSpec row(const std::string& name) {
  const OptionTable<SampleOptions> table = sample_table();
  for (const OptionSpec& spec : table.specs()) {
    if (spec.name == name) return spec;
  }
  ADD_FAILURE() << "no row " << name;
  return {};
}

OptionValue whole(std::int64_t value) { return value; }
OptionValue text(std::string value) { return value; }

std::string refusal(const std::string& name, const OptionValue& value) {
  const auto result = fit(row(name), value);
  EXPECT_TRUE(std::holds_alternative<std::string>(result)) << name << " took " << to_text(value, true);
  return std::holds_alternative<std::string>(result) ? std::get<std::string>(result) : "";
}

OptionValue fitted(const std::string& name, const OptionValue& value) {
  const auto result = fit(row(name), value);
  EXPECT_TRUE(std::holds_alternative<OptionValue>(result)) << std::get<std::string>(result);
  return std::holds_alternative<OptionValue>(result) ? std::get<OptionValue>(result) : OptionValue();
}

TEST(OptionTable, TypesAndDefaultsComeFromTheMembers) {
  EXPECT_EQ(row("quick").type, OptionType::boolean);
  EXPECT_EQ(row("quick").default_value, OptionValue(true));
  EXPECT_EQ(row("cache-size").type, OptionType::integer);
  EXPECT_EQ(row("cache-size").default_value, whole(16));
  EXPECT_EQ(row("cache-size").unit, "entries");
  EXPECT_EQ(row("bits").type, OptionType::integer);
  EXPECT_EQ(row("bits").default_value, whole(8));
  EXPECT_EQ(row("growth").type, OptionType::number);
  EXPECT_EQ(row("growth").default_value, OptionValue(1.25));
  EXPECT_EQ(row("threshold").default_value, OptionValue(0.5));
  EXPECT_EQ(row("label").type, OptionType::text);
  EXPECT_EQ(row("label").default_value, text("plain"));
  EXPECT_EQ(row("shape").type, OptionType::choice);
  EXPECT_EQ(row("shape").default_value, text("square"));
  EXPECT_EQ(row("shape").choices, (std::vector<std::string>{"round", "square"}));
  EXPECT_EQ(row("views").type, OptionType::number_or_text);
  EXPECT_EQ(row("views").default_value, text("icosphere"));
}

TEST(OptionTable, OptionalMembersMayBeLeftUnset) {
  EXPECT_TRUE(row("count").optional);
  EXPECT_EQ(row("count").type, OptionType::integer);
  EXPECT_EQ(row("count").default_value, OptionValue());
  EXPECT_TRUE(row("limit").optional);
  EXPECT_EQ(row("limit").default_value, OptionValue(2.5));
  EXPECT_TRUE(row("file").optional);
  EXPECT_EQ(row("file").type, OptionType::text);
  EXPECT_FALSE(row("quick").optional);
}

TEST(OptionTable, ReadsWhatIsSetAndKeepsTheRest) {
  const SampleOptions usual = sample_table().read({});
  EXPECT_EQ(usual.cache_size, 16);
  EXPECT_EQ(usual.count, std::nullopt);
  EXPECT_EQ(usual.limit, 2.5);

  const SampleOptions options = sample_table().read({{"quick", false},
                                                     {"cache-size", whole(24)},
                                                     {"bits", whole(12)},
                                                     {"growth", 1.5},
                                                     {"threshold", 0.25},
                                                     {"label", text("fancy")},
                                                     {"shape", text("round")},
                                                     {"views", text("42")},
                                                     {"count", whole(3)},
                                                     {"limit", OptionValue()},
                                                     {"file", text("views.txt")}});
  EXPECT_FALSE(options.quick);
  EXPECT_EQ(options.cache_size, 24);
  EXPECT_EQ(options.bits, 12);
  EXPECT_EQ(options.growth, 1.5);
  EXPECT_EQ(options.threshold, 0.25f);
  EXPECT_EQ(options.label, "fancy");
  EXPECT_EQ(options.shape, Shape::round);
  EXPECT_EQ(options.views, "42");
  EXPECT_EQ(options.count, 3);
  EXPECT_EQ(options.limit, std::nullopt);
  EXPECT_EQ(options.file, "views.txt");
}

TEST(Fit, RangesHoldTheirEnds) {
  EXPECT_EQ(fitted("cache-size", whole(3)), whole(3));
  EXPECT_EQ(fitted("cache-size", whole(1024)), whole(1024));
  EXPECT_EQ(refusal("cache-size", whole(2)), "'cache-size' is 2, but must be 3 to 1024 entries");
  EXPECT_EQ(refusal("cache-size", whole(1025)), "'cache-size' is 1025, but must be 3 to 1024 entries");
  EXPECT_EQ(refusal("growth", 0.5), "'growth' is 0.5, but must be at least 1");
  EXPECT_EQ(refusal("threshold", 1.0), "'threshold' is 1.0, but must be at most 0.75 pixels");
  EXPECT_EQ(refusal("count", whole(0)), "'count' is 0, but must be 1 to 10");
}

TEST(Fit, NumbersTakeWholeNumbersAndNothingInfinite) {
  EXPECT_EQ(fitted("growth", whole(2)), OptionValue(2.0));
  EXPECT_EQ(refusal("growth", std::numeric_limits<double>::infinity()), "'growth' must be a finite number, not inf");
  EXPECT_EQ(refusal("limit", std::numeric_limits<double>::quiet_NaN()), "'limit' must be a finite number, not nan");
  EXPECT_EQ(refusal("growth", text("2")), "'growth' must be a finite number, not \"2\"");
  EXPECT_EQ(refusal("growth", true), "'growth' must be a finite number, not true");
}

TEST(Fit, ListsAreNumbersWithCommas) {
  EXPECT_EQ(row("steps").type, OptionType::numbers);
  EXPECT_EQ(row("steps").default_value, text("0.5, 2, 0.001"));
  EXPECT_EQ(fitted("steps", text(" 1 ,2e3 ")), text(" 1 ,2e3 "));
  EXPECT_EQ(fitted("steps", 0.25), text("0.25"));
  EXPECT_EQ(fitted("steps", whole(3)), text("3"));
  for (const char* list : {"a", "1; 2", "1 2", "1,,2", "1,", ",1", "1e999", "nan", "1, inf"}) {
    EXPECT_EQ(refusal("steps", text(list)),
              "'steps' must be numbers, such as \"0.5, 0.25\", not \"" + std::string(list) + "\"");
  }
  EXPECT_EQ(sample_table().read({{"steps", text("3, 4")}}).steps, (std::vector<double>{3, 4}));
  EXPECT_TRUE(sample_table().read({{"steps", text("")}}).steps.empty());
}

TEST(Fit, EachTypeRefusesTheOthers) {
  EXPECT_EQ(refusal("cache-size", 16.0), "'cache-size' must be a whole number, not 16.0");
  EXPECT_EQ(refusal("cache-size", text("16")), "'cache-size' must be a whole number, not \"16\"");
  EXPECT_EQ(refusal("quick", whole(1)), "'quick' must be true or false, not 1");
  EXPECT_EQ(refusal("label", whole(1)), "'label' must be a string, not 1");
  EXPECT_EQ(refusal("views", 1.5), "'views' must be a whole number or a string, not 1.5");
  EXPECT_EQ(refusal("shape", text("oval")), "'shape' is oval, but must be one of round, square");
  EXPECT_EQ(refusal("shape", whole(1)), "'shape' is 1, but must be one of round, square");
}

TEST(Fit, ABareNumberWillDoWhereTextOrNumberIsWanted) {
  EXPECT_EQ(fitted("views", whole(42)), text("42"));
  EXPECT_EQ(fitted("views", text("axes")), text("axes"));
}

TEST(OptionText, IsAPipelinesSpelling) {
  EXPECT_EQ(to_text(OptionValue(true)), "true");
  EXPECT_EQ(to_text(whole(-16)), "-16");
  EXPECT_EQ(to_text(OptionValue(1.05)), "1.05");
  EXPECT_EQ(to_text(OptionValue(2.0)), "2.0");
  EXPECT_EQ(to_text(OptionValue(-0.0)), "-0.0");
  EXPECT_EQ(to_text(OptionValue(1e20)), "1e+20");
  EXPECT_EQ(to_text(OptionValue(0.1)), "0.1");
  EXPECT_EQ(to_text(text("axes")), "axes");
  EXPECT_EQ(to_text(text("axes"), true), "\"axes\"");
  EXPECT_EQ(to_text(text("a\"b\\c\nd\te\x01\x7f\xc3\xa4"), true), "\"a\\\"b\\\\c\\nd\\te\\u0001\\u007F\xc3\xa4\"");
  EXPECT_EQ(to_text(OptionValue()), "unset");
}

TEST(ViewRows, DefaultsAreTheViewSetsOwn) {
  OptionTable<ViewSet> table;
  add_view_rows(table);
  EXPECT_EQ(table.read({}), ViewSet{});
  std::vector<std::string> names;
  for (const OptionSpec& spec : table.specs()) names.push_back(spec.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"views", "count", "seed", "axis", "angle", "rotation", "distance", "size"}));
  const ViewSet set = table.read({{"views", text("cone")},
                                  {"count", whole(7)},
                                  {"seed", whole(3)},
                                  {"axis", text("1 0 0")},
                                  {"angle", 30.5},
                                  {"rotation", whole(4)},
                                  {"distance", 2.5},
                                  {"size", whole(64)}});
  EXPECT_EQ(set, (ViewSet{"cone", 7, 3, "1 0 0", 30.5, 4, 2.5, 64}));
}

}  // namespace
}  // namespace foredraw::options_test
