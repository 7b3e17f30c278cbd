// FOREDRAW_merge_instances that is wrong: it costs itself alone.

#include "support/merged_scenes.h"

#include <gtest/gtest.h>

#include <functional>

namespace foredraw::merge_instances_damage_test {
namespace {

using namespace testing;

struct Wrong {
  std::string name;
  std::function<void(GltfBuilder&, GltfJson& set)> make;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

GltfBuilder merged_file() {
  GltfBuilder builder = builder_of(write(merged_yard(read(yard()), {.frequencies = {6, 3}, .materials = true})));
  builder.json.erase("buffers");
  return builder;
}

class WrongMergedInstances : public ::testing::TestWithParam<Wrong> {};

/// The file is read without them, a warning says so and where, and nothing of them is written again.
TEST_P(WrongMergedInstances, are_left_out_with_a_warning) {
  GltfBuilder builder = merged_file();
  ASSERT_EQ(merged_of(read(builder)).size(), 1u);
  GetParam().make(builder, builder.json["extensions"][merge_instances_extension]["sets"][0]);
  Diagnostics diagnostics;
  auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(scene) << to_text(diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u) << to_text(diagnostics);
  EXPECT_EQ(diagnostics.all()[0].code, "merged-draws-left-out");
  EXPECT_EQ(diagnostics.all()[0].where.inside, merge_instances_extension);
  EXPECT_FALSE(diagnostics.all()[0].hint.empty());
  EXPECT_TRUE(merged_of(*scene).empty());
  EXPECT_FALSE(scene->draws[0].traits.has(traits::extended));
  const GltfJson json = written(*scene);
  EXPECT_EQ(json.dump().find(merge_instances_extension), std::string::npos);
  EXPECT_EQ(json["nodes"], builder.json["nodes"]);
  Scene changed = *scene;
  reverse(changed.draws[0]);
  EXPECT_EQ(written(changed).dump().find(merge_instances_extension), std::string::npos);
}

constexpr std::uint64_t far_away = 1ull << 40;

std::size_t number(const GltfJson& set, const char* key) { return set[key].get<std::size_t>(); }

/// A new accessor with the elements of one of the set's, some of them changed.
template <class T>
void rewrite(GltfBuilder& builder, GltfJson& set, const char* key, const char* type,
             const std::function<void(std::vector<T>&)>& change) {
  const GltfJson accessor = builder.json["accessors"][number(set, key)];
  const GltfJson view = builder.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t components = std::string(type) == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
  std::vector<T> values(accessor["count"].get<std::size_t>() * components);
  std::memcpy(values.data(), builder.buffer.data() + view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u),
              4 * values.size());
  change(values);
  set[key] = builder.add_values(values, type);
}

Wrong word(const char* name, const char* key, const char* type, std::size_t at, std::uint32_t value) {
  return {name, [=](GltfBuilder& builder, GltfJson& set) {
            rewrite<std::uint32_t>(builder, set, key, type, [&](std::vector<std::uint32_t>& all) { all[at] = value; });
          }};
}

std::vector<Wrong> in_general() {
  std::vector<Wrong> all{
      {"extension_is_text", [](auto& b, auto&) { b.json["extensions"][merge_instances_extension] = "sets"; }},
      {"extension_is_null", [](auto& b, auto&) { b.json["extensions"][merge_instances_extension] = nullptr; }},
      {"no_sets", [](auto& b, auto&) { b.json["extensions"][merge_instances_extension].erase("sets"); }},
      {"sets_are_an_object",
       [](auto& b, auto& set) { b.json["extensions"][merge_instances_extension]["sets"] = GltfJson(set); }},
      {"set_is_a_number", [](auto&, auto& set) { set = 3; }},
      {"set_twice",
       [](auto& b, auto& set) {
         const GltfJson copy = set;
         b.json["extensions"][merge_instances_extension]["sets"].push_back(copy);
       }},
      {"material_is_beyond", [](auto&, auto& set) { set["material"] = 2; }},
      {"material_is_far", [](auto&, auto& set) { set["material"] = far_away; }},
      {"no_positions", [](auto&, auto& set) { set["attributes"].erase("POSITION"); }},
      {"attributes_are_empty", [](auto&, auto& set) { set["attributes"] = GltfJson::object(); }},
      {"attributes_are_of_unequal_lengths",
       [](auto& b, auto& set) { set["attributes"]["_SIX"] = b.add_values(std::vector<float>(9), "VEC3"); }},
      {"vertices_are_short",
       [](auto& b, auto& set) {
         for (auto& [semantic, accessor] : set["attributes"].items())
           b.json["accessors"][accessor.template get<std::size_t>()]["count"] = 5;
       }},
      {"far_more_is_named_than_is_there",
       [](auto& b, auto& set) {
         const std::size_t zeros = b.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1 << 20}});
         for (int i = 0; i < 2000; ++i) set["attributes"]["_" + std::to_string(i)] = zeros;
       }},
      {"far_more_sets_than_is_there",
       [](auto& b, auto& set) {
         const std::size_t zeros =
             b.add("accessors", {{"componentType", 5125}, {"type", "SCALAR"}, {"count", 1 << 20}});
         set["indices"] = zeros;
         const GltfJson copy = set;
         for (int i = 0; i < 3000; ++i) b.json["extensions"][merge_instances_extension]["sets"].push_back(copy);
       }},
      {"transform_is_not_finite",
       [](auto& b, auto& set) {
         // As vertex data it may be so.
         const std::size_t odd =
             b.add_values(std::vector<float>(std::size_t{9} * 12, std::numeric_limits<float>::infinity()), "VEC4");
         set["attributes"] = {{"POSITION", odd}};
         set["transforms"] = odd;
       }},
  };
  for (const char* key : {"attributes", "indices", "slots", "transforms", "places", "primitives", "groups"}) {
    all.push_back({std::string("no_") + key, [=](auto&, auto& set) { set.erase(key); }});
  }
  for (const char* key :
       {"material", "attributes", "indices", "slots", "transforms", "places", "materials", "primitives", "groups"}) {
    all.push_back({std::string(key) + "_is_text", [=](auto&, auto& set) { set[key] = "1"; }});
    all.push_back({std::string(key) + "_is_null", [=](auto&, auto& set) { set[key] = nullptr; }});
  }
  for (const char* key : {"indices", "slots", "transforms", "places", "materials"}) {
    all.push_back({std::string(key) + "_is_negative", [=](auto&, auto& set) { set[key] = -1; }});
    all.push_back(
        {std::string(key) + "_is_beyond", [=](auto& b, auto& set) { set[key] = b.json["accessors"].size(); }});
    all.push_back({std::string(key) + "_is_far", [=](auto&, auto& set) { set[key] = far_away; }});
    all.push_back(
        {std::string(key) + "_is_positions", [=](auto&, auto& set) { set[key] = set["attributes"]["POSITION"]; }});
    all.push_back({std::string(key) + "_is_short", [=](auto& b, auto& set) {
                     GltfJson& count = b.json["accessors"][number(set, key)]["count"];
                     count = count.template get<std::size_t>() - 1;
                   }});
    all.push_back({std::string(key) + "_is_long", [=](auto& b, auto& set) {
                     if (std::string(key) == "indices" || std::string(key) == "slots")
                       return set["material"] = -1, void();
                     GltfJson accessor = b.json["accessors"][number(set, key)];
                     accessor["count"] = accessor["count"].template get<std::size_t>() + 3;
                     accessor.erase("bufferView");
                     accessor.erase("byteOffset");
                     set[key] = b.add("accessors", accessor);
                   }});
  }
  return all;
}

