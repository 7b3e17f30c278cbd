// The program as its users run it: arguments, exit codes, what lands on which stream, what lands on disk.

#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::content;
using testing::Ended;

class Cli : public testing::InFolder {
 protected:
  Ended run(const std::string& arguments) { return testing::run_program(folder_, arguments); }
  std::string model(const std::string& name) {
    return "'" + testing::project_file("benchmarks/corpus/" + name).string() + "'";
  }
  std::string spot() { return model("static/spot.glb"); }
};

double metric(const Json& state, const char* plugin, const char* name) {
  return state["metrics"][plugin][name]["value"];
}

TEST_F(Cli, OptimizesAndMeasuresTheGain) {
  const Ended made = run("optimize " + spot() + " -o out.glb --report r.json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(made.out.empty());
  EXPECT_NE(made.err.find("acmr"), std::string::npos);
  const Json report = Json::parse(content(folder_ / "r.json"));
  EXPECT_EQ(report["report"], 1);
  const Json& totals = report["totals"];
  EXPECT_LT(metric(totals, "vertex-cache", "acmr"), 0.75 * metric(totals["before"], "vertex-cache", "acmr"));
  EXPECT_LT(metric(totals, "overdraw-raster", "ratio"), metric(totals["before"], "overdraw-raster", "ratio"));
  EXPECT_EQ(totals["metrics"]["vertex-cache"]["acmr"]["unit"], "misses per triangle");
  EXPECT_GT(totals["metrics"]["overdraw-raster"]["ratio"]["error"].get<double>(), 0);
  EXPECT_TRUE(totals["metrics"]["vertex-cache"]["models"].contains("fifo-32"));
  EXPECT_EQ(report["evaluators"]["vertex-cache"]["options"]["cache-size"], 16);

  const Ended measured = run("measure out.glb --json");
  ASSERT_EQ(measured.code, 0) << measured.err;
  const Json again = Json::parse(measured.out);
  EXPECT_EQ(metric(again["totals"], "vertex-cache", "acmr"), metric(totals, "vertex-cache", "acmr"));
  EXPECT_EQ(metric(again["totals"], "overdraw-raster", "ratio"), metric(totals, "overdraw-raster", "ratio"));
  EXPECT_EQ(again["draws"].size(), 1u);
}

TEST_F(Cli, MeasuresWhatTheStagesAreAbout) {
  const std::string sprite = model("particles/kenney_smoke_04.png");
  const Ended trimmed = run("optimize " + sprite + " -o out.glb -p particle-trim --json");
  ASSERT_EQ(trimmed.code, 0) << trimmed.err;
  const Json before = Json::parse(trimmed.out)["totals"]["before"]["metrics"];
  EXPECT_TRUE(before.contains("sprite-fill"));
  EXPECT_FALSE(before.contains("vertex-cache")) << "two triangles more are no gain for it";
  const Ended packed = run("optimize " + spot() + " -o out.glb -p gpu-instances --json");
  EXPECT_TRUE(Json::parse(packed.out)["totals"]["before"]["metrics"].contains("scene-cost"));
  const Ended asked = run("optimize " + sprite + " -o out.glb -p particle-trim --with vertex-cache --json");
  EXPECT_FALSE(Json::parse(asked.out)["totals"]["before"]["metrics"].contains("sprite-fill"));
}

TEST_F(Cli, MeshesGoToGltfAndBackToTheirOwnKind) {
  std::ofstream(folder_ / "strip.obj")
      << "# kept\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\nf 1 2 3\nf 3 4 5\nf 3 2 4\n";
  EXPECT_EQ(run("optimize strip.obj -o strip.glb").code, 0);
  EXPECT_EQ(run("inspect strip.glb").code, 0);
  const Ended back = run("optimize strip.obj -o again.obj");
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_EQ(content(folder_ / "again.obj").size(), content(folder_ / "strip.obj").size());
  EXPECT_EQ(content(folder_ / "again.obj").substr(0, 7), "# kept\n");
  const Ended other = run("optimize strip.obj -o strip.ply");
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("strip.ply: error: only a scene that was read from .ply can be written as one"),
            std::string::npos)
      << other.err;
  std::ofstream(folder_ / "broken.stl") << "solid";
  const Ended broken = run("measure broken.stl");
  EXPECT_EQ(broken.code, 2);
  EXPECT_NE(broken.err.find("broken.stl:1:6: error: the file ends inside a solid"), std::string::npos) << broken.err;
}

