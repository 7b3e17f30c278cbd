// Lists in docs/ that follow from the program stand between two marks, and are what the program says of itself.
// FOREDRAW_UPDATE_GOLDEN=1 writes them anew.

#include <foredraw/io/reading/faults.h>

#include "support/meshes.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace foredraw::docs_test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string page_of(const std::string& name) { return testing::content(testing::project_file("docs/" + name)); }

/// What stands behind "<!-- mark: generated -->", up to "<!-- end -->", is `text`.
void expect_section(const std::string& name, const std::string& mark, const std::string& text) {
  std::string page = page_of(name);
  const std::string begin = "<!-- " + mark + ": generated -->\n";
  const std::size_t at = page.find(begin);
  const std::size_t end = page.find("<!-- end -->", at);
  ASSERT_TRUE(at != std::string::npos && end != std::string::npos) << "no " << begin << " in " << name;
  const std::size_t first = at + begin.size();
  EXPECT_EQ(page.substr(first, end - first), text) << name << ": FOREDRAW_UPDATE_GOLDEN=1 writes it anew";
  if (std::getenv("FOREDRAW_UPDATE_GOLDEN") == nullptr) return;
  testing::put(testing::project_file("docs/" + name), page.replace(first, end - first, text));
}

class Docs : public testing::InFolder {
 protected:
  std::string told(const std::string& arguments) const {
    const auto ended = testing::run_program(folder_, arguments);
    EXPECT_EQ(ended.code, 0) << arguments;
    return ended.out;
  }
  Json plugins() const { return Json::parse(told("list --json"))["plugins"]; }
};

TEST_F(Docs, TheCommandLineIsTheHelp) {
  const std::string whole = told("--help");
  std::string text;
  for (const std::string command : {"optimize", "plan", "measure", "compare", "inspect", "list", "show", "schema",
                                    "check-module", "calibrate", "watch", "join-reports", "cache"}) {
    ASSERT_NE(whole.find("\n  " + command + ' '), std::string::npos) << command;
    text += "### " + command + "\n\n```text\n" + told(command + " --help") + "```\n\n";
  }
  const std::regex line("\n  ([\\w-]+) ");  // of the list of commands: none is left out
  const std::size_t commands = whole.find("Subcommands:");
  ASSERT_NE(commands, std::string::npos);
  EXPECT_EQ(std::distance(std::sregex_iterator(whole.begin() + static_cast<long>(commands), whole.end(), line), {}),
            13);
  expect_section("reference/command-line.md", "commands", text);
}

/// A table for each kind, made of the pages' first lines: "# tipsify", "", "orderer: Orders triangles ...".
TEST_F(Docs, TheIndexOfPluginsHasEveryPage) {
  std::map<std::string, std::string> tables;
  std::set<fs::path> pages;
  for (const auto& entry : fs::directory_iterator(testing::project_file("docs/reference/plugins"))) pages.insert(entry);
  for (const fs::path& page : pages) {
    if (page.filename() == "README.md") continue;
    std::smatch head;
    const std::string text = testing::content(page);
    ASSERT_TRUE(std::regex_search(text, head, std::regex("^# (.*)\n\n([a-z]+): (.*)\n"))) << page;
    tables[head[2]] += "| [" + head[1].str() + "](" + page.filename().string() + ") | " + head[3].str() + " |\n";
  }
  std::string text;
  for (const auto& [kind, rows] : tables) text += "\n## " + kind + "s\n\n| name | summary |\n|---|---|\n" + rows;
  expect_section("reference/plugins/README.md", "plugins", text + '\n');
}

