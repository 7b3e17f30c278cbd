// Other triangles of a draw's vertices: what is taken along, what is left, and what is refused.
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/modules/remeshed.h>
#include <foredraw/scene/moves.h>

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

namespace foredraw::testing::remesher_test {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Draw with_everything() {
  Draw draw = draw_of(grid(2, 1));  // four triangles, six vertices
  auto vertices = std::make_shared<VertexStreams>(*draw.full().vertices);
  const auto numbered = [&](const char* semantic, std::uint8_t first) {
    std::vector<std::byte> bytes;
    for (std::uint8_t v = 0; v < 6; ++v) bytes.push_back(static_cast<std::byte>(first + v));
    return VertexStream{semantic, {Component::uint8, 1, false, 1}, Shared(std::move(bytes))};
  };
  vertices->base.push_back(numbered("_MINE", 10));
  vertices->morph_targets = {{numbered("POSITION", 20)}, {numbered("POSITION", 30)}};
  draw.full().vertices = std::move(vertices);
  draw.full().stream().clusters = Clusters{{0, 4}};
  return draw;
}

std::vector<int> bytes_of(const VertexStream& stream) {
  std::vector<int> numbers;
  for (const std::byte byte : stream.bytes.view()) numbers.push_back(std::to_integer<int>(byte));
  return numbers;
}

TEST(Remeshed, TakesEveryAttributeAndMorphTargetFromTheSource) {
  const Draw before = with_everything();
  const Draw after = remeshed(before, {{0, 1, 2, 2, 1, 3}, {5, 3, 1, 3}});
  const VertexStreams& vertices = *after.full().vertices;
  EXPECT_EQ(vertices.count, 4u);
  EXPECT_THAT(bytes_of(*vertices.find("_MINE")), ElementsAre(15, 13, 11, 13));
  EXPECT_THAT(bytes_of(vertices.morph_targets[0][0]), ElementsAre(25, 23, 21, 23));
  EXPECT_THAT(bytes_of(vertices.morph_targets[1][0]), ElementsAre(35, 33, 31, 33));
  EXPECT_EQ(decode_vec3(*vertices.find("POSITION"))[0], decode_vec3(*before.full().vertices->find("POSITION"))[5]);
  EXPECT_THAT(after.full().stream().indices.view(), ElementsAre(0, 1, 2, 2, 1, 3));
  EXPECT_FALSE(after.full().stream().clusters);
  EXPECT_THAT(after.full().vertex_destination.view(), ElementsAre(no_vertex, 2, no_vertex, 1, no_vertex, 0));
}

TEST(Remeshed, CanNotBeFollowedTriangleByTriangle) {
  const Draw before = with_everything();
  const auto indices = before.full().stream().indices.view();
  std::vector<std::uint32_t> turned(indices.rbegin(), indices.rend());  // as many as before, but others
  const Draw after = remeshed(before, {turned, {0, 1, 2, 3, 4, 5}});
  EXPECT_FALSE(triangle_moves(before.full().stream(), after.full().stream()));
}

TEST(Remeshed, SaysWhatIsWrong) {
  const Draw draw = with_everything();
  const auto wrong = [&](Remesh answer) -> std::string {
    try {
      remeshed(draw, std::move(answer));
      return "nothing";
    } catch (const std::runtime_error& problem) {
      return problem.what();
    }
  };
  EXPECT_EQ(wrong({{0, 1, 2}, {0, 1, 2}}), "nothing");
  EXPECT_EQ(wrong({{0, 1}, {0, 1}}), "its answer has 2 indices, which is no multiple of three");
  EXPECT_EQ(wrong({{0, 1, 3}, {0, 1, 2}}), "its answer has an index to vertex 3, but there are 3");
  EXPECT_EQ(wrong({{0, 1, 2}, {0, 1, 6}}), "its answer has a vertex from vertex 6, but there are 6");
  EXPECT_EQ(wrong({std::vector<std::uint32_t>(15), {0}}), "its answer has 5 triangles, but the draw has 4");
  EXPECT_EQ(wrong({{0, 1, 2}, std::vector<std::uint32_t>(7)}), "its answer has 7 vertices, but the draw has 6");
  EXPECT_EQ(wrong({{}, {0}}), "it leaves no triangle of 4");
  EXPECT_EQ(wrong({{0, 0, 0}, {}}), "it leaves no vertex of 6");
}

class Remeshers : public InFolder {
 protected:
  /// What the program writes, and says, of a model.
  Json optimized(const std::string& model, const std::string& arguments) {
    const Ended ended = run_program(
        folder_, "optimize '" FOREDRAW_SOURCE_DIR "/benchmarks/corpus/" + model + "' -o out.glb --json " + arguments);
    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    return Json::parse(ended.out, nullptr, false);
  }
};

TEST_F(Remeshers, GiveTheSameBytesApartAndInside) {
  const std::string arguments =
      "-p 'weld, acme-slivers(area=3e-4), lookahead, vertex-fetch' --with vertex-cache --module "
      "'" FOREDRAW_MODULES_FOLDER "/slivers.so'";
  for (const std::string model : {"static/spot.glb", "animated/kaykit_knight.glb"}) {
    const Json report = optimized(model, arguments);
    const std::string apart = content(folder_ / "out.glb");
    EXPECT_EQ(report.at("stages").at(1).at("changed").get<int>() > 0, true);
    for (const std::string more : {" --threads 1", " --threads 16", " --modules inside"}) {
      optimized(model, arguments + more);
      EXPECT_TRUE(content(folder_ / "out.glb") == apart) << model << more;
    }
  }
}

TEST_F(Remeshers, AreMeasuredAgainstTheOriginal) {
  const Json report =
      optimized("static/spot.glb",
                "-p 'acme-slivers(area=3e-4), vertex-fetch' --module '" FOREDRAW_MODULES_FOLDER "/slivers.so'");
  EXPECT_GT(report.at("totals").at("metrics").at("surface-error").at("largest").at("value").get<double>(), 0);
}

TEST_F(Remeshers, ThatKeepLeaveTheDraw) {
  const Json report = optimized("static/spot.glb", "-p acme-slivers --module '" FOREDRAW_MODULES_FOLDER "/slivers.so'");
  EXPECT_THAT(report.at("stages").at(0).dump(), HasSubstr("no triangle is so small"));
}

}  // namespace
}  // namespace foredraw::testing::remesher_test
