// PLY in each encoding, with what other programs put into it.
#include <gtest/gtest.h>

#include <bit>

#include "support/mesh_reading.h"

namespace foredraw::ply_test {
namespace {

using testing::read_mesh;

/// Numbers put one behind the other in either byte order.
class Binary {
 public:
  explicit Binary(bool big) : big_(big) {}

  template <class T>
  Binary& put(std::initializer_list<T> values) {
    for (T value : values) {
      std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
      if (big_) std::reverse(raw.begin(), raw.end());
      bytes.append(raw.data(), raw.size());
    }
    return *this;
  }

  std::string bytes;

 private:
  bool big_;
};

const std::string head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string places = "0 0 0\n1 0 0\n0 1 0\n";
const std::string face_element = "element face 1\nproperty list uchar int vertex_indices\n";

Scene read(const std::string& text) {
  auto made = read_mesh(MeshKind::ply, text);
  if (!made.scene) throw std::runtime_error(made.error());
  return *made.scene;
}
std::string error(const std::string& text) { return read_mesh(MeshKind::ply, text).error(); }
const VertexStreams& vertices(const Scene& scene) { return *scene.draws.at(0).levels[0].vertices; }
std::vector<std::uint32_t> indices(const Scene& scene) {
  const auto view = scene.draws.at(0).levels[0].orders[0].indices.view();
  return {view.begin(), view.end()};
}

TEST(MeshPly, BothByteOrdersWithPropertiesOfAllSorts) {
  for (const bool big : {false, true}) {
    const std::string header =
        std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\r\ncomment who made it\r\nelement vertex 3\r\nproperty double x\r\nproperty double y\r\n"
        "property double z\r\nproperty float quality\r\nproperty uchar red\r\nproperty uchar green\r\n"
        "property uchar blue\r\nproperty float s\r\nproperty float t\r\nelement face 1\r\nproperty uchar flags\r\n"
        "property list uchar int vertex_indices\r\nproperty list ushort float weights\r\nelement edge 1\r\n"
        "property int a\r\nend_header\r\n";
    Binary body(big);
    for (const double x : {0.0, 1.0, 0.5}) {
      body.put<double>({x, x * x, 0}).put<float>({7}).put<std::uint8_t>({10, 20, 255}).put<float>({0.25f, 0.75f});
    }
    body.put<std::uint8_t>({9, 3}).put<std::int32_t>({2, 0, 1}).put<std::uint16_t>({2}).put<float>({1, 2});
    body.put<std::int32_t>({5});
    const auto made = read_mesh(MeshKind::ply, header + body.bytes);
    ASSERT_TRUE(made.scene) << made.error();
    EXPECT_EQ(made.told(), "properties-left-out");
    EXPECT_EQ(indices(*made.scene), (std::vector<std::uint32_t>{2, 0, 1}));
    EXPECT_EQ(decode_vec3(*vertices(*made.scene).find("POSITION"))[2], glm::vec3(0.5f, 0.25f, 0));
    EXPECT_EQ(decode_component(*vertices(*made.scene).find("COLOR_0"), 1, 2), 1.0f);
    EXPECT_EQ(vertices(*made.scene).find("COLOR_0")->format.component, Component::uint8) << "8 bits stay 8 bits";
    EXPECT_EQ(decode_component(*vertices(*made.scene).find("TEXCOORD_0"), 0, 1), 0.25f);
  }
}

TEST(MeshPly, AVertexIsARecordWithItsNumber) {
  const Scene scene = read(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n" +
      face_element + "end_header\n0 0 0 0 0 1\n5 5 5 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 2 3\n");
  EXPECT_EQ(vertices(scene).count, 4u) << "one that no face names stays";
  EXPECT_EQ(indices(scene), (std::vector<std::uint32_t>{0, 2, 3}));
  EXPECT_TRUE(scene.draws[0].traits.has(traits::normals));
}

TEST(MeshPly, FacesMayComeFirst) {
  EXPECT_EQ(
      indices(read("ply\nformat ascii 1.0\n" + face_element +
                   "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n" +
                   places)),
      (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshPly, TextureCoordinatesOfCornersMakeSeams) {
  const Scene scene =
      read(head + "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
           "end_header\n" + places + "3 0 1 2 6 0 0 1 0 0 1\n3 0 1 2 6 0.5 0 1 0 0 1\n");
  EXPECT_EQ(vertices(scene).count, 4u);
  EXPECT_EQ(indices(scene), (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 2}));
  EXPECT_EQ(
      error(head + "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
            "end_header\n" + places + "3 0 1 2 4 0 0 1 0\n"),
      "input.ply:14:1: error: found 4 texture coordinates for 3 corners");
}

TEST(MeshPly, StripsAreTrianglesWoundAlike) {
  // Turned round, begun anew, and led on by corners that stand twice.
  const std::vector<std::uint32_t> expected{0, 1, 2, 2, 1, 3, 3, 2, 4, 5, 1, 0};
  const std::initializer_list<std::int32_t> first{0, 1, 2, 3, -1, 3, 2, 4, 4, 5}, second{5, 1, 0, -1, 2, 4};
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 6\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
           "element tristrips 2\nproperty list int int vertex_indices\nend_header\n";
  };
  EXPECT_EQ(indices(read(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n"
                                           "10 0 1 2 3 -1\n3 2 4 4 5\n6 5 1 0 -1 2 4\n")),
            expected);
  for (const bool big : {false, true}) {
    Binary body(big);
    for (std::uint8_t v = 0; v < 6; ++v) body.put<std::uint8_t>({v, static_cast<std::uint8_t>(v * v), 0});
    body.put<std::int32_t>({10}).put(first).put<std::int32_t>({6}).put(second);
    EXPECT_EQ(indices(read(header(big ? "binary_big_endian" : "binary_little_endian") + body.bytes)), expected);
  }
}

TEST(MeshPly, LinesOfTheHeaderThatAreNoneOfPlysAreSkipped) {
  const std::string text =
      "ply\nformat ascii 1.0\nMade by hand\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\n" +
      face_element + "end_header\n" + places;
  const auto made = read_mesh(MeshKind::ply, text + "3 0 1 2\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "header-line");
  EXPECT_EQ(read_mesh(MeshKind::ply, text + "3 0 1 2\n", {}, {.strict = true}).error(),
            "input.ply:3:1: error: 'Made' is not a keyword of a PLY header");
  // It could have been a property of the last element.
  EXPECT_EQ(error(text + "3 0 1 2 7\n"), "input.ply:3:1: error: 'Made' is not a keyword of a PLY header");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nMade by hand\n"),
            "input.ply:3:1: error: 'Made' is not a keyword of a PLY header");
}

TEST(MeshPly, HeadersMayEndTheirLinesAsOldMacintoshes) {
  std::string header = head + face_element + "end_header\n";
  header.replace(header.find("ascii"), 5, "binary_little_endian");
  std::ranges::replace(header, '\n', '\r');
  Binary body(false);
  body.bytes = "\n\n\n\n";  // the first number, which is no end of a line
  body.put<float>({0, 0, 1, 0, 0, 0, 1, 0}).put<std::uint8_t>({3}).put<std::int32_t>({0, 1, 2});
  EXPECT_EQ(indices(read(header + body.bytes)), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshPly, PropertiesThatAreNotReadMayShareAName) {
  const std::string gaps = "property float gap\nproperty float gap\n";
  const auto made = read_mesh(MeshKind::ply, head + gaps + "end_header\n0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(made.told(), "properties-left-out property-twice");
  EXPECT_EQ(error(head + "property float x\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n"),
            "input.ply:7:10: error: the element has two properties 'x'");
}

TEST(MeshPly, LinesTellRecordsApartWhereThereAreJustAsMany) {
  const std::string text = head + "property list uchar int unused\n" + face_element + "end_header\n";
  const auto more = read_mesh(MeshKind::ply, text + "0 0 0 1 9 8\n1 0 0 0\n\n0 1 0 0\n3 0 1 2 9 1 1\n");
  ASSERT_TRUE(more.scene) << more.error();
  EXPECT_EQ(more.told(), "properties-left-out line-values");
  EXPECT_EQ(more.diagnostics.all().back().places, 2u);
  EXPECT_EQ(indices(*more.scene), (std::vector<std::uint32_t>{0, 1, 2}));
  const auto fewer = read_mesh(MeshKind::ply, text + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  ASSERT_TRUE(fewer.scene) << fewer.error();
  EXPECT_EQ(fewer.told(), "properties-left-out line-values");
  EXPECT_EQ(error(text + "0 0 0 0\n1 0\n0 1 0 0\n3 0 1 2\n"), "input.ply:12:4: error: the line ends inside its record");
  EXPECT_EQ(error(text + "0 0 0 0\n1 0 0 0\n0 1 0 0\n3 0 1\n"),
            "input.ply:14:6: error: the line ends inside its record");
  // With a line too many, values alone tell records apart.
  EXPECT_EQ(indices(read(text + "0 0 0\n0 1 0 0\n0 0 1 0\n0 3 0 1 2\n\n1 1")), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshPly, RefusalsNameThePlace) {
  EXPECT_EQ(error(""), "input.ply:1:1: error: the first line must be 'ply'");
  EXPECT_EQ(error("ply\nformat ascii 2.0\n"), "input.ply:2:14: error: expected version 1.0, found '2.0'");
  EXPECT_EQ(
      error("ply\nformat middle 1.0\n"),
      "input.ply:2:8: error: 'middle' is not a PLY format; expected ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(error(head), "input.ply:7:1: error: the file ends inside its header");
  EXPECT_EQ(error(head + face_element + "end_header\n" + places + "3 0 1 3\n"),
            "input.ply:13:1: error: the face names vertex 3, but there are 3, counted from 0");
  EXPECT_EQ(error(head + face_element + "end_header\n" + places + "3 0 1 -1\n"),
            "input.ply:13:7: error: the face names vertex -1, which cannot exist");
  EXPECT_EQ(error(head + face_element + "end_header\n" + places + "200 0 1 2\n"),
            "input.ply:13:1: error: a list of 200 values does not fit in the 7 bytes that are left");
  EXPECT_EQ(error(head + "end_header\n0 0 0\n0 inf 0\n0 0 0\n"),
            "input.ply:9:3: error: 'y' is not a finite 32-bit float");
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  EXPECT_EQ(error(head + strips + places + "3 0 1 -2\n"),
            "input.ply:13:7: error: the face names vertex -2, which cannot exist");
  EXPECT_EQ(error(head + strips + places + "4 0 1 2 3\n"),
            "input.ply:13:9: error: the face names vertex 3, but there are 3, counted from 0");
  EXPECT_EQ(error(head + "element tristrips 1\nproperty int vertex_indices\nend_header\n" + places + "3\n"),
            "input.ply:7:19: error: the elements 'tristrips' have no list 'vertex_indices'");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
            "input.ply: error: there is no element 'vertex' with x, y and z");
}

TEST(MeshPly, WhatIsNotUsedMayHaveAnyValue) {
  const auto text = [](const std::string& properties, const std::string& values) {
    return head + properties + face_element + "property float f\nproperty list uchar float g\nend_header\n0 0 0 " +
           values + "\n1 0 0 " + values + "\n0 1 0 " + values + "\n3 0 1 2 -inf 2 nan 1e99\n";
  };
  // A normal without z and a colour without blue are used as little as what has no meaning at all.
  for (const std::string value : {"nan", "-inf", "1e39", "-nan(ind)", "1.#QNAN"}) {
    const auto made = read_mesh(MeshKind::ply, text("property float quality\nproperty float nx\nproperty float red\n",
                                                    value + ' ' + value + ' ' + value));
    ASSERT_TRUE(made.scene) << value << ' ' << made.error();
    EXPECT_EQ(made.told(), "properties-left-out");
    EXPECT_EQ(indices(*made.scene), (std::vector<std::uint32_t>{0, 1, 2}));
  }
  EXPECT_TRUE(read_mesh(MeshKind::ply, text("property uchar small\n", "1000")).scene);
  const std::string colors = "property float red\nproperty float green\nproperty float blue\n";
  const auto colored = read_mesh(MeshKind::ply, text(colors, "1 nan 1e99"));
  ASSERT_TRUE(colored.scene) << colored.error();
  EXPECT_EQ(colored.told(), "properties-left-out not-finite") << "what is used becomes 0";
  EXPECT_EQ(colored.diagnostics.all().back().places, 6u);
  EXPECT_EQ(decode_component(*vertices(*colored.scene).find("COLOR_0"), 0, 0), 1.0f);
  EXPECT_EQ(decode_component(*vertices(*colored.scene).find("COLOR_0"), 0, 1), 0.0f);

  Binary vertex(false), face(false);
  for (int i = 0; i < 3; ++i) vertex.put<float>({float(i), float(i * i), 0, std::numeric_limits<float>::infinity()});
  face.put<std::uint8_t>({3}).put<std::int32_t>({0, 1, 2});
  EXPECT_TRUE(read_mesh(MeshKind::ply,
                        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                        "property float z\nproperty float nx\n" +
                            face_element + "end_header\n" + vertex.bytes + face.bytes)
                  .scene);
}

TEST(MeshPly, WhatFollowsTheLastRecordIsTold) {
  const std::string text = head + face_element + "end_header\n" + places + "3 0 1 2\n";
  EXPECT_EQ(read_mesh(MeshKind::ply, text + " \r\n\n").told(), "");
  const auto more = read_mesh(MeshKind::ply, text + "3 2 1 0\n");
  ASSERT_TRUE(more.scene);
  EXPECT_EQ(more.told(), "lines-left-out");
  EXPECT_EQ(more.diagnostics.all()[0].where.line, 14);

  const std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
      "end_header\nabc";
  EXPECT_EQ(read_mesh(MeshKind::ply, bytes).told(), "");
  EXPECT_EQ(read_mesh(MeshKind::ply, bytes + "d").told(), "bytes-left-out");
}

TEST(MeshPly, OfSeveralPropertiesThatMeanTheSameTheFirstCounts) {
  const auto made = read_mesh(
      MeshKind::ply, head + "property float u\nproperty float v\nproperty float s\nproperty float t\n" + face_element +
                         "property list uchar int vertex_index\nend_header\n"
                         "0 0 0 0 0 1 1\n1 0 0 0 0 1 1\n0 1 0 0 0 1 1\n3 0 1 2 4 2 1 0 9\n");
  ASSERT_TRUE(made.scene) << made.error();
  EXPECT_EQ(indices(*made.scene), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(decode_component(*vertices(*made.scene).find("TEXCOORD_0"), 0, 0), 0);
  ASSERT_EQ(made.told(), "properties-left-out");
  EXPECT_NE(made.diagnostics.all()[0].message.find("vertex.s, vertex.t, face.vertex_index"), std::string::npos);
}

TEST(MeshPly, CountsAreHeldAgainstTheBytesThatAreThere) {
  for (const std::string count :
       {"1000000000", "2147483648", "4294967295", "9223372036854775808", "18446744073709551615"}) {
    for (const std::string format : {"ascii", "binary_little_endian"}) {
      const std::string text = "ply\nformat " + format + " 1.0\nelement vertex " + count +
                               "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + places;
      EXPECT_NE(error(text).find("input.ply:3:16: error: " + count + " elements 'vertex' take at least"),
                std::string::npos)
          << error(text);
    }
  }
}

}  // namespace
}  // namespace foredraw::ply_test
