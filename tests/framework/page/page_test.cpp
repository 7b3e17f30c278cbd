#include <foredraw/page/page.h>

#include <foredraw/page/private/html.h>
#include <foredraw/page/private/page_assets.h>
#include <foredraw/page/private/page_buffer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace foredraw::page_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* hostile = "<img src=x onerror=alert(1)>\"'&</script><!--";

Comparison comparison_of(const std::string& name) {
  Branch branch{name, {}};
  branch.report.optimized = true;
  branch.report.before.metrics.set("vertex-cache", "acmr", {3, 1, 0, "misses per triangle"});
  branch.report.after.metrics.set("vertex-cache", "acmr", {3, 2, 0, "misses per triangle"});
  branch.report.pipeline = name;
  branch.report.draws.resize(1);
  branch.report.draws[0].name = name;
  branch.report.draws[0].after.metrics.set("vertex-cache", "acmr", {3, 2, 0, name});
  branch.report.diagnostics = {{Severity::warning, {.file = name}, "code", name, name}};
  StageRecord stage;
  stage.use = stage.text = stage.loops_over = name;
  stage.skipped = {{"code", name, {name}}};
  stage.notes = {{name, "code", name}};
  branch.report.stages = {stage};
  branch.report.machine = name;
  return {{name, 1}, {branch, branch}, {}};
}

/// What stands before the first element of that name, or all.
std::string before(const std::string& html, const std::string& element) { return html.substr(0, html.find(element)); }

TEST(Html, ShowsTextAsText) {
  EXPECT_EQ(escaped("<b> & \"c\" 'd'"), "&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  EXPECT_EQ(element("p", "x", "class=\"y\""), "<p class=\"y\">x</p>");
  EXPECT_EQ(script_safe("{\"a\":\"</script>\"}"), "{\"a\":\"\\u003c/script>\"}");
}

TEST(Page, TellsFiguresWithWhatTheyAreWorth) {
  const Comparison comparison = comparison_of("rock.glb");
  const std::string html = before(page({&comparison, 1}, {}, "foredraw 1"), "<script");
  EXPECT_THAT(html, HasSubstr("<td class=\"number best\" data-value=\"1.5\" data-branch=\"0\">1.5000</td>"));
  EXPECT_THAT(html, HasSubstr("[1]: 50.0 % fewer vertices shaded per triangle; the stages took 0 ms."));
  EXPECT_THAT(html, HasSubstr("foredraw 1"));
}

TEST(Page, SaysWhatWasSavedInPlainWords) {
  Comparison comparison = comparison_of("rock.glb");
  for (std::size_t i = 0; i < 2; ++i) {
    Report& report = comparison.branches[i].report;
    report.stages[0].seconds = 1.23;
    report.before.metrics.set("vertex-cache", "acmr", {200, 100, 0, ""});
    report.after.metrics.set("vertex-cache", "acmr", {i == 0 ? 129.0 : 200.05, 100, 0, ""});
    report.before.metrics.set("overdraw-raster", "ratio", {200, 100, 0.02, ""});
    report.after.metrics.set("overdraw-raster", "ratio", {i == 0 ? 113.0 : 198.0, 100, 0.01, ""});
  }
  const std::string html = before(page({&comparison, 1}, {}, "foredraw 1"), "<script");
  EXPECT_THAT(html, HasSubstr("[1]: 35.5 % fewer vertices shaded, 43.5 % fewer pixels shaded; the stages took 1.2 s."));
  EXPECT_THAT(html, HasSubstr("[2]: as many vertices shaded as before, as many pixels shaded as before; "));
}

TEST(Page, OfOnePipelineHasNoBest) {
  Comparison comparison = comparison_of("rock.glb");
  comparison.branches.pop_back();
  comparison.fronts = {{"time", "vertex-cache.acmr"}};
  const std::string html = before(page({&comparison, 1}, {}, "foredraw 1"), "<script");
  EXPECT_THAT(html, Not(HasSubstr("number best")));
  EXPECT_THAT(html, Not(HasSubstr("No other pipeline")));
  EXPECT_THAT(html, Not(HasSubstr("Per cent")));
}

TEST(Page, TellsWhatStagesChangedAsTheTerminalDoes) {
  Comparison comparison = comparison_of("rock.glb");
  StageRecord& stage = comparison.branches[0].report.stages[0];
  stage.loops_over = "scene";
  stage.candidates = 1;
  EXPECT_THAT(before(page({&comparison, 1}, {}, ""), "<script"), HasSubstr(">nothing</td>"));
  stage.changed = 1;
  EXPECT_THAT(before(page({&comparison, 1}, {}, ""), "<script"), HasSubstr(">the scene</td>"));
}