std::vector<Wrong> in_parts() {
  std::vector<Wrong> all{
      {"primitive_is_text", [](auto&, auto& set) { set["primitives"][0] = "a"; }},
      {"primitive_is_beyond", [](auto&, auto& set) { set["primitives"][0]["primitive"] = 1; }},
      {"mesh_is_beyond", [](auto&, auto& set) { set["primitives"][0]["mesh"] = 3; }},
      {"vertices_begin_behind_the_end", [](auto&, auto& set) { set["primitives"][2]["firstVertex"] = 18; }},
      {"vertices_lead_out", [](auto&, auto& set) { set["primitives"][2]["firstVertex"] = 11; }},
      {"group_is_a_number", [](auto&, auto& set) { set["groups"][0] = 1; }},
      {"group_leads_out", [](auto&, auto& set) { set["groups"][1]["instanceCount"] = 6; }},
      {"group_begins_behind_the_end", [](auto&, auto& set) { set["groups"][1]["firstInstance"] = 0xffffffffu; }},
      {"corner_is_of_two",
       [](auto&, auto& set) {
         set["groups"][0]["min"] = {1, 2};
       }},
      {"corner_is_text",
       [](auto&, auto& set) {
         set["groups"][0]["max"] = {1, 2, "3"};
       }},
      {"corner_is_no_float",
       [](auto&, auto& set) {
         set["groups"][0]["max"] = {1, 2, 1e300};
       }},
      {"corners_are_turned", [](auto&, auto& set) { std::swap(set["groups"][0]["min"], set["groups"][0]["max"]); }},
      {"draws_are_an_object", [](auto&, auto& set) { set["groups"][0]["draws"] = GltfJson::object(); }},
      {"draw_is_text", [](auto&, auto& set) { set["groups"][0]["draws"][0] = "a"; }},
      {"frequency_is_0", [](auto&, auto& set) { set["groups"][0]["draws"][0]["frequency"] = 0; }},
      {"frequency_is_4", [](auto&, auto& set) { set["groups"][0]["draws"][0]["frequency"] = 4; }},
      {"frequency_is_large", [](auto&, auto& set) { set["groups"][0]["draws"][0]["frequency"] = 0xffffffffu; }},
      {"slots_are_beyond", [](auto&, auto& set) { set["groups"][1]["draws"][1]["slotCount"] = 1000; }},
      {"slots_are_countless", [](auto&, auto& set) { set["groups"][1]["draws"][1]["slotCount"] = 0xffffffffu; }},
      {"slots_begin_beyond", [](auto&, auto& set) { set["groups"][1]["draws"][1]["firstSlot"] = 0xffffffffu; }},
      {"slots_are_drawn_twice", [](auto&, auto& set) { set["groups"][0]["draws"][1]["firstSlot"] = 0; }},
      {"slots_are_of_the_other_group",
       [](auto&, auto& set) { std::swap(set["groups"][0]["draws"], set["groups"][1]["draws"]); }},
      word("index_is_beyond", "indices", "SCALAR", 3, 18),
      word("slot_begins_behind_the_end", "slots", "VEC2", 0, 0xfffffffe),
      word("slot_leads_out", "slots", "VEC2", 0, 39),
      word("instance_is_of_the_other_group", "slots", "VEC2", 1, 8),
      word("instance_is_beyond", "slots", "VEC2", 1, 0xffffffff),
      word("node_is_beyond", "places", "VEC3", 0, 9),
      word("primitive_of_a_node_is_beyond", "places", "VEC3", 1, 1),
      word("instance_of_a_node_is_beyond", "places", "VEC3", 2, 1),
      word("place_is_there_twice", "places", "VEC3", 0, 1),
      word("material_of_an_instance_is_beyond", "materials", "SCALAR", 4, 2),
      word("triangle_is_another", "indices", "SCALAR", 1, 3),
      word("instance_lacks_a_slot", "slots", "VEC2", 1, 0),
      word("transform_is_elsewhere", "transforms", "VEC4", 3, 0x3f8ccccd),
      {"materials_of_instances_are_others",
       [](auto& b, auto& set) {
         b.json["materials"][1]["doubleSided"] = true;
         set.erase("materials");
       }},
      word("place_is_another", "places", "VEC3", 0, 8),
      {"mesh_is_another",
       [](auto&, auto& set) { std::swap(set["primitives"][0]["mesh"], set["primitives"][1]["mesh"]); }},
      {"mesh_is_there_twice", [](auto&, auto& set) { set["primitives"].push_back(GltfJson(set["primitives"][0])); }},
      {"mesh_is_missing", [](auto&, auto& set) { set["primitives"].erase(1); }},
      {"vertices_are_of_another_mesh", [](auto&, auto& set) { set["primitives"][0]["firstVertex"] = 4; }},
      {"attribute_is_missing", [](auto&, auto& set) { set["attributes"].erase("_SIX"); }},
      {"attribute_is_another", [](auto&, auto& set) { set["attributes"]["_SIX"] = set["attributes"]["POSITION"]; }},
      {"node_was_moved", [](auto& b, auto&) { b.json["nodes"][4]["translation"][1] = 7; }},
      {"parent_was_turned",
       [](auto& b, auto&) {
         b.add("nodes", {{"children", {4}}, {"rotation", {0, 1, 0, 0}}});
       }},
      {"node_shows_another_mesh", [](auto& b, auto&) { b.json["nodes"][4]["mesh"] = 0; }},
      {"primitive_has_another_material",
       [](auto& b, auto&) {
         b.json["materials"][1]["doubleSided"] = true;
         b.json["meshes"][0]["primitives"][0]["material"] = 1;
       }},
      {"primitive_draws_less",
       [](auto& b, auto&) {
         GltfJson& count =
             b.json["accessors"][b.json["meshes"][2]["primitives"][0]["indices"].template get<std::size_t>()]["count"];
         count = count.template get<std::size_t>() - 3;
       }},
      {"node_shows_nothing", [](auto& b, auto&) { b.json["nodes"][0].erase("mesh"); }},
  };
  for (const char* key : {"mesh", "primitive", "firstVertex"}) {
    all.push_back(
        {std::string("primitive_without_") + key, [=](auto&, auto& set) { set["primitives"][1].erase(key); }});
    all.push_back({std::string("primitive_whose_") + key + "_is_far",
                   [=](auto&, auto& set) { set["primitives"][1][key] = far_away; }});
  }
  for (const char* key : {"min", "max", "firstInstance", "instanceCount", "draws"}) {
    all.push_back({std::string("group_without_") + key, [=](auto&, auto& set) { set["groups"][1].erase(key); }});
  }
  for (const char* key : {"frequency", "firstSlot", "slotCount"}) {
    all.push_back(
        {std::string("draw_without_") + key, [=](auto&, auto& set) { set["groups"][1]["draws"][0].erase(key); }});
    all.push_back({std::string("draw_whose_") + key + "_is_broken",
                   [=](auto&, auto& set) { set["groups"][1]["draws"][0][key] = 3.5; }});
  }
  return all;
}