TEST_F(Cli, DrawsHeatMaps) {
  const Ended made = run("optimize " + spot() + " -o out.glb --heatmap deep/maps");
  ASSERT_EQ(made.code, 0) << made.err;
  ASSERT_EQ(run("measure " + spot() + " --heatmap maps --heatmap-view 7 --with 'overdraw-raster(views=axes)'").code, 1);
  const Ended measured =
      run("measure " + spot() + " --heatmap maps --heatmap-view 5 --with 'vertex-cache, overdraw-raster(views=axes)'");
  ASSERT_EQ(measured.code, 0) << measured.err;
  std::vector<std::string> names;
  for (const char* maps : {"deep/maps", "maps"}) {
    for (const auto& entry : fs::directory_iterator(folder_ / maps)) {
      names.push_back(entry.path().filename().string());
      EXPECT_EQ(content(entry.path()).substr(1, 3), "PNG");
    }
  }
  ASSERT_EQ(names.size(), 2u);
  EXPECT_TRUE(names[1].ends_with("-view005.png")) << names[1];
}

TEST_F(Cli, DrawsHeatMapsOfEachFileOfAFolder) {
  fs::create_directories(folder_ / "in/deep");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/a.glb");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/deep/a.glb");
  const Ended measured = run("measure in --heatmap maps");
  ASSERT_EQ(measured.code, 0) << measured.err;
  EXPECT_FALSE(fs::is_empty(folder_ / "maps/a.glb"));
  EXPECT_FALSE(fs::is_empty(folder_ / "maps/deep/a.glb"));
}

TEST_F(Cli, SaysWhereHeatMapsCanNotBeDrawn) {
  const Ended no_view = run("optimize " + spot() + " -o out.glb --heatmap maps --heatmap-view best");
  EXPECT_EQ(no_view.code, 1);
  EXPECT_EQ(no_view.err,
            "foredraw: error: there is no view 'best'\n    hint: give worst, all, or a number from 0 to 99\n");
  EXPECT_TRUE(files().empty());
  std::ofstream(folder_ / "maps") << "a file";
  const Ended no_folder = run("measure " + spot() + " --heatmap maps");
  EXPECT_EQ(no_folder.code, 2);
  EXPECT_NE(no_folder.err.find("maps: error: cannot be created"), std::string::npos) << no_folder.err;
}

TEST_F(Cli, WritesTheSameBytesAtAnyThreadCount) {
  for (const std::string preset : {"@default", "@levels", "@streaming"}) {
    const std::string of = "optimize " + model("animated/robot_expressive.glb") + " -p " + preset;
    ASSERT_EQ(run(of + " -o one.glb --threads 1").code, 0);
    ASSERT_EQ(run(of + " -o many.glb --threads 6").code, 0);
    EXPECT_EQ(content(folder_ / "one.glb"), content(folder_ / "many.glb")) << preset;
  }
}

TEST_F(Cli, ReadsStandardInputAndWritesStandardOutput) {
  const Ended piped = run("optimize - -o - -p weld,tipsify --with vertex-cache <" + spot());
  ASSERT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(piped.out.substr(0, 4), "glTF");
  ASSERT_EQ(run("optimize " + spot() + " -o file.glb -p weld,tipsify --with vertex-cache").code, 0);
  EXPECT_EQ(piped.out, content(folder_ / "file.glb"));
}

