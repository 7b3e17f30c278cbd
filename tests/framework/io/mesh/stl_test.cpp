#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "support/mesh_reading.h"

namespace foredraw::stl_test {
namespace {

using ::testing::HasSubstr;
using testing::read_mesh;
using Triangle = std::array<float, 9>;

constexpr Triangle one{0, 0, 0, 1, 0, 0, 0, 1, 0};
constexpr Triangle two{1, 0, 0, 1, 1, 0, -0.0f, 1, 0};

/// `attributes`: of the first triangles; those of the others are 0.
std::string binary(std::string header, const std::vector<Triangle>& triangles, std::uint32_t count,
                   std::vector<std::uint16_t> attributes = {}) {
  attributes.resize(triangles.size());
  header.resize(80, ' ');
  header.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    header.append(12, '\0');
    header.append(reinterpret_cast<const char*>(triangles[t].data()), 36);
    header += static_cast<char>(attributes[t] & 255);
    header += static_cast<char>(attributes[t] >> 8);
  }
  return header;
}

/// Of the first corners of both triangles, or nothing.
std::vector<std::array<int, 3>> colors_of(const Scene& scene) {
  const Level& level = scene.draws[0].levels[0];
  const VertexStream* stream = level.vertices->find("COLOR_0");
  std::vector<std::array<int, 3>> found;
  for (std::size_t corner = 0; stream != nullptr && corner < 6; corner += 3) {
    const std::uint32_t vertex = level.orders[0].indices.view()[corner];
    const auto channel = [&](std::size_t c) { return static_cast<int>(stream->bytes.view()[3 * vertex + c]); };
    found.push_back({channel(0), channel(1), channel(2)});
  }
  return found;
}

std::vector<std::array<int, 3>> colors(const std::string& header, const std::vector<std::uint16_t>& attributes) {
  const auto made = read_mesh(MeshKind::stl, binary(header, {one, two}, 2, attributes));
  if (!made.scene) throw std::runtime_error(made.error());
  return colors_of(*made.scene);
}

std::string facet(const std::string& vertices) {
  return "facet normal 0 0 1\n outer loop\n" + vertices + " endloop\nendfacet\n";
}
const std::string triangle = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n");

std::string error(const std::string& text) { return read_mesh(MeshKind::stl, text).error(); }

TEST(MeshStl, CornersAtOnePlaceAreOneVertex) {
  const auto made = read_mesh(MeshKind::stl, binary("made by hand", {one, two}, 2));
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.scene->draws[0].levels[0].vertices->count, 4u) << "and -0 is 0";
  EXPECT_EQ(made.scene->draws[0].levels[0].vertices->base.size(), 1u) << "a facet's normal follows from its corners";
}

TEST(MeshStl, ColorsAreReadByTheConventionThatTheFileFollows) {
  using Colors = std::vector<std::array<int, 3>>;
  constexpr std::uint16_t lowest = 31, highest = 31 << 10, marked = 0x8000;
  const std::string magics = "COLOR=\x10\x20\x30\xff,MATERIAL=";
  EXPECT_EQ(colors("", {lowest | marked, highest | marked}), (Colors{{0, 0, 255}, {255, 0, 0}}));
  EXPECT_EQ(colors("", {16 << 5 | marked, 0}), (Colors{{0, 132, 0}, {255, 255, 255}}));
  EXPECT_EQ(colors(magics, {lowest, highest}), (Colors{{255, 0, 0}, {0, 0, 255}}));
  EXPECT_EQ(colors(magics, {lowest | marked, 0}), (Colors{{16, 32, 48}, {0, 0, 0}}));
  EXPECT_EQ(colors(magics, {0, 0}), (Colors{{16, 32, 48}, {16, 32, 48}})) << "a program that writes no attributes";
}

TEST(MeshStl, VerticesOfTwoColorsAreTwo) {
  const auto count = [](std::vector<std::uint16_t> attributes) {
    return read_mesh(MeshKind::stl, binary("", {one, two}, 2, attributes)).scene->draws[0].levels[0].vertices->count;
  };
  EXPECT_EQ(count({0x8001, 0x8001}), 4u);
  EXPECT_EQ(count({0x8001, 0x8002}), 6u);
}

TEST(MeshStl, AttributesThatFollowNoConventionAreLeftOut) {
  EXPECT_TRUE(colors("", {0x2020, 0x2020}).empty());
  EXPECT_TRUE(colors("", {0x801f, 0x7c00}).empty()) << "a number of something may set the highest bit by chance";
  EXPECT_TRUE(colors(std::string(72, ' ') + "COLOR=12", {0, 0}).empty()) << "the header ends inside the colour";
}

TEST(MeshStl, ANoteSaysByWhichRuleAttributesAreReadOrNot) {
  const auto note = [](const std::string& header, std::vector<std::uint16_t> attributes) {
    const auto made = read_mesh(MeshKind::stl, binary(header, {one, two}, 2, attributes));
    return made.diagnostics.all().empty() ? std::string() : to_text(made.diagnostics.all().front());
  };
  EXPECT_EQ(note("", {}), "");
  EXPECT_THAT(note("COLOR=1234", {}), HasSubstr("as Materialise Magics writes them"));
  EXPECT_THAT(note("", {0x8001}), HasSubstr("as VisCAM and SolidView write them"));
  EXPECT_THAT(note("", {0x8001}), HasSubstr("read from 1 attributes"));
  EXPECT_THAT(note("", {0x8001, 0x0001}), HasSubstr("the attribute bytes of 2 triangles are left out"));
  EXPECT_THAT(note("", {0x8001, 0x0001}), HasSubstr("is 0 in 1 of them"));
}

