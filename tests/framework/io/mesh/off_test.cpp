#include <gtest/gtest.h>

#include "support/mesh_reading.h"

namespace foredraw::off_test {
namespace {

using testing::read_mesh;

std::string error(const std::string& text) { return read_mesh(MeshKind::off, text).error(); }

Scene read(const std::string& text) {
  auto made = read_mesh(MeshKind::off, text);
  if (!made.scene) throw std::runtime_error(made.error());
  return *made.scene;
}

const VertexStreams& vertices(const Scene& scene) { return *scene.draws.at(0).levels[0].vertices; }

TEST(MeshOff, PolygonsCommentsAndFaceColors) {
  const auto made = read_mesh(MeshKind::off,
                              "OFF # a square\n\n4 1 0\n0 0 0\n1 0 0 # two\n1 1 0\n# none\n0 1 0\n4 0 1 2 3 255 0 0\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "face-colors-left-out");
  EXPECT_EQ(made.scene->draws[0].levels[0].orders[0].indices.size(), 6u);
}

TEST(MeshOff, TheKeywordSaysWhatVerticesHave) {
  const Scene scene =
      read("STCNOFF 3 1 0\n0 0 0 0 0 1 10 20 30 255 0 1\n1 0 0 0 0 1 1 2 3 4 1 1\n0 1 0 0 0 1 5 6 7 8 0 0\n3 0 1 2\n");
  EXPECT_EQ(vertices(scene).bytes_per_vertex(), 12u + 12u + 8u + 4u);
  EXPECT_EQ(vertices(scene).find("COLOR_0")->format.component, Component::uint8);
  EXPECT_EQ(decode_component(*vertices(scene).find("TEXCOORD_0"), 0, 1), 0.0f);
  const Scene floats = read("COFF\n3 1\n0 0 0 1 0.5 0\n1 0 0 0 0 0\n0 1 0 1 1 1\n3 0 1 2\n");
  EXPECT_EQ(decode_component(*vertices(floats).find("COLOR_0"), 0, 1), 0.5f);
  EXPECT_EQ(read("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").draws.size(), 1u) << "the keyword may be missing";
}

TEST(MeshOff, WhyAPolygonBecomesAFanIsTold) {
  EXPECT_EQ(read_mesh(MeshKind::off, "OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n").told(), "polygons-as-fans");
  std::string text = "OFF\n40000 1 0\n", face = "40000";
  for (int i = 0; i < 40'000; ++i) {  // a comb: every second corner points inwards
    text += i < 39'998    ? std::to_string(i) + (i % 2 == 0 ? " 9 0\n" : " 1 0\n")
            : i == 39'998 ? "39998 0 0\n"
                          : "0 0 0\n";
    face += ' ' + std::to_string(i);
  }
  const auto comb = read_mesh(MeshKind::off, text + face + '\n');
  ASSERT_TRUE(comb.scene) << comb.error();
  EXPECT_EQ(comb.told(), "polygons-unfinished");
}

TEST(MeshOff, AFaceMayGoOverSeveralLines) {
  const Scene scene = read("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0\n1 # one\n\n 2\n4\n0 1\n2 3\n");
  const auto indices = scene.draws[0].levels[0].orders[0].indices.view();
  EXPECT_EQ(std::vector(indices.begin(), indices.end()), (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 0, 2, 3}));
}

TEST(MeshOff, TheFirstNumberMayTouchTheKeyword) {
  const std::string text = "  COFF3 1 0 # so\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n";
  const auto made = read_mesh(MeshKind::off, text);
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "keyword");
  EXPECT_EQ(vertices(*made.scene).count, 3u);
  EXPECT_EQ(read_mesh(MeshKind::off, text, {}, {.strict = true}).error(),
            "input.off:1:3: error: there is no space between the keyword and the number of 'COFF3'");
}

TEST(MeshOff, ColorsAndNormalsThatAreNotFiniteAreZero) {
  const auto made = read_mesh(
      MeshKind::off, "CNOFF\n3 1 0\n0 0 0 nan 0 1 0.5 0 0\n1 0 0 0 0 1 1 -inf 0\n0 1 0 0 0 1 1 0 0\n3 0 1 2\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "not-finite");
  EXPECT_EQ(decode_vec3(*vertices(*made.scene).find("NORMAL"))[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(decode_component(*vertices(*made.scene).find("COLOR_0"), 1, 1), 0);
}

TEST(MeshOff, RefusalsNameTheLine) {
  EXPECT_EQ(error("OFF BINARY\n"), "input.off:1:5: error: binary OFF is not read");
  EXPECT_EQ(error("4OFF\n1 0 0\n"),
            "input.off:1:1: error: expected OFF, with at most ST, C or N before it, found '4OFF'");
  EXPECT_EQ(error("OFF\n1000000000 0 0\n0 0 0\n"),
            "input.off:2:1: error: 1000000000 vertices do not fit in the 6 bytes that are left");
  EXPECT_EQ(error("OFF\n1 18446744073709551615 0\n0 0 0\n"),
            "input.off:2:3: error: 18446744073709551615 faces do not fit in the 6 bytes that are left");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), "input.off:4:5: error: 'nan' is not finite");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "input.off:4:4: error: a number is missing here");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
            "input.off:6:7: error: the face names vertex 7, but there are 3, counted from 0");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
            "input.off:6:1: error: a face of '3' corners does not fit its lines");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
            "input.off:6:1: error: a face of '4000000000' corners does not fit its lines");
  EXPECT_EQ(error("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n"),
            "input.off:6:1: error: a face of '3' corners does not fit its lines")
      << "the next line is no rest of a face, for it goes on";
  EXPECT_EQ(error("COFF\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 1 2 3\n0 1 0 1 2 3 4\n3 0 1 2\n"),
            "input.off:4:6: error: the colour has 3 numbers, but that of the first vertex has 4");
  EXPECT_EQ(error("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "input.off:7:1: error: the file ends before all vertices and faces are there");
}

}  // namespace
}  // namespace foredraw::off_test