const auto name_of = [](const auto& wrong) { return wrong.param.name; };
INSTANTIATE_TEST_SUITE_P(InGeneral, WrongMergedInstances, ::testing::ValuesIn(in_general()), name_of);
INSTANTIATE_TEST_SUITE_P(InParts, WrongMergedInstances, ::testing::ValuesIn(in_parts()), name_of);

TEST(DamagedMergedInstances, the_warning_names_the_place) {
  GltfBuilder builder = merged_file();
  builder.json["extensions"][merge_instances_extension]["sets"][0]["groups"][1]["draws"][1]["frequency"] = 4;
  Diagnostics diagnostics;
  ASSERT_TRUE(read_gltf(builder.glb(), "yard.glb", {}, diagnostics, {.products = built_in_products()}));
  EXPECT_EQ(diagnostics.all()[0].where.file, "yard.glb");
  EXPECT_EQ(diagnostics.all()[0].message,
            "is left out, and with it the merged draws: sets[0] draw 3 has slots of 4 entries, which are not whole "
            "triangles");
}

TEST(DamagedMergedInstances, transforms_may_be_rounded_otherwise) {
  GltfBuilder builder = merged_file();
  GltfJson& set = builder.json["extensions"][merge_instances_extension]["sets"][0];
  rewrite<float>(builder, set, "transforms", "VEC4", [](std::vector<float>& all) {
    for (float& value : all) value *= 1 + 1e-6f;
  });
  EXPECT_EQ(merged_of(read(builder)).size(), 1u);
}

