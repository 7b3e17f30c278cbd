#include <foredraw/frames/rendering_costs.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace foredraw::rendering_costs_test {
namespace {

RenderingCosts made_up(Stages stages) {
  RenderingCosts costs;
  costs.machine = "made up";
  costs.stages = stages;
  costs.of(Rendering::full) = {2, 1, 0.5};
  costs.of(Rendering::without_normal_map) = {2, 1, 0.25};
  costs.of(Rendering::unlit) = {1, 0.75, 0.1};
  costs.frame = 1000;
  costs.draw = 10;
  return costs;
}

TEST(RenderingCosts, TheSlowerStageCountsOrBoth) {
  const ObjectWork triangles{Rendering::full, 100, 60, 400}, pixels{Rendering::full, 100, 60, 4000};
  EXPECT_DOUBLE_EQ(object_cost(made_up(Stages::max), triangles), 10 + 260);
  EXPECT_DOUBLE_EQ(object_cost(made_up(Stages::max), pixels), 10 + 2000);
  EXPECT_DOUBLE_EQ(object_cost(made_up(Stages::sum), triangles), 10 + 460);
  EXPECT_DOUBLE_EQ(object_cost(made_up(Stages::max), {Rendering::unlit, 100, 60, 0, 3}), 30 + 145);
  RenderingCosts costs = made_up(Stages::sum);
  costs.posed = 4;
  EXPECT_DOUBLE_EQ(object_cost(costs, {Rendering::full, 100, 60, 400, 1, 30}), 10 + 460 + 120);
  EXPECT_DOUBLE_EQ(object_cost(costs, {Rendering::full, 0, 0, 400}), 10 + 200);
}

/// The slower stage of each object, and not of the frame: that would be 1000 + 20 + 2200.
TEST(RenderingCosts, OfAFrameAreThoseOfItsObjects) {
  const std::vector<ObjectWork> objects = {{Rendering::full, 100, 60, 400}, {Rendering::full, 100, 60, 4000}};
  EXPECT_DOUBLE_EQ(frame_cost(made_up(Stages::max), objects), 1000 + 20 + 260 + 2000);
  EXPECT_DOUBLE_EQ(frame_cost(made_up(Stages::max), {}), 1000);
}

RenderingCosts read(const std::string& text) {
  const auto costs = costs_in(text, "costs.txt");
  if (const auto* why = std::get_if<std::string>(&costs)) ADD_FAILURE() << *why;
  return std::holds_alternative<std::string>(costs) ? RenderingCosts() : std::get<RenderingCosts>(costs);
}

TEST(RenderingCosts, ComeBackFromTheirTextToTheBit) {
  RenderingCosts costs = made_up(Stages::sum);
  costs.of(Rendering::unlit) = {1.0 / 3, 1e-300, 1e9};
  costs.frame = 123456.789;
  costs.posed = 7.1;
  EXPECT_EQ(read(costs_text(costs)), costs);
  EXPECT_EQ(read(costs_text(example_costs())), example_costs());
  costs.machine = " two\nlines # and more ";
  EXPECT_EQ(read(costs_text(costs)).machine, "two lines   and more");
  costs.machine.clear();
  EXPECT_EQ(read(costs_text(costs)).machine, "");
}

constexpr const char* by_hand =
    "# by hand\r\n\r\nunlit 1 0.75 0.1 # cheap\r\n  machine made up\nstages max\nframe 1e3\ndraw 10\n"
    "without-normal-map 2 1 .25\nfull 2 1 0.5";

TEST(RenderingCosts, AreReadInAnySequence) { EXPECT_EQ(read(by_hand), made_up(Stages::max)); }

std::string complaint_about(const std::string& text) {
  const auto costs = costs_in(text, "costs.txt");
  const auto* why = std::get_if<std::string>(&costs);
  return why == nullptr ? "none" : *why;
}

TEST(RenderingCosts, MistakesNameTheLineAndWhatWasExpected) {
  const std::string numbers = " with numbers from 0 to 1e9, but found ";
  EXPECT_EQ(complaint_about("stages max\nfull 1 2\n"),
            "costs.txt:2: expected 'full TRIANGLE VERTEX PIXEL'" + numbers + "'full 1 2'");
  EXPECT_EQ(complaint_about("stages min"),
            "costs.txt:1: expected 'stages max' or 'stages sum', but found 'stages min'");
  EXPECT_EQ(complaint_about("stages max sum"),
            "costs.txt:1: expected 'stages max' or 'stages sum', but found 'stages max sum'");
  EXPECT_EQ(complaint_about("machine # mine"), "costs.txt:1: expected 'machine NAME', but found 'machine   mine'");
  EXPECT_EQ(complaint_about("\nlit 1 2 3"),
            "costs.txt:2: expected one of draw, frame, full, machine, posed, stages, unlit, without-normal-map, but "
            "found 'lit "
            "1 2 3'");
  for (const char* number : {"-1", "nan", "inf", "1e10", "1e999", "one", "0x1", "1,5", "1 2"}) {
    EXPECT_EQ(complaint_about(std::string("frame ") + number),
              "costs.txt:1: expected 'frame NANOSECONDS'" + numbers + "'frame " + number + "'");
  }
  EXPECT_EQ(complaint_about("draw 1\n\ndraw 2"), "costs.txt:3: 'draw' is there already, in line 1");
  EXPECT_EQ(complaint_about("draw 1\nframe 2\nstages sum\nfull 1 1 1\nunlit 1 1 1"),
            "costs.txt: it has no line 'without-normal-map TRIANGLE VERTEX PIXEL'");
  EXPECT_EQ(complaint_about(""), "costs.txt: it has no line 'draw NANOSECONDS'");
  EXPECT_EQ(complaint_about(std::string(100'000, '\n')), "costs.txt: it is too long for a file of costs");
  EXPECT_EQ(complaint_about(std::string("draw \x01\xff\0 1", 10)).find('\x01'), std::string::npos);
}

TEST(RenderingCosts, OfAFileAreThoseOfItsText) {
  const testing::TestFolder folder;
  const std::string path = folder.path() / "costs.txt";
  std::ofstream(path, std::ios::binary) << by_hand;
  EXPECT_EQ(std::get<RenderingCosts>(read_costs(path)), made_up(Stages::max));
  EXPECT_EQ(std::get<std::string>(read_costs("nowhere/costs.txt")).find("nowhere/costs.txt: there is no such file"),
            0u);
  EXPECT_TRUE(std::holds_alternative<std::string>(read_costs(folder.path().string()))) << "a folder is no file";
}

TEST(RenderingCosts, ARenderingIsCalledAsInTheFile) {
  EXPECT_EQ(to_text(Rendering::full), "full");
  EXPECT_EQ(to_text(Rendering::without_normal_map), "without-normal-map");
  EXPECT_EQ(to_text(Rendering::unlit), "unlit");
}

}  // namespace
}  // namespace foredraw::rendering_costs_test
