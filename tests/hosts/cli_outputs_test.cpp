// What the program writes: onto the disk, onto its standard output, in which form.

#include "support/on_corpus.h"

#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace foredraw::cli_outputs_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::content;
using testing::Ended;

class CliOutputs : public testing::OnCorpus {};

TEST_F(CliOutputs, MeshesGoToGltfAndBackToTheirOwnKind) {
  std::ofstream(folder_ / "strip.obj")
      << "# kept\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\nf 1 2 3\nf 3 4 5\nf 3 2 4\n";
  EXPECT_EQ(run("optimize strip.obj -o strip.glb").code, 0);
  EXPECT_EQ(run("inspect strip.glb").code, 0);
  const Ended back = run("optimize strip.obj -o again.obj");
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_EQ(content(folder_ / "again.obj").size(), content(folder_ / "strip.obj").size());
  EXPECT_EQ(content(folder_ / "again.obj").substr(0, 7), "# kept\n");
  const Ended other = run("optimize strip.obj -o strip.ply");
  EXPECT_EQ(other.code, 0);
  EXPECT_NE(other.err.find("strip.ply: warning: the scene was not read from .ply, so the file is made anew"),
            std::string::npos)
      << other.err;
  EXPECT_EQ(run("optimize strip.ply -o strip.stl").code, 0);
  EXPECT_EQ(run("optimize strip.glb -o strip.off").code, 0);
  const Ended unknown = run("optimize strip.obj -o strip.fbx");
  EXPECT_EQ(unknown.code, 1);
  EXPECT_NE(unknown.err.find("strip.fbx: error: scenes cannot be written as this kind of file"), std::string::npos)
      << unknown.err;
  std::ofstream(folder_ / "broken.stl") << "solid";
  const Ended broken = run("measure broken.stl");
  EXPECT_EQ(broken.code, 2);
  EXPECT_NE(broken.err.find("broken.stl:1:6: error: the file ends inside a solid"), std::string::npos) << broken.err;
}

TEST_F(CliOutputs, DrawsHeatMaps) {
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

TEST_F(CliOutputs, DrawsHeatMapsOfEachFileOfAFolder) {
  fs::create_directories(folder_ / "in/deep");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/a.glb");
  fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / "in/deep/a.glb");
  const Ended measured = run("measure in --heatmap maps");
  ASSERT_EQ(measured.code, 0) << measured.err;
  EXPECT_FALSE(fs::is_empty(folder_ / "maps/a.glb"));
  EXPECT_FALSE(fs::is_empty(folder_ / "maps/deep/a.glb"));
}

TEST_F(CliOutputs, WritesTheSameBytesAtAnyThreadCount) {
  for (const std::string preset : {"@default", "@levels", "@streaming"}) {
    const std::string of = "optimize " + model("animated/robot_expressive.glb") + " -p " + preset;
    ASSERT_EQ(run(of + " -o one.glb --threads 1").code, 0);
    ASSERT_EQ(run(of + " -o many.glb --threads 6").code, 0);
    EXPECT_EQ(content(folder_ / "one.glb"), content(folder_ / "many.glb")) << preset;
  }
}

TEST_F(CliOutputs, ReadsStandardInputAndWritesStandardOutput) {
  const Ended piped = run("optimize - -o - -p weld,tipsify --with vertex-cache <" + spot());
  ASSERT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(piped.out.substr(0, 4), "glTF");
  ASSERT_EQ(run("optimize " + spot() + " -o file.glb -p weld,tipsify --with vertex-cache").code, 0);
  EXPECT_EQ(piped.out, content(folder_ / "file.glb"));
}

TEST_F(CliOutputs, KeepsCompressionUnlessAskedOtherwise) {
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

TEST_F(CliOutputs, DracoKeepsWhatTheStagesMadeAndEdgebreakerWarns) {
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

TEST_F(CliOutputs, WritesAsThePipelineSaysUnlessToldOtherwise) {
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

TEST_F(CliOutputs, WritesDrawOrdersOnRequest) {
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

TEST_F(CliOutputs, WritesTheRemapTables) {
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

TEST_F(CliOutputs, MakesLevelsAndWritesOneAlone) {
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
TEST_F(CliOutputs, GeomorphsFollowTheirLevels) {
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

TEST_F(CliOutputs, WritesThroughALink) {
  std::ofstream(folder_ / "real.glb") << "old";
  fs::create_symlink("real.glb", folder_ / "link.glb");
  ASSERT_EQ(run("optimize " + spot() + " -o link.glb -p weld --with vertex-cache").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.glb"));
  EXPECT_EQ(content(folder_ / "real.glb").substr(0, 4), "glTF");
}

}  // namespace
}  // namespace foredraw::cli_outputs_test
