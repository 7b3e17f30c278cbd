// Sequences in FOREDRAW_draw_orders: from a scene to a file and back, and what is made of files in which they are
// wrong.

#include "files_with_orders.h"

#include <functional>

namespace foredraw::sequences_test {
namespace {

using namespace testing;

constexpr const char* name = draw_orders_extension;

TEST(GltfSequences, come_back_as_they_were) {
  const Scene scene = two_in_sequence();
  const Bytes file = write(scene);
  expect_same_orders(read(file), scene);
  EXPECT_EQ(write(read(file)), file);
  EXPECT_EQ(json_of(file)["extensions"][name]["tables"][0]["parts"],
            GltfJson::parse(R"([{"node": 0, "primitive": 0}, {"node": 1, "primitive": 0}])"));
}

TEST(GltfSequences, of_a_mesh_that_no_node_shows_name_it) {
  GltfBuilder builder = opened(write(two_in_sequence()));
  GltfJson& meshes = builder.json["meshes"];
  meshes[0]["primitives"].push_back(meshes[1]["primitives"][0]);
  meshes.erase(1);
  builder.json.erase("nodes");
  builder.json.erase("scenes");
  builder.json.erase("scene");
  GltfJson& table = builder.json["extensions"][name]["tables"][0];
  table["primitives"] = GltfJson::parse("[[0, 0], [0, 1]]");
  table["parts"] = GltfJson::parse(R"([{"mesh": 0, "primitive": 0}, {"mesh": 0, "primitive": 1}])");
  const Scene scene = read(builder);
  ASSERT_EQ(tables_of(scene).size(), 1u);
  EXPECT_EQ(tables_of(scene)[0].parts, (std::vector<SubjectPart>{{0, std::nullopt}, {1, std::nullopt}}));
  EXPECT_EQ(json_of(write(scene))["extensions"][name]["tables"][0]["parts"], table["parts"]);
}

TEST(GltfSequences, tables_without_sequences_say_nothing_of_them) {
  Scene scene = two_in_sequence();
  OrderTable table = tables_of(scene)[0];
  table.parts.clear();
  table.sequences.clear();
  scene.products.set(DrawOrders{{table}});
  const GltfJson said = json_of(write(scene))["extensions"][name]["tables"][0];
  EXPECT_FALSE(said.contains("parts"));
  EXPECT_FALSE(said.contains("sequences"));
}

/// The puppet's table with a part and its sequences: as it should be, or as `sequences` says.
void add_sequences(GltfBuilder& builder, GltfJson& table, const std::vector<std::uint16_t>& sequences = {0, 0, 0}) {
  std::size_t node = 0;
  while (!builder.json["nodes"][node].contains("mesh")) ++node;
  table["parts"] = {{{"node", node}, {"primitive", 0}}};
  table["sequences"] = builder.add_values(sequences, "SCALAR");
}

TEST(GltfSequences, of_a_single_part_have_a_sequence_too) {
  GltfBuilder builder = opened(write(puppet_with_orders()));
  add_sequences(builder, builder.json["extensions"][name]["tables"][0]);
  ASSERT_EQ(tables_of(read(builder)).size(), 1u);
  EXPECT_EQ(tables_of(read(builder))[0].sequences, (std::vector<std::uint16_t>{0, 0, 0}));
}

struct Wrong {
  const char* name;
  std::function<void(GltfBuilder&, GltfJson& table)> make;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongSequences : public ::testing::TestWithParam<Wrong> {};

/// The file is read without tables and their orders, a warning says so, and all else is there.
TEST_P(WrongSequences, are_left_out_with_a_warning) {
  GltfBuilder builder = opened(write(puppet_with_orders()));
  const Scene whole = read(builder);
  GltfJson& table = builder.json["extensions"][name]["tables"][0];
  add_sequences(builder, table);
  ASSERT_EQ(tables_of(read(builder)).size(), 1u);
  GetParam().make(builder, table);
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "draw-orders-left-out");
  EXPECT_TRUE(tables_of(*scene).empty());
  ASSERT_EQ(scene->draws.size(), whole.draws.size());
  EXPECT_EQ(scene->draws[0].levels[0].orders.size(), 1u);
  EXPECT_EQ(scene->draws[0].levels[0].orders[0].indices, whole.draws[0].levels[0].orders[0].indices);
  EXPECT_EQ(scene->animations.size(), whole.animations.size());
}

constexpr std::uint64_t far_away = 1ull << 40;

INSTANTIATE_TEST_SUITE_P(
    Every, WrongSequences,
    ::testing::Values(
        Wrong{"parts_without_sequences", [](auto&, auto& table) { table.erase("sequences"); }},
        Wrong{"sequences_without_parts", [](auto&, auto& table) { table.erase("parts"); }},
        Wrong{"parts_are_a_number", [](auto&, auto& table) { table["parts"] = 1; }},
        Wrong{"part_is_a_number", [](auto&, auto& table) { table["parts"][0] = 0; }},
        Wrong{"part_of_an_unknown_node", [](auto&, auto& table) { table["parts"][0]["node"] = far_away; }},
        Wrong{"part_of_an_unknown_primitive", [](auto&, auto& table) { table["parts"][0]["primitive"] = 9; }},
        Wrong{"part_of_an_unknown_mesh",
              [](auto&, auto& table) {
                table["parts"][0] = {{"mesh", 9}, {"primitive", 0}};
              }},
        Wrong{"part_twice",
              [](auto& builder, auto& table) {
                add_sequences(builder, table, {0, 1, 0, 1, 0, 1});
                table["parts"].push_back(GltfJson(table["parts"][0]));
              }},
        Wrong{"sequences_are_bytes",
              [](auto& builder, auto& table) {
                table["sequences"] = builder.add_values(std::vector<std::uint8_t>{0, 0, 0}, "SCALAR");
              }},
        Wrong{"sequences_are_beyond", [](auto&, auto& table) { table["sequences"] = far_away; }},
        Wrong{"sequences_are_few",
              [](auto& builder, auto& table) {
                add_sequences(builder, table, {0, 0});
              }},
        Wrong{"sequences_are_many",
              [](auto& builder, auto& table) {
                add_sequences(builder, table, {0, 0, 0, 0});
              }},
        Wrong{"sequence_names_no_part",
              [](auto& builder, auto& table) {
                add_sequences(builder, table, {0, 1, 0});
              }}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

}  // namespace
}  // namespace foredraw::sequences_test