/// Slots that begin at each third entry and are padding, far longer than what is there: to look at all of it would take
/// longer than a test may.
TEST(DamagedMergedInstances, padding_is_looked_at_once) {
  GltfBuilder builder = merged_file();
  GltfJson& set = builder.json["extensions"][merge_instances_extension]["sets"][0];
  const std::uint32_t entries = 3 << 20, frequency = 3 << 19;
  set["indices"] = builder.add("accessors", {{"componentType", 5125}, {"type", "SCALAR"}, {"count", entries}});
  std::vector<std::uint32_t> slots;
  for (std::uint32_t s = 0; s < 1'000'000; ++s) slots.insert(slots.end(), {s, 0});
  set["slots"] = builder.add_values(slots, "VEC2");
  set["groups"].erase(1);
  set["groups"][0]["draws"] = GltfJson::array();
  for (std::uint32_t first = 0; first < 1'000'000; first += 1000) {
    set["groups"][0]["draws"].push_back({{"frequency", frequency}, {"firstSlot", first}, {"slotCount", 1000}});
  }
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "test", {}, diagnostics, {.products = built_in_products()});
  ASSERT_TRUE(scene);
  EXPECT_TRUE(merged_of(*scene).empty());
}

/// What only they named goes with them: numbers that are none would be a mistake where nobody calls them vertices.
TEST(DamagedMergedInstances, leave_nothing_behind) {
  GltfBuilder builder = yard();
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(builder.buffer.data(), &none, 4);
  GltfBuilder merged = builder_of(write(merged_yard(read(builder))));
  merged.json.erase("buffers");
  merged.json["extensions"][merge_instances_extension]["sets"][0]["material"] = 77;
  const Bytes file = write(read(merged));
  EXPECT_TRUE(merged_of(read(file)).empty());
  EXPECT_LE(file.size(), builder.glb().size() + 1000) << "accessors without bytes are left";
}

