// The rules of the source tree can fail: each is shown made-up files, good and bad.

#include <gtest/gtest.h>

#include "clock_rules.h"
#include "family_rules.h"
#include "include_rules.h"
#include "name_rules.h"
#include "product_rules.h"
#include "room_rules.h"
#include "shape_rules.h"
#include "text_rules.h"
#include "type_rules.h"

namespace foredraw::architecture::rules_test {
namespace {

bool may_include(const std::string& path, const std::string& target) {
  return include_breaches(path, "#pragma once\n#include " + target + "\n").empty();
}

TEST(IncludeRules, rooms_include_what_they_link) {
  EXPECT_TRUE(may_include("framework/foredraw/scene/draw.h", "<foredraw/base/random.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/scene/draw.h", "<foredraw/scene/traits.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/io/mesh/read.cpp", "<foredraw/io/gltf/private/document.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/io/gltf/gate/gate.cpp", "<foredraw/io/text/private/json_tree.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/io/gltf/gate/gate.cpp", "<foredraw/io/mesh/mesh_files.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/io/gltf/read.cpp", "<foredraw/pipeline/plan.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/io/gltf/read.cpp", "<foredraw/technique/run.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/base/random.h", "<foredraw/scene/draw.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/analysis/analyses.cpp", "<foredraw/technique/run.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/pipeline/plan.cpp", "<foredraw/io/gltf/gltf.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/scene/draw.h", "<foredraw/nowhere/x.h>"));
}

TEST(IncludeRules, rooms_are_read_from_the_build) {
  const std::vector<Room> made =
      rooms_in("macro(foredraw_room name)\nforedraw_room(base)\nforedraw_room(io_gltf base scene)\n");
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made[1].name, "io_gltf");
  EXPECT_EQ(made[1].links, (std::vector<std::string>{"base", "scene"}));
  EXPECT_GT(rooms().size(), 12u);
}

TEST(IncludeRules, platform_includes_base_and_alone_calls_posix) {
  EXPECT_TRUE(may_include("framework/foredraw/platform/files.cpp", "<foredraw/base/diagnostics.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/platform/files.cpp", "<sys/stat.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/io/gltf/gltf.h", "<foredraw/platform/files.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/platform/files.cpp", "<foredraw/scene/draw.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/scene/draw.cpp", "<foredraw/platform/files.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/io/gltf/read.cpp", "<unistd.h>"));
  EXPECT_FALSE(may_include("hosts/cli/main.cpp", "<sys/stat.h>"));
  EXPECT_FALSE(may_include("plugins/orderers/x/x_plugin.cpp", "<fcntl.h>"));
}

TEST(IncludeRules, framework_headers_show_glm_alone) {
  EXPECT_TRUE(may_include("framework/foredraw/scene/draw.h", "<glm/vec3.hpp>"));
  EXPECT_TRUE(may_include("framework/foredraw/report/report.cpp", "<nlohmann/json.hpp>"));
  EXPECT_FALSE(may_include("framework/foredraw/report/report.h", "<nlohmann/json.hpp>"));
  EXPECT_FALSE(may_include("framework/foredraw/base/parallel.h", "<tbb/parallel_for.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/io/gltf/read.cpp", "<draco/core/decoder_buffer.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/io/gltf/gltf.h", "<draco/core/decoder_buffer.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/pipeline/plan.cpp", "<draco/core/decoder_buffer.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/io/gltf/private/document.h", "<draco/core/decoder_buffer.h>"));
  EXPECT_FALSE(may_include("hosts/cli/main.cpp", "<foredraw/io/gltf/private/document.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/report/private/json_values.h", "<foredraw/io/text/private/json_tree.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/pipeline/plan.cpp", "<foredraw/io/text/private/json_tree.h>"));
}

TEST(HostRules, hosts_do_not_plan_or_encode) {
  EXPECT_EQ(host_breaches("hosts/cli/x.cpp", "auto plan = foredraw::plan(pipeline);").size(), 1u);
  EXPECT_EQ(host_breaches("framework/foredraw/c/library/x.cpp", "GltfOutput as; encode_scene(scene);").size(), 2u);
  EXPECT_TRUE(host_breaches("hosts/cli/x.cpp", "job.plan(pipeline) && job.run()").empty());
  EXPECT_TRUE(host_breaches("framework/foredraw/job/job.cpp", "foredraw::plan(pipeline)").empty());
}

TEST(IncludeRules, runtime_is_c) {
  EXPECT_TRUE(may_include("framework/foredraw/runtime/order_table.h", "<stdint.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/runtime/split_coding.h", "<foredraw/runtime/range_coder.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/runtime/order_table.h", "<cstdint>"));
  EXPECT_FALSE(may_include("framework/foredraw/runtime/order_table.h", "<foredraw/base/random.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/runtime/selective_refine.h", "<foredraw/runtime/progressive_mesh.h>"));
}

TEST(IncludeRules, plugins_know_the_framework_up_to_measuring_and_no_one_else) {
  const std::string dress = "plugins/orderers/x/x_plugin.cpp";
  EXPECT_TRUE(may_include(dress, "\"x.h\""));
  EXPECT_TRUE(may_include(dress, "<foredraw/technique/plugin.h>"));
  EXPECT_TRUE(may_include(dress, "<fmt/format.h>"));
  for (const char* target : {"<foredraw/report/report.h>", "<foredraw/pipeline/plan.h>", "<foredraw/io/gltf/gltf.h>",
                             "<foredraw/platform/files.h>", "\"../weld/weld.h\"", "<plugins/processors/weld/weld.h>"}) {
    EXPECT_FALSE(may_include(dress, target)) << target;
    EXPECT_FALSE(may_include("evaluators/x/x_plugin.cpp", target)) << target;
  }
}

TEST(IncludeRules, techniques_are_plain) {
  for (const std::string plain : {"plugins/orderers/x/x.cpp", "plugins/orderers/x/x.h", "evaluators/x/x.cpp"}) {
    EXPECT_TRUE(may_include(plain, "\"x.h\""));
    EXPECT_TRUE(may_include(plain, "<vector>"));
    EXPECT_TRUE(may_include(plain, "<glm/vec3.hpp>"));
    EXPECT_TRUE(may_include(plain, "<foredraw/analysis/vertex_cache.h>"));
    EXPECT_FALSE(may_include(plain, "<foredraw/technique/run.h>")) << plain;
    EXPECT_FALSE(may_include(plain, "<fmt/format.h>")) << plain;
  }
  EXPECT_TRUE(may_include("evaluators/x/x.cpp", "<embree3/rtcore.h>"));
  EXPECT_FALSE(may_include("evaluators/x/x.h", "<embree3/rtcore.h>"));
}

TEST(IncludeRules, vulkan_is_behind_the_room_gpu) {
  EXPECT_TRUE(may_include("framework/foredraw/gpu/handle.h", "<vulkan/vulkan.h>"));
  EXPECT_TRUE(may_include("framework/foredraw/gpu/clip_space.cpp", "<foredraw/viewing/camera.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/gpu/handle.h", "<embree3/rtcore.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/gpu/device.cpp", "<foredraw/overdraw/fragments.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/overdraw/fragments.h", "<vulkan/vulkan.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/overdraw/fragments.cpp", "<vulkan/vulkan.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/measuring/overdraw_evaluator.cpp", "<foredraw/gpu/device.h>"));
}

TEST(IncludeRules, who_links_gpu_may_include_it) {
  const std::string folder = "evaluators/overdraw_vulkan/";  // which does
  EXPECT_TRUE(may_include(folder + "x.cpp", "<foredraw/gpu/device.h>"));
  EXPECT_TRUE(may_include(folder + "x.h", "<foredraw/gpu/device.h>"));
  EXPECT_TRUE(may_include(folder + "overdraw_vulkan.h", "<foredraw/gpu/choice.h>"));
  EXPECT_FALSE(may_include(folder + "overdraw_vulkan.h", "<foredraw/gpu/device.h>"));
  EXPECT_FALSE(may_include(folder + "x.cpp", "<vulkan/vulkan.h>"));
  EXPECT_FALSE(may_include("evaluators/overdraw_raster/x.cpp", "<foredraw/gpu/device.h>"));
  EXPECT_FALSE(may_include("plugins/orderers/x/x.cpp", "<foredraw/gpu/device.h>"));
  EXPECT_TRUE(may_include("evaluators/lod_walk/x_plugin.cpp", "<foredraw/frames_gpu/vulkan_frames.h>"));
  EXPECT_FALSE(may_include("evaluators/lod_walk/x_plugin.cpp", "<foredraw/gpu/device.h>"));
  EXPECT_FALSE(may_include(folder + "x.cpp", "<foredraw/frames_gpu/vulkan_frames.h>"));
}

TEST(IncludeRules, techniques_may_be_made_of_rooms_beside_frames) {
  EXPECT_TRUE(may_include("plugins/processors/x/x.cpp", "<foredraw/collapses/cut.h>"));
  EXPECT_FALSE(may_include("framework/foredraw/frames/mipped_image.cpp", "<foredraw/collapses/cut.h>"));
  EXPECT_FALSE(may_include("plugins/processors/x/x.cpp", "<foredraw/draw_orders/order_memory.h>"));
}

TEST(IncludeRules, name_the_line) {
  const Breaches breaches = include_breaches("plugins/orderers/x/x.cpp", "\n\n  #  include <fmt/format.h> // why\n");
  ASSERT_EQ(breaches.size(), 1u);
  EXPECT_EQ(breaches[0].find("plugins/orderers/x/x.cpp:3: includes fmt/format.h"), 0u) << breaches[0];
  EXPECT_TRUE(include_breaches("tests/x_test.cpp", "#include <unistd.h>\n").empty());
}

TEST(ProductRules, names_of_products_are_found_where_rows_are_handed_round) {
  EXPECT_EQ(product_breaches("framework/foredraw/io/gltf/patch/patch.cpp", "a\n\"FOREDRAW_merge_instances\"\n").size(),
            1u);
  EXPECT_EQ(product_breaches("hosts/cli/outputs.cpp", "DrawOrders::product").size(), 1u);
  EXPECT_TRUE(product_breaches("framework/foredraw/pipeline/changed_tables.cpp", "DrawOrders::product").empty());
  EXPECT_TRUE(product_breaches("plugins/processors/merge_instances/x.cpp", "MergedDraws").empty());
}

TEST(ShapeRules, name_what_a_plugin_lacks) {
  std::set<std::string> paths = {
      "evaluators/CMakeLists.txt",       "plugins/CMakeLists.txt",           "plugins/orderers/x/CMakeLists.txt",
      "plugins/orderers/x/README.md",    "plugins/orderers/x/x.h",           "plugins/orderers/x/x.cpp",
      "plugins/orderers/x/x_plugin.cpp", "tests/plugins/orderers/x_test.cpp"};
  EXPECT_TRUE(plugin_shape_breaches(paths).empty());
  for (const std::string& path : std::set<std::string>(paths)) {
    if (!path.starts_with("plugins/orderers") && !path.starts_with("tests")) continue;
    paths.erase(path);
    const Breaches breaches = plugin_shape_breaches(paths);
    ASSERT_EQ(breaches.size(), 1u) << path;
    EXPECT_NE(breaches[0].find(path), std::string::npos) << breaches[0];
    paths.insert(path);
  }
  EXPECT_EQ(plugin_shape_breaches({"evaluators/y/y.h"}).size(), 5u);
  EXPECT_EQ(plugin_shape_breaches({"plugins/sorters/y/y.h"}).size(), 1u);
  EXPECT_EQ(plugin_shape_breaches({"plugins/orderers/y.h"}).size(), 1u);
}

TEST(ShapeRules, plugins_have_a_function_for_c_or_a_reason) {
  const std::string page =
      "# C\n\nPlugins that have no function for C:\n\n| `two-words` | why |\n\n## Then\n\n`other`\n";
  const auto told = [&](const std::set<std::string>& paths) { return c_function_breaches(paths, page); };
  EXPECT_TRUE(told({"plugins/orderers/two_words/two_words_plugin.cpp"}).empty());
  EXPECT_TRUE(told({"evaluators/other/other_plugin.cpp", "evaluators/other/other_c.cpp"}).empty());
  EXPECT_EQ(told({"evaluators/other/other_plugin.cpp"}).size(), 1u);
  EXPECT_EQ(told({"plugins/x/two_words/two_words_plugin.cpp", "plugins/x/two_words/two_words_c.cpp"}).size(), 1u);
}

TEST(ShapeRules, corpus) {
  const std::string credits = "| `spot.glb` | ...";
  const std::string folder = "benchmarks/corpus/static/";
  EXPECT_TRUE(corpus_breaches({{folder + "spot.glb", 25'000'000, false}}, credits).empty());
  EXPECT_EQ(corpus_breaches({{folder + "spot.glb", 25'000'001, false}}, credits).size(), 1u);
  EXPECT_EQ(corpus_breaches({{folder + "spot.glb", 0, true}}, credits).size(), 1u);
  EXPECT_EQ(corpus_breaches({{folder + "pot.glb", 1, false}}, credits).size(), 1u);
  EXPECT_EQ(corpus_breaches({{folder + "sp\xc3\xb6t.bin", 1, false}}, credits).size(), 1u);
  EXPECT_TRUE(corpus_breaches({{"docs/elsewhere.glb", 99'000'000, true}}, credits).empty());
}

TEST(NameRules, empty_names_are_refused) {
  for (const char* path : {"framework/foredraw/base/utils.h", "framework/common/x.h", "hosts/cli/file_manager.cpp",
                           "tests/support/test_helper.h", "docs/misc.md", "framework/foredraw/base/Random.h"}) {
    EXPECT_EQ(name_breaches(path).size(), 1u) << path;
  }
  for (const char* path : {"framework/foredraw/base/random.h", "framework/cmake/ForedrawPlugin.cmake", "README.md",
                           "docs/commonplace.md", "plugins/orderers/dot_rule/dot_rule_plugin.cpp"}) {
    EXPECT_TRUE(name_breaches(path).empty()) << path;
  }
}

TEST(NameRules, tests_without_a_namespace_of_their_own_are_found) {
  std::map<std::string, std::string> files;
  const std::string gltf = "tests/framework/io/gltf/levels_test.cpp",
                    plugin = "tests/plugins/processors/levels_test.cpp";
  EXPECT_EQ(test_namespace_breaches(plugin, "namespace foredraw {\nnamespace {\n", files).size(), 1u);
  EXPECT_EQ(test_namespace_breaches(plugin, "namespace foredraw::quad_levels_test {\n", files).size(), 1u);
  EXPECT_TRUE(test_namespace_breaches(plugin, "\nnamespace foredraw::levels_test {\n", files).empty());
  EXPECT_EQ(test_namespace_breaches(gltf, "\nnamespace foredraw::levels_test {\n", files).size(), 1u);
  EXPECT_TRUE(test_namespace_breaches(gltf, "\nnamespace foredraw::gltf_levels_test {\n", files).empty());
  EXPECT_TRUE(test_namespace_breaches("tests/support/meshes.h", "namespace foredraw::testing {\n", files).empty());
}

TEST(NameRules, long_files_are_found) {
  const std::string text(301, '\n');
  EXPECT_EQ(length_breaches("a.cpp", text, 300).size(), 1u);
  EXPECT_TRUE(length_breaches("a.cpp", text, 301).empty());
  EXPECT_TRUE(length_breaches("a.md", text, 300).empty());
}

TEST(ClockRules, tests_that_read_clocks_are_found) {
  for (const char* text : {"std::chrono::steady_clock::now()", "std::clock()", "await page.waitForTimeout(400)",
                           "time.perf_counter()", "performance.now()"}) {
    EXPECT_EQ(clock_breaches("tests/a_test.cpp", std::string("fine\n") + text).size(), 1u) << text;
    EXPECT_TRUE(clock_breaches("benchmarks/a.cpp", text).empty()) << text;
    EXPECT_TRUE(clock_breaches("tests/farm/slurm.py", text).empty()) << text;
  }
  EXPECT_TRUE(clock_breaches("tests/a_test.cpp", "fs::last_write_time(file, std::chrono::hours(1))").empty());
}

TEST(TextRules, unfinished_work_and_machine_paths_are_found) {
  for (const char* text : {"// TO"
                           "DO later",
                           "FIX"
                           "ME: x",
                           "cd /ho"
                           "me/me",
                           "\"/tm"
                           "p/x\"",
                           "see ../sha"
                           "red/x",
                           "/wo"
                           "rk/main"}) {
    EXPECT_EQ(text_breaches("a.md", std::string("fine\n") + text).size(), 1u) << text;
  }
  for (const char* text : {"framework/foredraw",
                           "build/tm"
                           "p/x",
                           "https://example.org/ho"
                           "me",
                           "a mastodon"}) {
    EXPECT_TRUE(text_breaches("a.md", text).empty()) << text;
  }
  EXPECT_EQ(text_breaches("a.md",
                          "one\n// TO"
                          "DO")
                .front()
                .find("a.md:2: "),
            0u);
}

TEST(FamilyRules, the_table_says_what_names_a_family_and_where_its_home_is) {
  const std::vector<Family> families = families_in(
      "# Page\n\n| family | names | at home in | files elsewhere |\n|---|---|---|---:|\n"
      "| second depth | second_depth seconddepth | plugins/processors/second_depth/ a/b/ | 12 |\n");
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].name, "second depth");
  EXPECT_EQ(families[0].words, (std::vector<std::string>{"second_depth", "seconddepth"}));
  EXPECT_EQ(families[0].homes, (std::vector<std::string>{"plugins/processors/second_depth/", "a/b/"}));
  EXPECT_EQ(families[0].files_elsewhere, 12u);
}