TEST_F(Cli, KeepsCompressionUnlessAskedOtherwise) {
  const std::string rover = "'" + testing::project_file("tests/compressed/rover.glb").string() + "'";
  ASSERT_EQ(run("optimize " + rover + " -o kept.glb -p tipsify").code, 0);
  EXPECT_NE(content(folder_ / "kept.glb").find("EXT_meshopt_compression"), std::string::npos);
  const Ended plain = run("optimize " + rover + " -o plain.glb -p tipsify --compression none");
  ASSERT_EQ(plain.code, 0);
  EXPECT_NE(plain.err.find("plain.glb: note: the output has "), std::string::npos) << plain.err;
  EXPECT_NE(plain.err.find("hint: data written uncompressed: "), std::string::npos) << plain.err;
  EXPECT_EQ(content(folder_ / "plain.glb").find("meshopt"), std::string::npos);
  const Ended newer = run("optimize " + rover + " -o newer.glb -p tipsify --compression khr-meshopt");
  ASSERT_EQ(newer.code, 0) << newer.err;
  EXPECT_NE(content(folder_ / "newer.glb").find("KHR_meshopt_compression"), std::string::npos);
  EXPECT_EQ(content(folder_ / "newer.glb").find("EXT_meshopt_compression"), std::string::npos);
  EXPECT_EQ(run("optimize " + rover + " -o other.glb --compression zip").code, 1);
  EXPECT_EQ(run("optimize " + rover + " -o other.glb --levels zip").code, 1);

  // Plain copies are a file of their own, for which standard output has no room.
  const std::string spot = "'" + testing::project_file("tests/compressed/spot_fallback.gltf").string() + "'";
  const Ended many = run("optimize " + spot + " -o - -p tipsify");
  EXPECT_EQ(many.code, 2);
  EXPECT_TRUE(many.out.empty());
  EXPECT_NE(many.err.find("--compression none"), std::string::npos) << many.err;
  EXPECT_EQ(run("optimize " + spot + " -o - -p tipsify --compression none").out.substr(0, 4), "glTF");
}

TEST_F(Cli, DracoKeepsWhatTheStagesMadeAndEdgebreakerWarns) {
  const std::string fox =
      "optimize " + model("animated/fox.glb") + " -p 'quantize, weld, tipsify' --with vertex-cache ";
  ASSERT_EQ(run(fox + "-o plain.glb").code, 0);
  const Ended kept = run(fox + "-o kept.glb --compression draco");
  ASSERT_EQ(kept.code, 0) << kept.err;
  EXPECT_EQ(kept.err.find("draco"), std::string::npos) << kept.err;  // all attributes lie on grids
  EXPECT_NE(content(folder_ / "kept.glb").find("KHR_draco_mesh_compression"), std::string::npos);
  EXPECT_LT(fs::file_size(folder_ / "kept.glb"), fs::file_size(folder_ / "plain.glb"));
  const auto figures = [&](const std::string& file) {
    const std::string text = run("measure " + file + " --with vertex-cache").out;
    return text.substr(std::min(text.find("acmr"), text.size()));
  };
  EXPECT_NE(figures("kept.glb"), "");
  EXPECT_EQ(figures("kept.glb"), figures("plain.glb"));
  const Ended free = run(fox + "-o free.glb --compression draco-edgebreaker");
  ASSERT_EQ(free.code, 0) << free.err;
  EXPECT_NE(free.err.find("warning: meshes: the edgebreaker method"), std::string::npos) << free.err;
}

