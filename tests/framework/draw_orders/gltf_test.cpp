// FOREDRAW_draw_orders: from a scene to a file and back, and what is made of files in which it is wrong.

#include "files_with_orders.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

namespace foredraw::gltf_test {
namespace {

using namespace testing;

constexpr const char* name = draw_orders_extension;

TEST(GltfDrawOrders, come_back_as_they_were) {
  const Scene scene = puppet_with_orders();
  const Bytes file = write(scene);
  const Scene again = read(file);
  expect_same_orders(again, scene);
  EXPECT_EQ(write(again), file) << "what nobody changed comes out as it was";
  EXPECT_FALSE(again.draws[0].traits.has(traits::extended)) << "stages know what to do with these";
  const GltfJson json = json_of(file);
  EXPECT_EQ(json["extensionsUsed"], GltfJson::array({name}));
  EXPECT_FALSE(json.contains("extensionsRequired"));
  EXPECT_EQ(json["extensions"][name]["tables"][0]["primitives"], GltfJson::parse("[[0, 0]]"));
}

TEST(GltfDrawOrders, made_scene_comes_back_too) {
  Scene scene = scene_of({draw_of(torus(8, 6), "ring"), draw_of(soup(5, 1), "soup")});
  for (Draw& draw : scene.draws) add_orders(draw);
  scene.products.set(DrawOrders{{{{0}, {}, 1, 2, {2, 1}}, {{1}, {}, 1, 1, {0}}}});
  const Bytes file = write(scene);
  expect_same_orders(read(file), scene);
  EXPECT_TRUE(json_of(file)["meshes"][1]["primitives"][0].contains("indices"));
}

TEST(GltfDrawOrders, without_a_table_stay_orders) {
  Scene scene = puppet_with_orders();
  scene.products.set(DrawOrders{});
  const Bytes file = write(scene);
  expect_same_orders(read(file), scene);
  EXPECT_FALSE(json_of(file).contains("extensions"));
}

TEST(GltfDrawOrders, strips_become_lists) {
  GltfBuilder builder = ribbon(3);
  GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["indices"] = builder.add_values(std::vector<std::uint16_t>{0, 1, 2, 3, 4}, "SCALAR");
  primitive["mode"] = 5;
  Scene scene = read(builder);
  add_orders(scene.draws[0]);
  scene.products.set(DrawOrders{});
  expect_same_orders(read(write(scene)), scene);
}

TEST(GltfDrawOrders, vertices_that_move_are_renumbered_in_all) {
  Scene scene = read(write(puppet_with_orders()));
  reverse_vertices(scene, 0);
  const Bytes file = write(scene);
  expect_same_orders(read(file), scene);
  EXPECT_EQ(json_of(file)["accessors"].size(), json_of(write(puppet_with_orders()))["accessors"].size())
      << "accessors take the new indices on in place";
}

TEST(GltfDrawOrders, are_gone_where_the_scene_has_none_any_more) {
  Scene scene = read(write(puppet_with_orders()));
  const std::size_t with_orders = write(scene).size();
  for (Draw& draw : scene.draws) {
    draw.levels[0].orders.resize(1);
    reverse(draw);
  }
  scene.products.erase(DrawOrders::product);
  const Bytes file = write(scene);
  EXPECT_FALSE(json_of(file).contains("extensions"));
  EXPECT_FALSE(json_of(file).contains("extensionsUsed"));
  EXPECT_EQ(json_of(file).dump().find(name), std::string::npos);
  EXPECT_LT(file.size(), with_orders);
  expect_same_orders(read(file), scene);
}

TEST(GltfDrawOrders, other_tables_take_the_place_of_those_there_were) {
  Scene scene = read(write(puppet_with_orders()));
  OrderTable table = tables_of(scene)[0];
  table.order.assign(18, 2);
  table.clips[0].times = {0, 1, 7};
  scene.products.set(DrawOrders{{table}});
  const Bytes file = write(scene);
  expect_same_orders(read(file), scene);
  EXPECT_EQ(json_of(file)["extensions"][name]["tables"].size(), 1u);
}

TEST(GltfDrawOrders, times_of_an_animation_stay_its_own) {
  GltfBuilder builder = opened(write(puppet_with_orders()));
  GltfJson& clip = builder.json["extensions"][name]["tables"][0]["clips"][0];
  const Scene before = read(builder);
  std::size_t input = builder.json["animations"][0]["samplers"][0]["input"];
  const std::size_t keys = builder.json["accessors"][input]["count"];
  clip["times"] = input;
  builder.json["extensions"][name]["tables"][0]["order"] =
      builder.add_values(std::vector<std::uint8_t>(keys * 6, 1), "SCALAR");
  Scene scene = read(builder);
  ASSERT_EQ(tables_of(scene).size(), 1u);
  scene.products.set(DrawOrders{});
  const Scene again = read(write(scene));
  EXPECT_EQ(again.animations[0].channels[0].times, before.animations[0].channels[0].times);
}

TEST(GltfDrawOrders, come_through_compressed_files) {
  const Scene scene = puppet_with_orders();
  const GltfBuilder plain = builder_of(write(scene));
  for (const bool triangles : {true, false}) {
    CompressionChoice choice;
    choice.triangles = triangles;
    const Scene read_back = read(compressed(plain, choice));
    ASSERT_EQ(tables_of(read_back), tables_of(scene));
    for (std::size_t i = 0; i < 3; ++i) {  // the codec may turn corners
      const auto now = read_back.draws[0].levels[0].orders[i].indices.view();
      const auto wanted = scene.draws[0].levels[0].orders[i].indices.view();
      const auto order = order_between(wanted, now);
      ASSERT_TRUE(order);
      EXPECT_TRUE(std::ranges::is_sorted(*order));
    }
    Scene changed = read_back;
    reverse_vertices(changed, 0);
    OrderTable table = tables_of(changed)[0];
    table.order[0] = 2;
    changed.products.set(DrawOrders{{table}});
    const Scene again = read(write(changed));
    EXPECT_EQ(tables_of(again), tables_of(changed));
    ASSERT_EQ(again.draws[0].levels[0].orders.size(), 3u);
  }
}

TEST(GltfDrawOrders, draws_that_share_accessors_have_orders_of_their_own) {
  Scene scene = read(sharing());
  add_orders(scene.draws[1]);
  scene.products.set(DrawOrders{{{{1}, {}, 1, 1, {2}}}});
  const Scene again = read(write(scene));
  expect_same_orders(again, scene);
  Scene moved = again;
  reverse_vertices(moved, 0);
  expect_same_orders(read(write(moved)), moved);
}

struct Wrong {
  const char* name;
  std::function<void(GltfBuilder&, GltfJson& primitive, GltfJson& table)> make;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongDrawOrders : public ::testing::TestWithParam<Wrong> {};

/// The file is read without them, a warning says so, and nothing of them is written again.
TEST_P(WrongDrawOrders, are_left_out_with_a_warning) {
  GltfBuilder builder = opened(write(puppet_with_orders()));
  GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
  ASSERT_TRUE(read(builder).draws[0].levels[0].orders.size() == 3);
  GetParam().make(builder, primitive["extensions"][name], builder.json["extensions"][name]["tables"][0]);
  Diagnostics diagnostics;
  auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "draw-orders-left-out");
  EXPECT_EQ(scene->draws[0].levels[0].orders.size(), 1u);
  EXPECT_TRUE(tables_of(*scene).empty());
  reverse(scene->draws[0]);
  EXPECT_EQ(written(*scene).dump().find(name), std::string::npos);
}

constexpr std::uint64_t far_away = 1ull << 40;

INSTANTIATE_TEST_SUITE_P(
    Every, WrongDrawOrders,
    ::testing::Values(
        Wrong{"no_object", [](auto&, auto& own, auto&) { own = 3; }},
        Wrong{"no_orders", [](auto&, auto& own, auto&) { own.erase("orders"); }},
        Wrong{"empty_orders", [](auto&, auto& own, auto&) { own["orders"] = GltfJson::array(); }},
        Wrong{"too_many_orders",
              [](auto&, auto& own, auto&) { own["orders"] = std::vector<std::size_t>(300, own["orders"][0]); }},
        Wrong{"order_is_text", [](auto&, auto& own, auto&) { own["orders"][0] = "1"; }},
        Wrong{"order_is_negative", [](auto&, auto& own, auto&) { own["orders"][0] = -1; }},
        Wrong{"order_is_beyond", [](auto&, auto& own, auto&) { own["orders"][1] = far_away; }},
        Wrong{"order_is_positions",
              [](auto& builder, auto& own, auto&) {
                own["orders"][0] = builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
              }},
        Wrong{"order_is_short",
              [](auto& builder, auto& own, auto&) {
                own["orders"][0] = builder.add_values(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
              }},
        Wrong{"order_is_beyond_vertices",
              [](auto& builder, auto& own, auto&) {
                const std::size_t count = builder.json["accessors"][own["orders"][0].template get<std::size_t>()]["count"];
                own["orders"][0] = builder.add_values(std::vector<std::uint16_t>(count, 40000), "SCALAR");
              }},
        Wrong{"order_draws_others",
              [](auto& builder, auto& own, auto&) {
                const std::size_t count = builder.json["accessors"][own["orders"][0].template get<std::size_t>()]["count"];
                own["orders"][0] = builder.add_values(std::vector<std::uint16_t>(count, 1), "SCALAR");
              }},
        Wrong{"primitive_is_a_strip",
              [](auto& builder, auto&, auto&) { builder.json["meshes"][0]["primitives"][0]["mode"] = 5; }},
        Wrong{"no_tables", [](auto& builder, auto&, auto&) { builder.json["extensions"][name].erase("tables"); }},
        Wrong{"table_is_text", [](auto&, auto&, auto& table) { table = "table"; }},
        Wrong{"no_primitives", [](auto&, auto&, auto& table) { table.erase("primitives"); }},
        Wrong{"primitive_is_beyond", [](auto&, auto&, auto& table) { table["primitives"][0] = {0, 9}; }},
        Wrong{"mesh_is_beyond", [](auto&, auto&, auto& table) { table["primitives"][0] = {far_away, 0}; }},
        Wrong{"primitive_is_no_pair", [](auto&, auto&, auto& table) { table["primitives"][0] = {0}; }},
        Wrong{"primitive_twice",
              [](auto&, auto&, auto& table) { table["primitives"] = GltfJson::parse("[[0, 0], [0, 0]]"); }},
        Wrong{"two_tables_of_one",
              [](auto& builder, auto&, auto& table) {
                const GltfJson copy = table;
                builder.json["extensions"][name]["tables"] = {copy, copy};
              }},
        Wrong{"animation_is_beyond", [](auto&, auto&, auto& table) { table["clips"][0]["animation"] = 7; }},
        Wrong{"animation_twice",
              [](auto&, auto&, auto& table) {
                const GltfJson clip = table["clips"][0];
                table["clips"] = {clip, clip};
              }},
        Wrong{"clips_are_a_number", [](auto&, auto&, auto& table) { table["clips"] = 1; }},
        Wrong{"times_are_bytes", [](auto&, auto&, auto& table) { table["clips"][0]["times"] = table["order"]; }},
        Wrong{"times_fall",
              [](auto& builder, auto&, auto& table) {
                table["clips"][0]["times"] = builder.add_values(std::vector<float>{0, 2, 1}, "SCALAR");
              }},
        Wrong{"no_steps", [](auto&, auto&, auto& table) { table.erase("phiSteps"); }},
        Wrong{"steps_are_zero", [](auto&, auto&, auto& table) { table["thetaSteps"] = 0; }},
        Wrong{"steps_are_many", [](auto&, auto&, auto& table) { table["thetaSteps"] = far_away; }},
        Wrong{"cells_do_not_match", [](auto&, auto&, auto& table) { table["phiSteps"] = 4; }},
        Wrong{"cells_are_floats",
              [](auto& builder, auto&, auto& table) {
                table["order"] = builder.add_values(std::vector<float>(18, 0), "SCALAR");
              }},
        Wrong{"cells_are_beyond", [](auto&, auto&, auto& table) { table["order"] = far_away; }},
        Wrong{"cell_names_no_order",
              [](auto& builder, auto&, auto& table) {
                table["order"] = builder.add_values(std::vector<std::uint8_t>(18, 3), "SCALAR");
              }},
        Wrong{"primitive_lacks_orders",
              [](auto&, auto& own, auto&) { own["orders"].erase(own["orders"].size() - 1); }}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(GltfDrawOrders, few_bytes_may_not_claim_many_indices) {
  GltfBuilder builder = ribbon(20000);
  GltfJson& primitives = builder.json["meshes"][0]["primitives"];
  primitives[0]["extensions"][name]["orders"] = std::vector<std::size_t>(200, primitives[0]["indices"]);
  const GltfJson one = primitives[0];
  for (int i = 0; i < 200; ++i) primitives.push_back(one);
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(scene);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "draw-orders-left-out");
}

/// What is written has the members that the schemas tell of, and all that they require.
TEST(GltfDrawOrders, what_is_written_fits_the_schemas) {
  const GltfJson json = written(puppet_with_orders());
  const auto schema = [](const std::string& of) {
    std::ifstream file(
        project_file("framework/foredraw/draw_orders/schemas/" + of + ".FOREDRAW_draw_orders.schema.json"));
    return GltfJson::parse(file);
  };
  const std::function<void(const GltfJson&, const GltfJson&)> expect_fits = [&](const GltfJson& value,
                                                                                const GltfJson& rule) {
    const std::string type = rule["type"];
    EXPECT_EQ(type, value.is_object() ? "object" : value.is_array() ? "array" : "integer") << value;
    if (value.is_object()) {
      for (const auto& [key, held] : value.items()) {
        ASSERT_TRUE(rule["properties"].contains(key)) << key;
        expect_fits(held, rule["properties"][key]);
      }
      for (const GltfJson& key : rule["required"]) EXPECT_TRUE(value.contains(key.get<std::string>())) << key;
    }
    if (value.is_array()) {
      EXPECT_GE(value.size(), rule.value("minItems", 0u));
      for (const GltfJson& held : value) expect_fits(held, rule["items"]);
    }
  };
  expect_fits(json["meshes"][0]["primitives"][0]["extensions"][name], schema("mesh.primitive"));
  expect_fits(json["extensions"][name], schema("glTF"));
  expect_fits(written(two_in_sequence())["extensions"][name], schema("glTF"));
}

}  // namespace
}  // namespace foredraw::gltf_test
