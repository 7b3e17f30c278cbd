#include <foredraw/page/private/shown_attachments.h>

#include <foredraw/page/page.h>
#include <foredraw/page/private/page_assets.h>
#include <foredraw/page/private/page_buffer.h>

#include <foredraw/base/random.h>
#include <foredraw/io/image/picture.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foredraw::shown_attachments_test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A film of one grey pixel, which is as light as the frame's number and `first` say.
AttachmentRecord film(const std::string& name, std::size_t frames, std::uint8_t first = 0) {
  Film film{name, "", 1, 1, {}};
  for (std::size_t i = 0; i < frames; ++i) {
    film.frames.push_back(std::vector<std::uint8_t>(3, static_cast<std::uint8_t>(first + i)));
  }
  return {"", std::make_shared<const Attachment>(std::move(film))};
}

AttachmentRecord chart(const std::string& name, std::size_t frames) {
  Chart chart{name, "", "frame", "", "", {{"a", std::vector<double>(frames)}}, {}};
  return {"", std::make_shared<const Attachment>(std::move(chart))};
}

StageRecord record(const std::string& use, std::vector<AttachmentRecord> attachments,
                   std::vector<AttachmentRecord> before = {}) {
  StageRecord stage;
  stage.use = use;
  stage.attachments = std::move(attachments);
  stage.attachments_before = std::move(before);
  return stage;
}

Branch branch(std::vector<StageRecord> stages, std::vector<StageRecord> measures) {
  Branch branch{"pipeline", {}};
  branch.report.optimized = true;
  branch.report.stages = std::move(stages);
  branch.report.measures = std::move(measures);
  return branch;
}

Json groups_of(const ShownAttachments& shown) { return Json::parse(shown.json)["groups"]; }

/// [state] its place and the names of what was attached.
Json told(const Json& group) {
  Json states = Json::array();
  for (const Json& state : group["states"]) {
    Json names = Json::array();
    for (const Json& attachment : state["attachments"]) names.push_back(attachment["name"]);
    states.push_back({state["place"], names});
  }
  return states;
}

TEST(ShownAttachments, AreGroupedByTechniqueAndFramesThenByState) {
  Branch lost{"lost", {}, true};
  const Branch one = branch(
      {record("merge", {film("picture", 1)})},
      {record("walk", {chart("time", 3), film("levels", 3), film("whole", 1)}, {chart("time", 3), film("before", 3)})});
  const Branch other = branch({}, {record("walk", {chart("time", 3), film("longer", 4)}, {film("not again", 3)})});
  const Comparison comparison{{"a", 1}, {lost, one, other}, {}};
  const Json groups = groups_of(shown_attachments({&comparison, 1}));
  ASSERT_EQ(groups.size(), 4u);
  const auto head = [](const Json& group) { return Json{group["file"], group["use"], group["frames"]}; };
  EXPECT_EQ(head(groups[0]), (Json{0, "walk", 3}));
  EXPECT_EQ(told(groups[0]), Json::parse(R"([[0, ["time", "before"]], [2, ["time", "levels"]], [3, ["time"]]])"));
  EXPECT_EQ(head(groups[1]), (Json{0, "walk", 1}));
  EXPECT_EQ(told(groups[1]), Json::parse(R"([[2, ["whole"]]])"));
  EXPECT_EQ(head(groups[2]), (Json{0, "walk", 4}));
  EXPECT_EQ(told(groups[2]), Json::parse(R"([[3, ["longer"]]])"));
  EXPECT_EQ(head(groups[3]), (Json{0, "merge", 1}));
  EXPECT_EQ(told(groups[3]), Json::parse(R"([[2, ["picture"]]])"));
}

TEST(ShownAttachments, HoldEqualPicturesOnce) {
  const Branch one = branch({}, {record("walk", {film("first", 3), film("second", 3, 1), film("first again", 3)})});
  const Comparison comparison{{"a", 1}, {one, one}, {}};
  const ShownAttachments shown = shown_attachments({&comparison, 1});
  ASSERT_EQ(shown.pictures.size(), 4u);
  const Json states = groups_of(shown)[0]["states"];
  ASSERT_EQ(states.size(), 2u);
  for (const Json& state : states) {
    EXPECT_EQ(state["attachments"][0]["pictures"], Json({0, 1, 2}));
    EXPECT_EQ(state["attachments"][1]["pictures"], Json({1, 2, 3}));
    EXPECT_EQ(state["attachments"][2]["pictures"], Json({0, 1, 2}));
  }
  for (std::uint8_t grey = 0; grey < 4; ++grey) {
    EXPECT_EQ(shown.pictures[grey], base64(images::png_of_pixels(1, 1, std::vector<std::uint8_t>(3, grey))));
  }
}