TEST_F(Cli, WritesAsThePipelineSaysUnlessToldOtherwise) {
  const auto written = [&](const std::string& options) {
    const Ended ended = run("optimize " + model("animated/fox.glb") + " -o fox.glb --with vertex-cache " + options);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return content(folder_ / "fox.glb");
  };
  const auto has = [](const std::string& file, const char* text) { return file.find(text) != std::string::npos; };
  const std::string small = written("-p @small");
  EXPECT_TRUE(has(small, "KHR_meshopt_compression"));
  EXPECT_TRUE(has(small, "TRIANGLES"));
  EXPECT_TRUE(has(written("-p @game"), "EXT_meshopt_compression"));
  EXPECT_TRUE(has(written("-p @game"), "FOREDRAW_levels"));
  EXPECT_TRUE(has(written("-p @game --levels msft-lod"), "MSFT_lod"));
  EXPECT_FALSE(has(written("-p @small --compression none"), "meshopt"));
  EXPECT_FALSE(has(written("-p @small --compression keep"), "meshopt"));
  EXPECT_FALSE(has(written("-p @small --set output.compression=none"), "meshopt"));
  EXPECT_FALSE(has(written("-p @small --corners keep"), "TRIANGLES"));
  EXPECT_TRUE(has(written("-p @small --compression ext-meshopt"), "EXT_meshopt_compression"));
  EXPECT_LT(small.size(), written("-p @small --corners keep").size());
}

TEST_F(Cli, WritesDrawOrdersOnRequest) {
  const std::string in = model("static/spot.glb");
  ASSERT_EQ(
      run("optimize " + in + " -o out.glb -o draw-orders:orders.json -p 'occlusion-order(k=3)' --with vertex-cache")
          .code,
      0);
  const Json orders = Json::parse(content(folder_ / "orders.json"));
  EXPECT_EQ(orders["draw-orders"], 1);
  EXPECT_EQ(orders["tables"].size(), 1u);
  EXPECT_EQ(run("optimize " + in + " -o out.glb -o draw-orders:out.glb").code, 1);
  EXPECT_EQ(run("optimize " + in + " -o out.glb -o draw-orders:-").code, 1);
  EXPECT_EQ(run("optimize " + in + " -o out.glb -o draw-orders:a.json -o remap:a.json").code, 1);
}

TEST_F(Cli, WritesTheRemapTables) {
  ASSERT_EQ(run("optimize " + model("static/head.glb") + " -o out.glb -o remap:remap.json --with vertex-cache").code,
            0);
  const Json remap = Json::parse(content(folder_ / "remap.json"));
  const auto triangles = remap["draws"][0]["triangles"]["new-to-old"].get<std::vector<std::uint32_t>>();
  const Json& moved = remap["draws"][0]["vertices"];  // null: none did
  Diagnostics diagnostics;
  const auto before = read_gltf(testing::project_file("benchmarks/corpus/static/head.glb"), diagnostics);
  const auto after = read_gltf(folder_ / "out.glb", diagnostics);
  ASSERT_TRUE(before && after);
  const auto old = before->draws[0].levels[0].orders[0].indices.view();
  const auto now = after->draws[0].levels[0].orders[0].indices.view();
  ASSERT_EQ(triangles.size(), now.size() / 3);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::uint32_t vertex = old[3 * triangles[i / 3] + i % 3];
    EXPECT_EQ(now[i], moved.is_null() ? vertex : moved["old-to-new"][vertex].get<std::uint32_t>());
  }
}

TEST_F(Cli, MakesLevelsAndWritesOneAlone) {
  const Ended made = run("optimize " + spot() + " -o out.glb -o level2:two.obj -o level0:zero.glb -p @levels");
  ASSERT_EQ(made.code, 0) << made.err;
  Diagnostics diagnostics;
  const auto all = read_gltf(folder_ / "out.glb", diagnostics);
  const auto full = read_gltf(folder_ / "zero.glb", diagnostics);
  ASSERT_TRUE(all && full) << to_text(diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  const std::vector<Level>& levels = all->draws[0].levels;
  ASSERT_EQ(levels.size(), 4u);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    EXPECT_LT(levels[l].stream().triangle_count(), levels[l - 1].stream().triangle_count());
    EXPECT_GT(levels[l].error, levels[l - 1].error);
  }
  EXPECT_EQ(full->draws[0].levels.size(), 1u);
  EXPECT_EQ(full->draws[0].full().stream().indices, all->draws[0].full().stream().indices);
  const std::string two = content(folder_ / "two.obj");
  std::size_t faces = 0;
  for (std::size_t at = two.find("\nf "); at != std::string::npos; at = two.find("\nf ", at + 1)) ++faces;
  EXPECT_EQ(faces, levels[2].stream().triangle_count());
}

