#include "support/program.h"

#include <foredraw/pipeline/canonical.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw::canonical_test {
namespace {

class Canonical : public testing::InFolder {
 protected:
  Canonical() { add_built_in_plugins(registry_); }

  std::string text(const std::string& written) {
    Diagnostics diagnostics;
    const auto pipeline = written.find('\n') == std::string::npos ? parse_line(written, diagnostics)
                                                                  : parse_file(written, "a.toml", diagnostics);
    EXPECT_TRUE(pipeline) << to_text(diagnostics);
    return pipeline ? canonical_text(*pipeline, registry_) : "";
  }

  Registry registry_;
};

TEST_F(Canonical, DoesNotHangOnHowItIsWritten) {
  const std::string usual = text("weld, tipsify");
  EXPECT_EQ(text("weld,  tipsify( cache-size = 16 )"), text("weld, tipsify(cache-size=16)"));
  EXPECT_EQ(text("# a comment\npipeline = 1\nabout = \"mine\"\nstages = [\"weld\", { use = \"tipsify\" }]\n"), usual);
  const auto rows = registry_.find("tipsify")->options;
  for (const OptionSpec& row : rows) {
    if (std::holds_alternative<std::monostate>(row.default_value)) continue;
    EXPECT_EQ(text("weld, tipsify(" + row.name + '=' + to_text(row.default_value, true) + ')'), usual) << row.name;
  }
}

TEST_F(Canonical, DiffersWithAllThatIsDone) {
  const std::string usual = text("weld, tipsify");
  for (const char* other : {"tipsify, weld", "weld", "weld, tipsify(cache-size=24)", "weld, tipsify(only=\"a*\")",
                            "weld, tipsify(enabled=false)", "weld, tipsify(blended=true)", "weld, forsyth",
                            "pipeline = 1\nseed = 7\nstages = [\"weld\", \"tipsify\"]\n",
                            "pipeline = 1\nstages = [\"weld\", \"tipsify\"]\n[views]\ncount = 12\n"}) {
    EXPECT_NE(text(other), usual) << other;
  }
}

TEST_F(Canonical, DevicesAreThoseOfPluginsThatSaySo) {
  Plugin drawing = *registry_.find("tipsify");
  drawing.card.name = "drawing";
  drawing.device = [](const Settings& settings) {
    return std::get<std::int64_t>(settings.at("cache-size")) == 16 ? std::string("a device") : std::string();
  };
  registry_.add(drawing);
  const auto devices = [&](const std::string& text) {
    Diagnostics diagnostics;
    return devices_in(*parse_line(text, diagnostics), registry_);
  };
  EXPECT_EQ(devices("tipsify, drawing"), (std::vector<std::string>{"drawing: a device"}));
  EXPECT_TRUE(devices("tipsify, drawing(cache-size=24)").empty());
  EXPECT_TRUE(devices("drawing(cache-size=many)").empty()) << "what the planner refuses";
}

TEST_F(Canonical, FilesAreThoseThatOptionsName) {
  testing::put(folder_ / "views.txt", "");
  Diagnostics diagnostics;
  auto pipeline = parse_line("tipsify", diagnostics);
  EXPECT_TRUE(files_named_in(*pipeline, registry_).empty());
  pipeline->stages[0].settings["cache-size"] = (folder_ / "views.txt").string();
  EXPECT_EQ(files_named_in(*pipeline, registry_), (std::vector<std::filesystem::path>{folder_ / "views.txt"}));
}

}  // namespace
}  // namespace foredraw::canonical_test
