// The example engine walks round a character and draws what the table says.

#include <foredraw/analysis/order_lookup.h>
#include <foredraw/report/draw_orders.h>
#include <foredraw/scene/reorder.h>

#include "support/meshes.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <set>

namespace foredraw {
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
  scene.order_tables = {table};
  return scene;
}

class CharacterOrders : public testing::InFolder {
 protected:
  std::string walk(const std::string& arguments) {
    const std::string out = (folder_ / "out").string();
    const std::string command = std::string("'") + FOREDRAW_CHARACTER_ORDERS + "' " + arguments + " > '" + out + "' 2>&1";
    code_ = std::system(command.c_str());
    return content(out);
  }
  int code_ = 0;
};

TEST_F(CharacterOrders, AreThoseOfTheTable) {
  const Scene scene = character();
  put(folder_ / "orders.json", draw_orders_json(scene));
  for (const AnimationId clip : {0u, 1u}) {
    const std::string told =
        walk("'" + (folder_ / "orders.json").string() + "' " + std::to_string(clip) + " 100");
    ASSERT_EQ(code_, 0) << told;
    const OrderLookup lookup(scene.order_tables[0], std::vector<std::string>{"\"times\":[9]", "Walk"});
    foredraw_order_state state = {};
    const std::regex line(R"(([0-9.]+) degrees, ([0-9.]+) s: order (\d)\n)");
    std::set<std::string> seen;
    int lines = 0;
    for (std::sregex_iterator at(told.begin(), told.end(), line); at != std::sregex_iterator(); ++at, ++lines) {
      const auto& times = scene.order_tables[0].clips[clip].times;
      const float part = static_cast<float>(lines) / 100;
      const float time = times.front() + part * (times.back() - times.front());
      const float towards_camera[3] = {std::cos(part * 6.28318531f), 0.3f, std::sin(part * 6.28318531f)};
      EXPECT_EQ((*at)[3], std::to_string(foredraw_order_at(&lookup.table(), clip, time, towards_camera, &state)));
      seen.insert((*at)[3]);
    }
    EXPECT_EQ(lines, 100) << told;
    EXPECT_EQ(seen.size(), 3u);
  }
}

TEST_F(CharacterOrders, RefusesWhatHasNoTable) {
  put(folder_ / "none.json", draw_orders_json(testing::scene_of(testing::grid(1, 1))));
  EXPECT_NE(walk("'" + (folder_ / "none.json").string() + "'").find("--draw-orders"), std::string::npos);
  EXPECT_NE(code_, 0);
  walk("absent.json");
  EXPECT_NE(code_, 0);
}

TEST(DrawOrdersJson, OrdersAreToldByTheTrianglesOfTheFirst) {
  const nlohmann::json json = nlohmann::json::parse(draw_orders_json(character()));
  EXPECT_EQ(json["draw-orders"], 1);
  const nlohmann::json& table = json["tables"][0];
  EXPECT_EQ(table["theta-steps"], 4);
  EXPECT_EQ(table["phi-steps"], 6);
  EXPECT_EQ(table["order"].size(), 5u * 4 * 6);
  EXPECT_EQ(table["clips"][1], nlohmann::json::parse(R"({"name": "Walk", "times": [1.0, 2.0, 4.0]})"));
  EXPECT_EQ(table["draws"][1],
            nlohmann::json::parse(
                R"({"name": "head", "mesh": 1, "primitive": 0, "orders": [[0, 1, 2, 3], [3, 2, 1, 0], [2, 0, 3, 1]]})"));
}

TEST(DrawOrders, MemoryIsToldAgainstAnOrderForEachKeyframe) {
  Scene scene = character();
  const OrderMemory memory = memory_of(scene, scene.order_tables[0]);
  EXPECT_EQ(memory.orders, 3u);
  EXPECT_EQ(memory.triangles, 8u);
  EXPECT_EQ(memory.bytes, 3u * 8 * 3 * 2);
  EXPECT_EQ(memory.bytes_for_each_keyframe, 5u * 8 * 3 * 2);
  EXPECT_EQ(memory_text(scene, scene.order_tables[0]),
            "3 orders of 8 triangles: 144 bytes; one for each of 5 keyframes would take 240 bytes");
  scene.draws[0] = testing::draw_of(testing::grid(300, 300), "large");
  scene.order_tables = {{{0}, {}, 1, 1, {0}}};
  EXPECT_EQ(memory_text(scene, scene.order_tables[0]), "1 order of 180000 triangles: 2.2 MB");
}

}  // namespace
}  // namespace foredraw