TEST(MeshStl, ColorsComeBackFromAReorderedFile) {
  for (const bool magics : {false, true}) {
    const std::vector<std::uint16_t> attributes{0x801f, magics ? std::uint16_t{0x0420} : std::uint16_t{0x8420}};
    const auto made = read_mesh(MeshKind::stl, binary(magics ? "COLOR=1234" : "", {one, two}, 2, attributes));
    ASSERT_TRUE(made.scene) << made.error();
    Diagnostics diagnostics;
    const auto file = encode_mesh_file(testing::reversed(*made.scene), MeshKind::stl, "out.stl", diagnostics);
    ASSERT_TRUE(file);
    const auto again = read_mesh(MeshKind::stl, testing::text_of(*file));
    EXPECT_EQ(testing::drawn(*made.scene), testing::drawn(*again.scene));
    EXPECT_NE(colors_of(*made.scene), colors_of(*again.scene)) << "the triangles have changed places";
  }
}

TEST(MeshStl, AHeaderThatSaysSolidIsBelievedInTextAlone) {
  EXPECT_TRUE(read_mesh(MeshKind::stl, binary("solid lie", {one}, 1)).scene);
  EXPECT_EQ(error(binary("solid lie", {one}, 2)),
            "input.stl: error: byte 80: 2 triangles of 50 bytes each do not fit in the 50 bytes that are left");
}

TEST(MeshStl, CountsAreHeldAgainstTheBytesThatAreThere) {
  for (const std::uint32_t count : {2u, 0x80000000u, 0xffffffffu}) {
    EXPECT_NE(error(binary("", {one}, count)).find("byte 80: " + std::to_string(count)), std::string::npos);
  }
  EXPECT_EQ(error(binary("", {one}, 0)), "input.stl: error: the file holds no vertices");
  EXPECT_EQ(read_mesh(MeshKind::stl, binary("", {one, two}, 1)).told(), "bytes-left-out");
}

TEST(MeshStl, TextMayHaveAByteOrderMark) {
  const auto made = read_mesh(MeshKind::stl, "\xEF\xBB\xBFsolid a\n" + triangle + "endsolid\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.scene->meshes[0].name, "a");
}

TEST(MeshStl, LinesMayEndAsOnOldMacintoshesOrNotAtAll) {
  for (const char line_end : {'\r', ' '}) {
    std::string text = "solid a b\n" + triangle + triangle + "endsolid a b\n";
    if (line_end == '\r') text += "solid c\n" + triangle + "endsolid c\n";
    std::ranges::replace(text, '\n', line_end);
    const auto made = read_mesh(MeshKind::stl, text);
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.scene->meshes.size(), line_end == '\r' ? 2u : 1u);
    EXPECT_EQ(made.scene->meshes[0].name, "a b");
    EXPECT_EQ(made.scene->draws[0].levels[0].orders[0].indices.size(), 6u);
  }
  EXPECT_EQ(error("solid a " + triangle + "endsolid a solid b " + triangle + "endsolid b"),
            "input.stl:8:20: error: expected 'solid', found 'facet'")
      << "nothing tells where a name ends";
}

TEST(MeshStl, EachSolidIsAMesh) {
  const auto made = read_mesh(MeshKind::stl, "solid a b\n" + triangle + "endsolid a b\nSOLID c\n" + triangle +
                                                 triangle + "EndSolid\nsolid empty\nendsolid empty\n");
  ASSERT_TRUE(made.scene) << made.error();
  ASSERT_EQ(made.scene->meshes.size(), 2u);
  EXPECT_EQ(made.scene->meshes[0].name, "a b");
  EXPECT_EQ(made.scene->draws[1].levels[0].vertices->count, 3u);
  EXPECT_EQ(made.scene->draws[1].levels[0].orders[0].indices.size(), 6u);
}

TEST(MeshStl, RefusalsNameThePlace) {
  EXPECT_EQ(error(""), "input.stl: error: the file has no solid");
  EXPECT_EQ(error("solid\n" + triangle), "input.stl:9:1: error: the file ends inside a solid");
  EXPECT_EQ(error("solid\n" + facet("vertex 0 0 1e99\n")),
            "input.stl:4:12: error: '1e99' does not fit into a 32-bit float");
  EXPECT_EQ(error("solid\n" + facet("vertex 0 0\n")), "input.stl:5:2: error: 'endloop' is not a number");
  EXPECT_EQ(error("solid\nloop\n"), "input.stl:2:1: error: expected 'facet' or 'endsolid', found 'loop'");
  Triangle bad = one;
  bad[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error(binary("", {two, bad}, 2)), "input.stl: error: byte 162: a coordinate of triangle 1 is not finite");
}

}  // namespace
}  // namespace foredraw::stl_test