TEST(Page, NamesAreNoMarkupWhereverTheyStand) {
  const Comparison comparison = comparison_of(hostile);
  const std::string html = page({&comparison, 1}, {}, hostile);
  const std::string body = before(html.substr(html.find("<body>")), "<script");
  EXPECT_THAT(body, Not(HasSubstr("<img")));
  EXPECT_THAT(body, HasSubstr("&lt;img src=x onerror=alert(1)&gt;"));
  const std::string data = html.substr(html.find("id=\"comparison\">") + 16);
  EXPECT_THAT(before(data, "</script>"), Not(HasSubstr("<")));
  EXPECT_THAT(before(data, "</script>"), HasSubstr("\\u003cimg"));
}

TEST(Page, OfALostPipelineSaysSo) {
  Comparison comparison = comparison_of("a");
  comparison.branches[0].is_lost = true;
  comparison.branches[0].report = {};
  const std::string html = page({&comparison, 1}, {}, "foredraw");
  EXPECT_THAT(before(html, "<script"), HasSubstr("[1] could not be planned for this file"));
}

TEST(Page, OfThousandsOfFilesHoldsTheirFiguresInColumns) {
  std::vector<Comparison> comparisons;
  for (int i = 0; i < 5000; ++i) {
    comparisons.push_back(comparison_of("library/set" + std::to_string(i % 50) + "/prop" + std::to_string(i) + ".glb"));
    Metrics& after = comparisons.back().branches[1].report.after.metrics;
    after.set("vertex-cache", "acmr", {1.0 + i, 7, 0, "misses per triangle"});
    after.set("vertex-cache", "models.amd.acmr", {1.0, 7, 0, ""});
  }
  comparisons[4000].branches.clear();
  comparisons[4000].diagnostics = {{Severity::error, {.file = "bad.glb"}, "bad", "is bad", ""}};
  const std::string html = page(comparisons, {}, "foredraw 1");
  EXPECT_LT(html.size(), 8'000'000u);
  const auto holds = [&](const char* text) { return html.find(text) != std::string::npos; };  // it is too long to show
  EXPECT_TRUE(holds("all 4999 files"));
  EXPECT_TRUE(holds("Of 5000 files with messages the first 200 are shown here."));
  const std::string draws = html.substr(html.find("<section id=\"draws\">"));
  EXPECT_EQ(draws.substr(0, draws.find("</section>")).find("data-file=\"8\""), std::string::npos);
  const std::string begin = "id=\"file-figures\">";
  const std::size_t at = html.find(begin) + begin.size();
  const auto data = nlohmann::json::parse(html.substr(at, html.find("</script>", at) - at));
  ASSERT_EQ(data["files"].size(), 5000u);
  EXPECT_EQ(data["files"][4999], "library/set49/prop4999.glb");
  EXPECT_EQ(data["states"].size(), 3u);
  ASSERT_EQ(data["figures"].size(), 1u) << "those of groups are left out";
  EXPECT_EQ(data["figures"][0]["metric"], "acmr");
  EXPECT_EQ(data["figures"][0]["values"][0][4999], 3);
  EXPECT_EQ(data["figures"][0]["values"][1][4999], 1.5);
  EXPECT_EQ(data["figures"][0]["values"][2][4999], 714.286);
  EXPECT_TRUE(data["figures"][0]["values"][2][4000].is_null());
}

TEST(Page, OfHostileNamesInColumnsHasNoMarkup) {
  const std::vector<Comparison> comparisons(300, comparison_of(hostile));
  const std::string html = page(comparisons, {}, "");
  const std::string data = html.substr(html.find("id=\"file-figures\">") + 18);
  EXPECT_EQ(before(data, "</script>").find('<'), std::string::npos);
}

TEST(Page, OfNothingIsAPageAllTheSame) { EXPECT_TRUE(page({}, {}, "foredraw").ends_with("</html>\n")); }

TEST(PageBuffer, IsBase64AndHoldsEqualNumbersOnce) {
  PageBuffer buffer;
  const std::array<std::uint32_t, 2> a{0x03020100, 0x07060504};
  const std::array<std::uint32_t, 1> b{0xfffefdfc};
  EXPECT_EQ(buffer.add(std::span<const std::uint32_t>(a)), 0u);
  EXPECT_EQ(buffer.add(std::span<const std::uint32_t>(b)), 8u);
  EXPECT_EQ(buffer.add(std::span<const std::uint32_t>(a)), 0u);
  EXPECT_EQ(buffer.base64(), "AAECAwQFBgf8/f7/");
  EXPECT_EQ(PageBuffer().base64(), "");
  PageBuffer one;
  one.add(std::span<const std::uint32_t>(b));
  EXPECT_EQ(one.base64(), "/P3+/w==");
}

}  // namespace
}  // namespace foredraw::page_test