/// Of the same bytes, but of another shape.
TEST(ShownAttachments, TellPicturesApartByTheirShape) {
  Film wide{"wide", "", 2, 1, {std::vector<std::uint8_t>(6, 9)}}, high{"high", "", 1, 2, wide.frames};
  const auto shared = [](const Film& f) { return AttachmentRecord{"", std::make_shared<const Attachment>(f)}; };
  const Comparison comparison{{"a", 1}, {branch({}, {record("walk", {shared(wide), shared(high)})})}, {}};
  EXPECT_EQ(shown_attachments({&comparison, 1}).pictures.size(), 2u);
}

TEST(ShownAttachments, WithoutPicturesAreToldAllTheSame) {
  Branch one = branch({}, {record("walk", {film("levels", 3), chart("time", 3)})});
  leave_out_pictures(one.report);
  const Comparison comparison{{"a", 1}, {one}, {}};
  const ShownAttachments shown = shown_attachments({&comparison, 1});
  EXPECT_TRUE(shown.pictures.empty());
  EXPECT_EQ(groups_of(shown)[0]["states"][0]["attachments"][0]["pictures"], Json::array());
  EXPECT_EQ(groups_of(shown)[0]["states"][0]["attachments"][0]["frames"], 3);
}

/// Noise does not become smaller by encoding: either of two films fits, but not both.
TEST(ShownAttachments, StayWithinThePage) {
  Random random(1);
  const auto noise = [&](const std::string& name) {
    Film film{name, "", 64, 64, {std::vector<std::uint8_t>(3 * 64 * 64)}};
    for (std::uint8_t& byte : film.frames[0]) byte = static_cast<std::uint8_t>(random.next());
    return AttachmentRecord{"", std::make_shared<const Attachment>(std::move(film))};
  };
  constexpr std::size_t most = std::size_t{3} * 64 * 64 * 4 / 3 + 1000;  // as base64
  const Branch one = branch({}, {record("walk", {noise("one"), film("small", 1), noise("two"), film("other", 1, 9)})});
  const Comparison comparison{{"a", 1}, {one}, {}};
  const ShownAttachments shown = shown_attachments({&comparison, 1}, most);
  std::size_t bytes = 0;
  for (const std::string& picture : shown.pictures) bytes += picture.size();
  EXPECT_LE(bytes, most);
  const Json attachments = groups_of(shown)[0]["states"][0]["attachments"];
  EXPECT_EQ(attachments[0]["pictures"], Json({0}));
  EXPECT_EQ(attachments[1]["pictures"], Json({1}));
  EXPECT_EQ(attachments[2]["pictures"], Json::array());
  EXPECT_EQ(attachments[3]["pictures"], Json({2}));
  const Json all = groups_of(shown_attachments({&comparison, 1}))[0]["states"][0]["attachments"];
  EXPECT_EQ(all[2]["pictures"], Json({2}));
}

TEST(ShownAttachments, OfTheFirstFilesAlone) {
  const Comparison comparison{{"a", 1}, {branch({}, {record("walk", {chart("time", 2)})})}, {}};
  const std::vector<Comparison> files(most_displays + 2, comparison);
  EXPECT_EQ(groups_of(shown_attachments(files)).size(), most_displays);
}

/// The page without its scripts, which nobody wants to read where a test fails.
std::string told_by(const Comparison& comparison) {
  const std::string html = page({&comparison, 1}, {}, "foredraw");
  return html.substr(0, html.find("<script"));
}

TEST(ShownAttachments, MakeASectionWhereThereAreAny) {
  Comparison comparison{{"a", 1}, {branch({}, {record("walk", {film("levels", 2)})})}, {}};
  EXPECT_THAT(told_by(comparison), HasSubstr("<section id=\"frames\">"));
  EXPECT_THAT(told_by(comparison), HasSubstr("href=\"#frames\""));
  comparison.branches[0].report.measures[0].attachments.clear();
  EXPECT_TRUE(shown_attachments({&comparison, 1}).json.empty());
  EXPECT_THAT(told_by(comparison), Not(HasSubstr("id=\"frames\"")));
}

TEST(ShownAttachments, AreDataThatNoNameEnds) {
  if (page_script().empty()) GTEST_SKIP() << "the page was built without its script";
  const Comparison comparison{{"a", 1}, {branch({}, {record("walk", {film("</script>", 2)})})}, {}};
  const std::string html = page({&comparison, 1}, {}, "foredraw");
  const auto content = [&](const std::string& id) {
    const std::size_t begin = html.find("id=\"" + id + "\">");
    if (begin == std::string::npos) return std::string("nothing");
    const std::size_t first = html.find('>', begin) + 1;
    return html.substr(first, html.find("</script>", first) - first);
  };
  EXPECT_EQ(Json::parse(content("attachments"))["groups"][0]["states"][0]["attachments"][0]["name"], "</script>");
  EXPECT_EQ(content("picture-1"), shown_attachments({&comparison, 1}).pictures[1]);
  EXPECT_EQ(content("picture-2"), "nothing");
}

}  // namespace
}  // namespace foredraw::shown_attachments_test
