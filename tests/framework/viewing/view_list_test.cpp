#include <foredraw/viewing/view_list.h>

#include <foredraw/viewing/view_set.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace foredraw::view_list_test {
namespace {

/// A file of this text, for as long as the test runs.
class ViewList : public ::testing::Test {
 protected:
  ViewSet set_of(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    ViewSet set;
    set.views = path_;
    return set;
  }

  static std::string why_none(const ViewSet& set) {
    const auto views = views_of(set);
    const auto* why = std::get_if<std::string>(&views);
    return why == nullptr ? "none" : *why;
  }

  std::string complaint_about(const std::string& text) const {
    const std::string complaint = why_none(set_of(text));
    return complaint.starts_with(path_) ? complaint.substr(path_.size()) : complaint;
  }

  const testing::TestFolder folder_;
  const std::string path_ = folder_.path() / "views.txt";
};

TEST_F(ViewList, directions_and_positions) {
  const ViewSet set =
      set_of("# from the front\r\ndirection 0 0 5\n\nposition 0 -3 0 2.5 # heavy\r\n  direction -1 0 0 0.5");
  const Views views = make_views(set);
  const std::vector<View> expected = {{{0, 0, 1}, 0, 1}, {{0, -1, 0}, 3, 2.5}, {{-1, 0, 0}, 0, 0.5}};
  EXPECT_EQ(views.views, expected);
}

TEST_F(ViewList, the_sets_distance_is_that_of_directions) {
  ViewSet set = set_of("direction 0 0 1\nposition 0 0 4\n");
  set.distance = 2;
  EXPECT_EQ(make_views(set).views[0].distance, 2);
  EXPECT_EQ(make_views(set).views[1].distance, 4);
}

TEST_F(ViewList, mistakes_name_the_line) {
  const std::string expected = "expected 'direction x y z [weight]' or 'position x y z [weight]', but found ";
  EXPECT_EQ(complaint_about("direction 0 0 1\ndirection 0 1\n"), ":2: " + expected + "'direction 0 1'");
  EXPECT_EQ(complaint_about("look 0 0 1"), ":1: " + expected + "'look 0 0 1'");
  EXPECT_EQ(complaint_about("direction 0 0 1 1 1"), ":1: " + expected + "'direction 0 0 1 1 1'");
  EXPECT_EQ(complaint_about("direction 0 0 one"), ":1: " + expected + "'direction 0 0 one'");
  EXPECT_EQ(complaint_about("direction 0 0 0"), ":1: the direction must be finite, and not 0 0 0");
  EXPECT_EQ(complaint_about("direction 0 0 1e300"), ":1: the direction must be finite, and not 0 0 0");
  EXPECT_EQ(complaint_about("direction 0 0 1 0"), ":1: the weight must be above 0");
  EXPECT_EQ(complaint_about("direction 0 0 1 -1"), ":1: the weight must be above 0");
  EXPECT_EQ(complaint_about("position 0 0 1"),
            ":1: the camera is 1.000000 bounding-sphere radii from the centre, but must be outside the sphere (at "
            "least 1.01)");
  EXPECT_EQ(complaint_about("# nothing\n"), ": it has no views; expected lines such as 'direction 0 0 1'");
}

TEST_F(ViewList, a_count_beside_a_file_is_refused) {
  ViewSet set = set_of("direction 0 0 1");
  set.count = 3;
  EXPECT_EQ(mistake_in(set), "views is the file " + path_ + ", which says how many there are; leave count out");
}

TEST_F(ViewList, a_file_that_is_not_there_is_told) {
  ViewSet set;
  set.views = "nowhere/cameras.txt";
  EXPECT_TRUE(why_none(set).starts_with("nowhere/cameras.txt: there is no such file"));
  EXPECT_THROW(make_views(set), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::view_list_test