TEST(DamagedMergedInstances, no_sets_are_none) {
  GltfBuilder builder = merged_file();
  builder.json["extensions"][merge_instances_extension]["sets"] = GltfJson::array();
  EXPECT_TRUE(merged_of(read(builder)).empty());
  EXPECT_EQ(write(read(builder)), builder.glb());
}

/// Somebody hid a node since, or lets an animation move it.
TEST(DamagedMergedInstances, nodes_that_were_hidden_or_are_moved_cost_the_merged_draws) {
  const GltfBuilder whole = builder_of(write(merged_yard(read(yard()))));
  EXPECT_FALSE(merged_of(read(whole)).empty());
  GltfBuilder hidden = whole;
  hidden.json["nodes"][4]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
  EXPECT_TRUE(merged_of(read(hidden)).empty());
  GltfBuilder moved = whole;
  moved.json.erase("buffers");
  const std::size_t times = moved.add_values(std::vector<float>{0, 1}, "SCALAR");
  moved.json["accessors"][times]["min"] = {0};
  moved.json["accessors"][times]["max"] = {1};
  const std::size_t values = moved.add_values(std::vector<float>{0, 0, 0, 5, 0, 0}, "VEC3");
  moved.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 4}, {"path", "translation"}}}}}},
                           {"samplers", {{{"input", times}, {"output", values}}}}});
  EXPECT_TRUE(merged_of(read(moved)).empty());
}

}  // namespace
}  // namespace foredraw::merge_instances_damage_test