TEST_F(Docs, ThePresetsAreThoseThatTravelInTheProgram) {
  std::string table = "| preset | for |\n|---|---|\n";
  std::set<fs::path> presets;
  for (const auto& entry : fs::directory_iterator(testing::project_file("framework/presets"))) presets.insert(entry);
  for (const fs::path& preset : presets) {
    std::smatch about;
    const std::string text = testing::content(preset);
    ASSERT_TRUE(std::regex_search(text, about, std::regex("about += +\"(.*)\""))) << preset;
    table += "| `@" + preset.stem().string() + "` | " + about[1].str() + " |\n";
  }
  expect_section("reference/pipelines.md", "presets", table);
  expect_section("guides/for-artists.md", "presets", table);
}

TEST_F(Docs, TheFaultsOfRealFilesAreThoseOfTheTable) {
  std::string table = "| code | files | fault | what becomes of it | why that is safe |\n|---|---|---|---|---|\n";
  for (const FaultKind& kind : fault_kinds()) {
    table += "| `" + std::string(kind.code) + "` | " + std::string(kind.files) + " | " + std::string(kind.what) +
             " | " + std::string(kind.done) + " | " + std::string(kind.why) + " |\n";
  }
  expect_section("reference/real-files.md", "faults", table);
}

/// Folders of the sources of plugins and evaluators, by the plugins' names.
std::map<std::string, fs::path> folders_of_plugins() {
  std::map<std::string, fs::path> folders;
  for (const std::string kind : {"plugins/orderers", "plugins/clusterers", "plugins/processors", "evaluators"}) {
    for (const auto& entry : fs::directory_iterator(testing::project_file(kind))) {
      std::string name = entry.path().filename().string();
      std::ranges::replace(name, '_', '-');
      if (entry.is_directory()) folders[name] = entry.path();
    }
  }
  return folders;
}

bool mentions(const fs::path& folder, const std::string& word) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    if (testing::content(entry.path()).find(word) != std::string::npos) return true;
  }
  return false;
}

TEST_F(Docs, WhoReadsTheViewsAndPosesOfAPipeline) {
  const auto readers = [](const std::string& word) {
    std::string text;
    for (const auto& [name, folder] : folders_of_plugins()) {
      if (mentions(folder, word)) text += (text.empty() ? "`" : ", `") + name + '`';
    }
    return text;
  };
  expect_section(
      "reference/pipelines.md", "readers",
      "`[views]` is read by " + readers("run.views") + ".\n`[poses]` is read by " + readers("run.poses") + ".\n");
}

TEST_F(Docs, EveryPluginStandsInTheTableOfLibraries) {
  const std::string page = page_of("guides/embedding.md");
  for (const auto& [name, folder] : folders_of_plugins()) {
    const std::string target = folder.filename().string();
    const std::regex row("\\n\\| `foredraw::(" + target + "|[^|]*`" + target + ")`");
    EXPECT_TRUE(std::regex_search(page, row)) << target << " is in no row of docs/guides/embedding.md's first table";
  }
}

/// What -o takes besides scenes, from the registry.
TEST_F(Docs, TheKindsOfOutputsAreThoseOfTheProgram) {
  const std::string help = told("optimize --help");
  std::smatch kinds;
  ASSERT_TRUE(std::regex_search(help, kinds, std::regex("the kinds are ([^.]*)\\.")));
  const std::string page = page_of("reference/command-line.md");
  std::string list = kinds[1];
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::size_t end = list.find(", ", at);
    const std::string kind = list.substr(at, end - at);
    EXPECT_NE(page.find("| `" + kind + ":FILE` |"), std::string::npos)
        << kind << " is in no row of docs/reference/command-line.md";
    at = end == std::string::npos ? end : end + 2;
  }
}

TEST_F(Docs, TheExitCodesStandInOneTable) {
  const std::string page = page_of("reference/command-line.md");
  for (const std::string code : {"0", "1", "2", "3"}) {
    EXPECT_NE(page.find("\n| " + code + " | "), std::string::npos) << code;
    EXPECT_NE(told("--help").find(code + ' '), std::string::npos) << code;
  }
}

}  // namespace
}  // namespace foredraw::docs_test
