#include <foredraw/technique/attachment.h>

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace foredraw::attachment_test {
namespace {

Film film(std::size_t frames = 2) {
  Film film{"levels", "the lighter, the finer", 2, 1, {}};
  for (std::size_t i = 0; i < frames; ++i) film.frames.push_back({1, 1, 1, 2, 2, 2});
  return film;
}

Chart chart() { return {"time", "", "frame", "time of a frame", "ms", {{"a", {1, 2, 3}}, {"b", {4, 5, 6}}}, {}}; }

template <class Shown, class Change>
std::string mistake_after(Shown shown, Change change) {
  change(shown);
  return mistake_in(shown).value_or("");
}

TEST(Attachment, OfAllThatItNeedsHasNoMistake) {
  EXPECT_EQ(mistake_in(film()), std::nullopt);
  EXPECT_EQ(mistake_in(film(1)), std::nullopt);
  Chart marked = chart();
  marked.mark = {"budget", 10};
  marked.lines[0].values[1] = std::numeric_limits<double>::quiet_NaN();
  marked.caption = marked.unit = "";
  EXPECT_EQ(mistake_in(marked), std::nullopt);
}

TEST(Attachment, KnowsItsNameAndItsFrames) {
  EXPECT_EQ(name_of(film()), "levels");
  EXPECT_EQ(name_of(chart()), "time");
  EXPECT_EQ(frames_of(film(5)), 5u);
  EXPECT_EQ(frames_of(chart()), 3u);
  EXPECT_EQ(frames_of(Chart()), 0u);
}

TEST(Attachment, OfPicturesThatAreNoneIsRefused) {
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.name = ""; }), "has no name");
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.frames.clear(); }), "has no frame");
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.frames[1].pop_back(); }),
            "has 5 bytes in frame 1, but 2 x 1 pixels are 6");
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.height = 2; }), "has 6 bytes in frame 0, but 2 x 2 pixels are 12");
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.width = 0; }),
            "has pictures of 0 x 1 pixels, but an edge has 1 to 4096");
  EXPECT_EQ(mistake_after(film(), [](Film& f) { f.height = largest_picture + 1; }),
            "has pictures of 2 x 4097 pixels, but an edge has 1 to 4096");
  Film line{"line", "", largest_picture, 1, {std::vector<std::uint8_t>(3 * largest_picture)}};
  EXPECT_EQ(mistake_in(line), std::nullopt);
}

TEST(Attachment, OfLinesThatAreNoneIsRefused) {
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.name = ""; }), "has no name");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.lines.clear(); }), "has no value");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.lines[0].values.clear(); }), "has no value");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.lines[1].values.pop_back(); }),
            "has 3 values in one line, but 2 in 'b'");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.lines[1].name = "a"; }), "has two lines 'a'");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.lines[1].name = ""; }), "has a line without a name");
  EXPECT_EQ(mistake_after(chart(),
                          [](Chart& c) {
                            c.mark = {"budget", std::numeric_limits<double>::infinity()};
                          }),
            "has a mark that is not finite");
  EXPECT_EQ(mistake_after(chart(), [](Chart& c) { c.mark = {"", 1}; }), "has a mark without a name");
}

TEST(Attachment, IsFoundWhereItWasAttached) {
  testing::RunFixture fixture;
  fixture.run.attach(film());
  fixture.run.attach_at({.draw = 1, .subject = {}}, film());
  fixture.run.attach(chart());
  const std::vector<Attached>& attached = fixture.findings.attached;
  ASSERT_EQ(attached.size(), 3u);
  EXPECT_EQ(attached[0].about, About{});
  EXPECT_EQ(attached[1].about.draw, 1u);
  EXPECT_EQ(std::get<Film>(*attached[1].content).frames, film().frames);
  EXPECT_EQ(std::get<Chart>(*attached[2].content).lines[1].values, (std::vector<double>{4, 5, 6}));
}

TEST(Attachment, OfOneNameIsAttachedOnceToOneThing) {
  testing::RunFixture fixture;
  fixture.run.attach(film());
  Chart of_that_name = chart();
  of_that_name.name = "levels";
  try {
    fixture.run.attach(of_that_name);
    ADD_FAILURE() << "it was attached";
  } catch (const std::invalid_argument& problem) {
    EXPECT_STREQ(problem.what(), "its attachment 'levels' is attached twice");
  }
  EXPECT_THROW(fixture.run.attach(film(0)), std::invalid_argument);
  EXPECT_EQ(fixture.findings.attached.size(), 1u);
}

}  // namespace
}  // namespace foredraw::attachment_test