TEST(FamilyRules, counts_sources_elsewhere) {
  const Family wires{"wires", {"wire"}, {"framework/foredraw/wires/"}, 2};
  EXPECT_TRUE(names_from_elsewhere(wires, "framework/foredraw/page/page.cpp", "struct ShownWires {};"));
  EXPECT_TRUE(names_from_elsewhere(wires, "hosts/python/a.py", "wire"));
  EXPECT_FALSE(names_from_elsewhere(wires, "framework/foredraw/page/page.cpp", "struct Shown {};"));
  EXPECT_FALSE(names_from_elsewhere(wires, "framework/foredraw/wires/wires.cpp", "wire"));
  EXPECT_FALSE(names_from_elsewhere(wires, "framework/foredraw/runtime/wire_radius.h", "wire"));
  EXPECT_FALSE(names_from_elsewhere(wires, "tests/a.cpp", "wire"));
  EXPECT_FALSE(names_from_elsewhere(wires, "plugins/a/README.md", "wire"));

  EXPECT_TRUE(family_breaches(wires, {"a", "b"}).empty());
  EXPECT_EQ(family_breaches(wires, {"a"}).size(), 1u);
  EXPECT_EQ(family_breaches(wires, {"a", "b", "c"}).size(), 1u);
}

TEST(NameRules, plugins_carry_their_folders_name) {
  const std::string plugin = "plugins/orderers/dot_rule/dot_rule_plugin.cpp";
  const auto number_of_breaches = [](const std::string& path, const std::string& line) {
    return plugin_name_breaches(path, "#pragma once\n" + line + '\n').size();
  };
  for (const char* line : {"namespace foredraw {", "namespace {", "namespace foredraw::orderers::dot_rule {",
                           "namespace orderers::dot_rule {", "namespace foredraw::orderers::dot_rule::HWY_NAMESPACE {",
                           "class DotRuleOrderer final : public DrawOrderer {", "class Steps {"}) {
    EXPECT_EQ(number_of_breaches(plugin, line), 0u) << line;
  }
  for (const char* line :
       {"namespace foredraw::dots {", "namespace foredraw::dot_rule {", "namespace foredraw::processors::dot_rule {",
        "class DotRule final : public DrawOrderer {", "class SortDots final : public Clusterer {"}) {
    EXPECT_EQ(number_of_breaches(plugin, line), 1u) << line;
  }
  EXPECT_EQ(number_of_breaches("evaluators/lod_walk/walk.h", "namespace foredraw::evaluators::lod_walk {"), 0u);
  EXPECT_EQ(number_of_breaches("evaluators/lod_walk/walk.h", "namespace foredraw::lod_walk {"), 1u);
  EXPECT_EQ(number_of_breaches("framework/foredraw/io/gltf/gltf.h", "namespace foredraw::gltf {"), 0u);
}

