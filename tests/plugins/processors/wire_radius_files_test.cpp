// Wires through stages and files: what is written, what comes back, and what stays as it was.
#include "support/wire_scenes.h"

#include "support/edit_product.h"

#include <foredraw/io/side_files.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foredraw::wire_radius_files_test {
namespace {

using ::testing::HasSubstr;
using testing::triangles_of;
using testing::with_wires;

TEST(WireRadiusFiles, AReportTellsOnceWhatWasFoundInTheWordsOfTheProduct) {
  const Result result = testing::run("wire-radius", testing::scene_of_three());
  std::vector<std::string> found;
  for (const NoteRecord& note : result.report.stages[0].notes) {
    if (note.message.find("1 ribbon") != std::string::npos) found.push_back(note.message);
  }
  EXPECT_EQ(found, wires_product()->told(result.scene).lines);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0], HasSubstr("1 tube, 1 ribbon and 0 nets, together "));
}

TEST(WireRadiusFiles, WiresAreTheLastTriangles) {
  const Wires* wires = with_wires().products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  ASSERT_EQ(wires->draws.size(), 1u);
  EXPECT_EQ(wires->draws[0].wires.size(), 2u);
  EXPECT_GT(wires->draws[0].first_triangle, 0u);
  EXPECT_EQ(wires_product()->difference(with_wires()), "");
}

/// A ribbon is marked, and says in which direction it is broad; a tube is round.
TEST(WireRadiusFiles, FlatOnesAreMarked) {
  for (const auto& [name, mark] : {std::pair{"flat rope", 1.0f}, {"net", 1.0f}, {"lamp post", 0.0f}}) {
    const Scene scene = testing::run("wire-radius", testing::scene_of_file(testing::mixed({name}))).scene;
    const VertexStreams& vertices = *scene.draws[0].full().vertices;
    const VertexStream *wires = vertices.find(wire_semantic), *axes = vertices.find(wire_axis_semantic);
    ASSERT_TRUE(wires != nullptr && axes != nullptr) << name;
    std::size_t marked = 0;
    for (std::size_t v = 0; v < vertices.count; ++v) {
      if (decode_component(*wires, v, 3) == 0) continue;
      ++marked;
      EXPECT_EQ(decode_component(*axes, v, 3), mark) << name;
      glm::dvec3 to_centre, axis;
      for (int c = 0; c < 3; ++c) {
        to_centre[c] = decode_component(*wires, v, static_cast<std::size_t>(c));
        axis[c] = decode_component(*axes, v, static_cast<std::size_t>(c));
      }
      EXPECT_NEAR(glm::length(axis), 1, 1e-5);
      EXPECT_GT(glm::length(to_centre), 0) << name;
      if (mark == 1) {
        EXPECT_NEAR(glm::dot(to_centre, axis), 0, 0.2 * glm::length(to_centre)) << name;
      }
    }
    EXPECT_GT(marked, 0u);
  }
}

/// What does not know wires draws the same triangles of the same vertices with the same material.
TEST(WireRadiusFiles, NothingElseChanges) {
  EXPECT_EQ(triangles_of(with_wires()), triangles_of(testing::scene_of_three()));
  const VertexStreams &before = *testing::scene_of_three().draws[0].full().vertices,
                      &after = *with_wires().draws[0].full().vertices;
  ASSERT_EQ(after.base.size(), before.base.size() + 2);
  EXPECT_TRUE(after.find("POSITION")->bytes == before.find("POSITION")->bytes);
  EXPECT_EQ(with_wires().draws[0].material, testing::scene_of_three().draws[0].material);
}

/// Without its extension, and then without its attributes: the same picture, for the rest of the file is as it was.
TEST(WireRadiusFiles, StrippedItIsTheSameScene) {
  Scene scene = with_wires();
  wires_product()->leave_out(scene);
  EXPECT_FALSE(scene.products.has(Wires::product));
  EXPECT_EQ(scene.draws[0].full().vertices->base.size(),
            testing::scene_of_three().draws[0].full().vertices->base.size());
  EXPECT_EQ(triangles_of(scene), triangles_of(testing::scene_of_three()));
  const std::string json = testing::json_of(testing::written_with_wires(scene)).dump();
  EXPECT_EQ(json.find("FOREDRAW"), std::string::npos);
}