/// Through a file, an order of each level behind it, a file again, and other orders.
TEST_F(Cli, GeomorphsFollowTheirLevels) {
  const std::string stages = "weld, quadric-collapse, levels(keep-sequences=true), geomorphs, lookahead, vertex-fetch";
  const Ended made = run("optimize " + spot() + " -o out.glb -p '" + stages + "' --with vertex-cache");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.err.find("warning"), std::string::npos) << made.err;
  const auto told = [&](const std::string& file) {
    const Ended ended = run("inspect " + file);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out;
  };
  EXPECT_NE(told("out.glb").find("Spot: levels 3, vertices"), std::string::npos) << told("out.glb");
  const Ended again = run("optimize out.glb -o again.glb -p 'tipsify, vertex-fetch' --with vertex-cache");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.err.find("left out"), std::string::npos) << again.err;
  EXPECT_NE(told("again.glb").find("Spot: levels 3, vertices"), std::string::npos);
}

TEST_F(Cli, SaysWhichLevelIsNotThere) {
  const Ended none = run("optimize " + spot() + " -o level1:out.obj -p weld");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("out.obj: error: no draw has a level 1"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find("@levels"), std::string::npos) << none.err;
  const Ended few = run("optimize " + spot() + " -o level9:out.obj -p @levels");
  EXPECT_EQ(few.code, 2);
  EXPECT_NE(few.err.find("the coarsest is level 3"), std::string::npos) << few.err;
  EXPECT_EQ(run("optimize " + spot() + " -o level1:out.png -p @levels").code, 1);
  EXPECT_TRUE(files().empty());
}

TEST_F(Cli, TellsThePlanWithoutRunningIt) {
  const Ended plan = run("plan " + model("static/flight_helmet_notex.glb"));
  EXPECT_EQ(plan.code, 0);
  EXPECT_NE(plan.out.find("alpha-blended"), std::string::npos) << plan.out;
  EXPECT_EQ(Json::parse(run("plan " + spot() + " --json").out)["stages"].size(), 6u);
  EXPECT_TRUE(files().empty());
}

TEST_F(Cli, ShowsWhatThereIs) {
  EXPECT_NE(run("list").out.find("tipsify"), std::string::npos);
  EXPECT_EQ(run("list --kind evaluator").out.find("tipsify"), std::string::npos);
  EXPECT_NE(run("show tipsify").out.find("cache-size"), std::string::npos);
  EXPECT_EQ(Json::parse(run("show tipsify --json").out)["options"][0]["default"], 16);
  EXPECT_NE(run("show @default").out.find("stages"), std::string::npos);
  EXPECT_TRUE(Json::parse(run("schema").out).contains("$schema"));
  EXPECT_NE(run("inspect " + model("animated/fox.glb")).out.find("576"), std::string::npos);
  EXPECT_EQ(Json::parse(run("inspect --json " + model("animated/fox.glb")).out)["animations"].size(), 3u);
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_NE(run("--version").out.find("foredraw"), std::string::npos);
}

struct Mistake {
  const char* what;
  std::string arguments;
  int code;
  std::string says;
};

class Mistakes : public Cli, public ::testing::WithParamInterface<Mistake> {};