TEST(RoomRules, the_picture_gives_floors_and_links) {
  const std::vector<Room> rooms = {{"base", {}}, {"high", {"low", "base"}}, {"low", {"base"}}};
  EXPECT_EQ(picture_of(rooms),
            " 0  base\n"
            " 1  low           base\n"
            " 2  high          low base\n");
}

TEST(RoomRules, the_page_shows_each_room_once) {
  const std::vector<Room> rooms = {{"base", {}}, {"low", {"base"}}};
  const std::string picture = "# Page\n\n## Rooms\n\n```\n" + picture_of(rooms) + "```\n";
  EXPECT_TRUE(room_breaches(picture + "| `base`, `low` | `no` room |\n| `runtime` | C |\n", rooms).empty());
  EXPECT_EQ(room_breaches(picture + "| `base` | it |\n", rooms).size(), 1u);
  EXPECT_EQ(room_breaches(picture + "| `base`, `low` | it |\n| `low` | it |\n", rooms).size(), 1u);
  EXPECT_EQ(room_breaches(picture + "| `base`, `low`, `attic` | it |\n", rooms).size(), 1u);
  EXPECT_EQ(room_breaches("\n## Rooms\n\n```\n 0  base\n```\n| `base`, `low` | it |\n", rooms).size(), 1u);
}

TEST(TypeRules, TypesOfOneNameAreTold) {
  TypeFiles types;
  add_types("a.h", "namespace x {\n\nstruct Same {\n};\nclass Own final : public Base {\n};\n\n}  // namespace x\n",
            types);
  add_types("b.cpp",
            "namespace x {\n\nnamespace {\n\nstruct Same {\n};\n\n}  // namespace\n\n"
            "struct Same::Inner : Base {\n};\nstruct Own;\n\n}  // namespace x\n",
            types);
  EXPECT_TRUE(type_breaches(types).empty());
  add_types("c.h", "namespace x {\nstruct Same {};\n}  // namespace x\n", types);
  EXPECT_EQ(type_breaches(types), Breaches{"x::Same is defined in a.h and c.h; call one of them otherwise"});
}

}  // namespace
}  // namespace foredraw::architecture::rules_test