TEST(WireRadiusFiles, ComeBack) {
  Diagnostics diagnostics;
  const auto again = testing::read_with_wires(testing::written_with_wires(with_wires()), diagnostics);
  ASSERT_TRUE(again);
  EXPECT_TRUE(diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(*again->products.find<Wires>(), *with_wires().products.find<Wires>());
  EXPECT_EQ(testing::written_with_wires(*again), testing::written_with_wires(with_wires()));
}

TEST(WireRadiusFiles, TheSameBytesAtAnyThreadCount) {
  const auto bytes = [](int threads) {
    Registry registry;
    add_built_in_plugins(registry);
    Diagnostics diagnostics;
    const auto plan =
        foredraw::plan(*parse_line("wire-radius", diagnostics), registry, testing::scene_of_three(), diagnostics);
    const Executor executor(threads);
    Analyses analyses;
    return testing::written_with_wires(optimize(*plan, testing::scene_of_three(), {executor, analyses}).scene);
  };
  EXPECT_EQ(bytes(1), bytes(4));
}

/// Ranges keep their triangles; wires are the same after weld, orders, and reading again.
TEST(WireRadiusFiles, LaterStagesKeepThem) {
  Diagnostics diagnostics;
  const Scene moved = testing::run("weld, tipsify, vertex-fetch", with_wires()).scene;
  const auto again = testing::read_with_wires(testing::written_with_wires(moved), diagnostics);
  ASSERT_TRUE(again);
  const Wires* wires = again->products.find<Wires>();
  ASSERT_NE(wires, nullptr);
  EXPECT_EQ(*wires, *with_wires().products.find<Wires>());
  const std::uint32_t first = wires->draws[0].first_triangle;
  EXPECT_EQ(triangles_of(*again, first), triangles_of(with_wires(), first));
  const Scene found_again = testing::run("wire-radius", *again).scene;
  ASSERT_NE(found_again.products.find<Wires>(), nullptr);
  EXPECT_EQ(triangles_of(found_again, first), triangles_of(with_wires(), first));
}

TEST(WireRadiusFiles, AreLeftOutWhereTrianglesGo) {
  const Result result = testing::run("wire-radius, quadric-collapse, simplify(ratio=0.5)", testing::scene_of_three());
  EXPECT_FALSE(result.scene.products.has(Wires::product));
  EXPECT_EQ(result.scene.draws[0].full().vertices->find(wire_semantic), nullptr);
}

TEST(WireRadiusFiles, SomethingShorterStaysAndSaysSo) {
  const Result result = testing::run("wire-radius(slender=500)", testing::scene_of_three());
  EXPECT_FALSE(result.scene.products.has(Wires::product));
}

/// Where ribbons of a net cross, vertices are there for each of them, alike in all but their wire; triangles stay.
TEST(WireRadiusFiles, CrossingsHaveVerticesForEachRibbon) {
  const Scene before = testing::scene_of_file(testing::mixed({"net"})),
              after = testing::run("wire-radius", before).scene;
  ASSERT_TRUE(after.products.has(Wires::product));
  EXPECT_GT(after.draws[0].full().vertices->count, before.draws[0].full().vertices->count);
  EXPECT_EQ(triangles_of(after), triangles_of(before));
  EXPECT_EQ(wires_product()->difference(after), "");
  Diagnostics diagnostics;
  const auto again = testing::read_with_wires(testing::written_with_wires(after), diagnostics);
  ASSERT_TRUE(again && diagnostics.empty()) << to_text(diagnostics);
  EXPECT_EQ(again->products.find<Wires>()->draws, after.products.find<Wires>()->draws);
}

TEST(WireRadiusFiles, BlendedMaskedAndLinesAreLeftAlone) {
  for (const char* mode : {"BLEND", "MASK"}) {
    testing::GltfBuilder builder = testing::mixed({"flat rope"});
    builder.json["meshes"][0]["primitives"][0]["material"] = builder.add("materials", {{"alphaMode", mode}});
    EXPECT_FALSE(testing::run("wire-radius", testing::scene_of_file(builder)).scene.products.has(Wires::product))
        << mode;
  }
  testing::GltfBuilder lines = testing::mixed({"flat rope"});
  lines.json["meshes"][0]["primitives"][0]["mode"] = 1;
  EXPECT_FALSE(testing::run("wire-radius", testing::scene_of_file(lines)).scene.products.has(Wires::product));
}

TEST(WireRadiusFiles, ShadersAreWritten) {
  for (const char* kind : {".glsl", ".hlsl"}) {
    const SideFile file = wires_product()->side_file(with_wires(), kind, "");
    EXPECT_THAT(std::get<std::string>(file.content), HasSubstr("WIRE_VERTEX"));
  }
}
}  // namespace
}  // namespace foredraw::wire_radius_files_test