TEST_P(Mistakes, AreToldInOneClearLineAndNothingIsWritten) {
  std::ofstream(folder_ / "bad.glb") << "glTF but not really";
  std::ofstream(folder_ / "typo.toml")
      << "pipeline = 1\nstages = [\n  \"weld\",\n  { use = \"tipsify\", cache = 16 },\n]\n";
  std::ofstream(folder_ / "empty.glb");
  std::ofstream(folder_ / "service.toml")
      << "pipeline = 1\n[services]\noverdraw = { use = \"overdraw-raster\", views = 162 }\n";
  const auto before = files();
  std::string arguments = GetParam().arguments;
  if (const auto at = arguments.find("SPOT"); at != std::string::npos) arguments.replace(at, 4, spot());
  const Ended ended = run(arguments);
  EXPECT_EQ(ended.code, GetParam().code) << ended.err;
  EXPECT_NE(ended.err.find(GetParam().says), std::string::npos) << ended.err;
  EXPECT_TRUE(ended.out.empty()) << ended.out;
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Every, Mistakes,
    ::testing::Values(
        Mistake{"missing_file", "optimize nowhere.glb -o out.glb", 1, "nowhere.glb: error: there is no such file"},
        Mistake{"damaged_file", "optimize bad.glb -o out.glb", 2, "bad.glb: error:"},
        Mistake{"unknown_stage", "optimize SPOT -o out.glb -p tipsfy", 1, "did you mean 'tipsify'?"},
        Mistake{"unknown_option", "optimize SPOT -o out.glb -p typo.toml", 1, "typo.toml:4:"},
        Mistake{"option_out_of_range", "optimize SPOT -o out.glb -p 'tipsify(cache-size=2)'", 1, "3 to 1024 entries"},
        Mistake{"unmet_need", "optimize SPOT -o out.glb -p dot-rule", 1,
                "then 'linear-clusters' before it, and 'vertex-fetch' after it"},
        Mistake{"unknown_preset", "optimize SPOT -o out.glb -p @defualt", 1, "@default"},
        Mistake{"unknown_set", "optimize SPOT -o out.glb --set lookahead.cach-size=3", 1, "cache-size"},
        Mistake{"unknown_kind_of_output", "optimize SPOT -o out.xyz", 1, ".glb or .gltf"},
        Mistake{"missing_folder", "optimize SPOT -o no/such/folder/out.glb", 2, "no folder 'no/such/folder'"},
        Mistake{"no_output", "optimize SPOT", 1, "--output"},
        Mistake{"no_command", "", 1, "hint: there are optimize, plan"},
        Mistake{"misspelled_option", "optimize SPOT -o out.glb --levls keep", 1,
                "'--levls'\n    hint: did you mean '--levels'?"},
        Mistake{"option_like_no_other", "plan SPOT --quite-else=3", 1,
                "'--quite-else'\n    hint: foredraw plan --help"},
        Mistake{"option_of_a_letter", "measure SPOT -p weld", 1, "'-p'\n    hint: foredraw measure --help"},
        Mistake{"two_inputs", "optimize SPOT more.glb -o out.glb", 1, "one input too many: 'more.glb'"},
        Mistake{"hidden_from_where", "optimize SPOT -o out.glb -p hidden", 1, "say where cameras may be"},
        Mistake{"hidden_from_half_a_box", "optimize SPOT -o out.glb -p 'hidden(seen-from=box, box=\"0 0 0\")'", 1,
                "two corners"},
        Mistake{"unknown_subject", "optimize SPOT -o out.glb --set subjects.subject=car", 1, "mesh, character, scene"},
        Mistake{"unknown_sequence", "measure SPOT --with 'overdraw-raster(sequence=depth)'", 1,
                "table, file, material"},
        Mistake{"unknown_kind_before_a_colon", "optimize SPOT -o tangents:out.json", 1, "no kind of output 'tangents'"},
        Mistake{"unknown_product", "schema draw-order", 1, "did you mean 'draw-orders'?"},
        Mistake{"empty_file", "inspect empty.glb", 2, "empty.glb: error: the file is empty"},
        Mistake{"unknown_plugin_shown", "show tipsfy", 1, "did you mean 'tipsify'?"},
        Mistake{"unknown_kind_listed", "list --kind things", 1, "orderer"},
        Mistake{"bad_views", "measure SPOT --with 'overdraw-raster(views=100)'", 1, "162"},
        Mistake{"unknown_command", "optimise SPOT -o out.glb", 1, "did you mean 'optimize'?"},
        Mistake{"two_pipelines", "optimize SPOT -o out.glb -p weld -p tipsify", 1, "foredraw compare"},
        Mistake{"two_outputs_in_one_file", "optimize SPOT -o out.glb --report out.glb", 1, "two outputs"},
        Mistake{"report_in_no_folder", "optimize SPOT -o out.glb --report no/r.json", 2, "no folder 'no'"},
        Mistake{"empty_name", "measure ''", 1, "empty"},
        Mistake{"full_disk", "schema >/dev/full", 2, "cannot be written"},
        Mistake{"option_of_no_service", "plan SPOT -p service.toml", 1, "no option 'views'"},
        Mistake{"json_and_scene_on_one_stream", "optimize SPOT -o - --json", 1, "--report"}),
    [](const auto& info) { return std::string(info.param.what); });

