// The example engine walks round a character and draws what the table says; and what else tells of orders.

#include <foredraw/draw_orders/draw_orders_product.h>
#include <foredraw/draw_orders/order_memory.h>
#include <foredraw/io/text/extension_text.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/scene/reorder.h>

#include "support/edit_product.h"
#include "support/meshes.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace foredraw::character_orders_test {
namespace {

using testing::content;
using testing::put;

/// Two draws with three orders, and a table of two clips; one has a name that looks like something else.
Scene character() {
  std::vector<Draw> draws;
  for (const char* name : {"body", "head"}) {
    Draw draw = testing::draw_of(testing::grid(2, 1), name);
    const IndexStream first = draw.levels[0].orders[0];
    draw.levels[0].orders.push_back(with_triangle_order(first, std::vector<std::uint32_t>{3, 2, 1, 0}));
    draw.levels[0].orders.push_back(with_triangle_order(first, std::vector<std::uint32_t>{2, 0, 3, 1}));
    draws.push_back(std::move(draw));
  }
  Scene scene = testing::scene_of(std::move(draws));
  OrderTable table{{0, 1}, {{"\"times\":[9]", {0, 0.5f}}, {"Walk", {1, 2, 4}}}, 4, 6, {}};
  for (std::size_t cell = 0; cell < table.cells(); ++cell) table.order.push_back(cell * 7 % 5 % 3);
  testing::edit<DrawOrders>(scene)->tables = {table};
  return scene;
}

class CharacterOrders : public testing::InFolder {
 protected:
  std::string walk(const std::string& arguments) {
    const std::string out = (folder_ / "out").string();
    const std::string command =
        std::string("'") + FOREDRAW_CHARACTER_ORDERS + "' " + arguments + " > '" + out + "' 2>&1";
    code_ = std::system(command.c_str());
    return content(out);
  }
  int code_ = 0;
};

/// The numbers in every line of the walk that looks like this.
std::vector<std::vector<double>> found(const std::string& told, const std::string& line) {
  std::vector<std::vector<double>> numbers;
  const std::regex pattern(line);
  for (std::sregex_iterator at(told.begin(), told.end(), pattern); at != std::sregex_iterator(); ++at) {
    numbers.emplace_back();
    for (std::size_t i = 1; i < at->size(); ++i) numbers.back().push_back(std::stod((*at)[i]));
  }
  return numbers;
}

/// From frames of its own, looked up by the C header: the same overdraw as the evaluator's.
TEST_F(CharacterOrders, DrawWhatTheReportPromised) {
  for (const std::string model : {"fox", "cesium_man_notex"}) {
    const std::string file = testing::project_file("benchmarks/corpus/animated/" + model + ".glb").string();
    const testing::Ended made =
        testing::run_program(folder_, "optimize '" + file + "' -o out.glb --pipeline @character --report r.json");
    ASSERT_EQ(made.code, 0) << made.err;
    const nlohmann::json report = nlohmann::json::parse(content(folder_ / "r.json"));
    const nlohmann::json& ratio = report["totals"]["metrics"]["overdraw-raster"]["ratio"];

    const std::string told = walk("'" + (folder_ / "out.glb").string() + "' 100");
    ASSERT_EQ(code_, 0) << told;
    const auto frames =
        found(told, R"(clip \d+, .*: order (\d+), ([\d.]+) fragments per pixel, ([\d.]+) with order 0)");
    const auto whole = found(told, R"(the whole walk: ([\d.]+) fragments per pixel, ([\d.]+) with order 0)");
    ASSERT_EQ(whole.size(), 1u) << told;
    EXPECT_EQ(frames.size() % 100, 0u);
    std::set<double> orders;
    for (const auto& frame : frames) {
      orders.insert(frame[0]);
      if (frame[0] > 0) continue;
      EXPECT_EQ(frame[1], frame[2]);
    }
    EXPECT_EQ(orders.size(), 5u);
    EXPECT_NEAR(whole[0][0], ratio["value"].get<double>(), 0.001) << model;
    EXPECT_GT(whole[0][1], whole[0][0] + 0.02) << model;
  }
}

/// A character of many draws: its parts come in the sequence that belongs to the order.
TEST_F(CharacterOrders, DrawTheirPartsInTheSequenceOfTheTable) {
  const std::string file = testing::project_file("benchmarks/corpus/animated/robot_expressive.glb").string();
  const testing::Ended made = testing::run_program(
      folder_, "optimize '" + file + "' -o out.glb -p 'lookahead(quality=fast), occlusion-order(k=3)' --report r.json");
  ASSERT_EQ(made.code, 0) << made.err;
  const nlohmann::json report = nlohmann::json::parse(content(folder_ / "r.json"));
  const double promised = report["totals"]["metrics"]["overdraw-raster"]["ratio"]["value"];
  const std::string told = walk("'" + (folder_ / "out.glb").string() + "' 30");
  ASSERT_EQ(code_, 0) << told;
  const auto whole = found(told, R"(the whole walk: ([\d.]+) fragments per pixel, ([\d.]+) with order 0)");
  ASSERT_EQ(whole.size(), 1u) << told;
  EXPECT_NEAR(whole[0][0], promised, 0.01);
  EXPECT_GT(whole[0][1], whole[0][0] + 0.08) << "order 0 as the file has it";
}

TEST_F(CharacterOrders, RefusesWhatHasNoTable) {
  EXPECT_NE(walk("'" + testing::project_file("benchmarks/corpus/animated/fox.glb").string() + "'").find("no table"),
            std::string::npos);
  EXPECT_NE(code_, 0);
  EXPECT_NE(walk("absent.glb").find("absent.glb"), std::string::npos);
  EXPECT_NE(code_, 0);
  walk("");
  EXPECT_NE(code_, 0);
}

TEST(DrawOrdersJson, OrdersAreToldByTheTrianglesOfTheFirst) {
  const nlohmann::json json = nlohmann::json::parse(json_text(draw_orders_value(character())));
  EXPECT_EQ(json["draw-orders"], 1);
  const nlohmann::json& table = json["tables"][0];
  EXPECT_EQ(table["theta-steps"], 4);
  EXPECT_EQ(table["phi-steps"], 6);
  EXPECT_EQ(table["order"].size(), 5u * 4 * 6);
  EXPECT_EQ(table["clips"][1], nlohmann::json::parse(R"({"name": "Walk", "times": [1.0, 2.0, 4.0]})"));
  EXPECT_EQ(
      table["draws"][1],
      nlohmann::json::parse(
          R"({"name": "head", "mesh": 1, "primitive": 0, "orders": [[0, 1, 2, 3], [3, 2, 1, 0], [2, 0, 3, 1]]})"));
}

TEST(DrawOrdersJson, SequencesAreToldByTheNumbersOfParts) {
  Scene scene = character();
  EXPECT_FALSE(nlohmann::json::parse(json_text(draw_orders_value(scene)))["tables"][0].contains("parts"));
  OrderTable& table = testing::edit<DrawOrders>(scene)->tables[0];
  table.parts = {{0, 0}, {1, 1}};
  table.sequences = {0, 1, 1, 0, 0, 1};
  const nlohmann::json json = nlohmann::json::parse(json_text(draw_orders_value(scene)));
  EXPECT_EQ(json["tables"][0]["sequences"], nlohmann::json::parse("[[0, 1], [1, 0], [0, 1]]"));
  EXPECT_EQ(json["tables"][0]["parts"], nlohmann::json::parse(R"([{"name": "body", "node": 0, "primitive": 0},
                                                                  {"name": "head", "node": 1, "primitive": 0}])"));
}

TEST(DrawOrders, MemoryIsToldAgainstAnOrderForEachKeyframe) {
  Scene scene = character();
  const OrderMemory memory = memory_of(scene, order_tables(scene)[0]);
  EXPECT_EQ(memory.orders, 3u);
  EXPECT_EQ(memory.triangles, 8u);
  EXPECT_EQ(memory.bytes, 3u * 8 * 3 * 2);
  EXPECT_EQ(memory.bytes_for_each_keyframe, 5u * 8 * 3 * 2);
  EXPECT_EQ(memory_text(memory, 5),
            "3 orders of 8 triangles: 144 bytes; one for each of 5 keyframes would take 240 bytes");
  scene.draws[0] = testing::draw_of(testing::grid(300, 300), "large");
  testing::edit<DrawOrders>(scene)->tables = {{{0}, {}, 1, 1, {0}}};
  EXPECT_EQ(memory_text(memory_of(scene, order_tables(scene)[0]), 1), "1 order of 180,000 triangles: 2.2 MB");
}

}  // namespace
}  // namespace foredraw::character_orders_test