TEST_F(Cli, KeepsWhatWasThereWhereAnOutputCanNotBePutInItsPlace) {
  std::ofstream(folder_ / "out.gltf") << "mine";
  fs::create_directories(folder_ / "out.bin");
  EXPECT_EQ(run("optimize " + spot() + " -o out.gltf -p weld,tipsify --with vertex-cache").code, 2);
  EXPECT_EQ(content(folder_ / "out.gltf"), "mine");
}

TEST_F(Cli, WritesThroughALink) {
  std::ofstream(folder_ / "real.glb") << "old";
  fs::create_symlink("real.glb", folder_ / "link.glb");
  ASSERT_EQ(run("optimize " + spot() + " -o link.glb -p weld --with vertex-cache").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.glb"));
  EXPECT_EQ(content(folder_ / "real.glb").substr(0, 4), "glTF");
}

TEST_F(Cli, TellsEveryMistakeOfAPipelineAtOnce) {
  const Ended ended = run("plan " + spot() + " -p 'weld(x=1), tipsfy, lookahead(y=2)'");
  EXPECT_EQ(ended.code, 1);
  for (const char* part : {"no option 'x'", "'tipsfy'", "no option 'y'"})
    EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
}

/// The reference pages in docs/ are what the program says of itself. FOREDRAW_UPDATE_GOLDEN=1 writes them anew.
TEST_F(Cli, ItsReferencePagesAreTheCommittedOnes) {
  const Json list = Json::parse(run("list --json").out);
  std::vector<std::string> expected;
  for (const Json& plugin : list["plugins"]) {
    const std::string name = plugin["name"];
    const fs::path page = testing::project_file("docs/reference/" + name + ".md");
    const std::string text = run("show " + name).out;
    if (std::getenv("FOREDRAW_UPDATE_GOLDEN") != nullptr) std::ofstream(page) << text;
    EXPECT_EQ(content(page), text) << name << ": FOREDRAW_UPDATE_GOLDEN=1 writes the page anew";
    expected.push_back(name + ".md");
  }
  std::vector<std::string> there;
  for (const auto& entry : fs::directory_iterator(testing::project_file("docs/reference")))
    there.push_back(entry.path().filename().string());
  // A page may be there of a plugin that this build leaves out.
  const Json left_out = list.value("left-out", Json::object());
  for (const std::string& page : there) {
    const bool is_left_out = left_out.contains(page.substr(0, page.size() - 3));
    EXPECT_TRUE(is_left_out || std::find(expected.begin(), expected.end(), page) != expected.end()) << page;
  }
}

TEST_F(Cli, SaysWhyAPluginIsLeftOut) {
  const Json list = Json::parse(run("list --json").out);
  const std::string text = run("list").out;
  const Json left_out = list.value("left-out", Json::object());
  for (const auto& [name, reason] : left_out.items()) {
    EXPECT_NE(text.find("This build leaves out " + name + ": " + reason.get<std::string>()), std::string::npos);
    const Ended shown = run("show " + name);
    EXPECT_EQ(shown.code, 1);
    EXPECT_NE(shown.err.find(reason.get<std::string>()), std::string::npos) << shown.err;
  }
}

}  // namespace
}  // namespace foredraw
