// Every technique that the program lists orders, cuts and measures through the library for C as it does in the program.

#include <foredraw/c/foredraw.h>
#include <foredraw/c/functions.h>

#include "bumpy_sheet.h"
#include "handles.h"

#include <support/program.h>

#include <map>
#include <set>

namespace foredraw::testing::every_technique_test {
namespace {

class EveryTechnique : public InFolder {
 protected:
  EveryTechnique() {
    EXPECT_EQ(foredraw_write(context_.get(), scene_of_sheet().get(), (folder_ / "sheet.glb").c_str(), nullptr),
              FOREDRAW_DONE);
  }

  /// Of one kind, with their needs.
  std::map<std::string, Json> listed(const std::string& kind) {
    std::map<std::string, Json> found;
    const Json list = Json::parse(run_program(folder_, "list --json").out);
    for (const Json& plugin : list.at("plugins")) {
      if (plugin.at("kind") == kind) found[plugin.at("name")] = plugin.at("needs");
    }
    return found;
  }

  /// Of the library beside the program: the figures, and whether it was done. True where there are some.
  bool has_same_figures(const std::string& evaluator) {
    SCOPED_TRACE(evaluator);
    Told mine;
    const SceneHandle scene = scene_of_sheet();
    const int status = foredraw_measure(context_.get(), scene.get(), evaluator.c_str(), mine.out());
    const Ended program = run_program(folder_, "measure sheet.glb --json --with '" + evaluator + "'");
    EXPECT_EQ(status, program.code);
    EXPECT_EQ(mine.json().at("totals"), Json::parse(program.out).at("totals"));
    return !mine.json().at("totals").at("metrics").empty();
  }

  std::vector<std::uint32_t> indices_of(const foredraw_scene* scene) const {
    foredraw_draw draw{.size = sizeof draw};
    EXPECT_EQ(foredraw_scene_draw(scene, 0, &draw), FOREDRAW_DONE);
    return {draw.indices, draw.indices + 3 * draw.triangle_count};
  }

  const BumpySheet sheet_{14};
  const foredraw_triangles triangles_ = sheet_.triangles();
  const foredraw_positions positions_ = sheet_.positions();
  const Context context_{foredraw_context_new(nullptr)};

 private:
  SceneHandle scene_of_sheet() const {
    const std::vector<std::uint32_t> indices(sheet_.indices.begin(), sheet_.indices.end());
    std::vector<float> places;
    for (const auto& vertex : sheet_.vertices) places.insert(places.end(), vertex.position, vertex.position + 3);
    foredraw_draw draw{.size = sizeof draw};
    draw.name = "sheet";
    draw.vertex_count = triangles_.vertex_count;
    draw.triangle_count = indices.size() / 3;
    draw.indices = indices.data();
    draw.positions = places.data();
    foredraw_scene* scene = nullptr;
    EXPECT_EQ(foredraw_make_scene(context_.get(), &draw, 1, &scene, nullptr), FOREDRAW_DONE);
    return SceneHandle(scene);
  }
};

TEST_F(EveryTechnique, OrdersAsInTheProgram) {
  const std::map<std::string, std::string> options = {{"animated-kmeans", "(k=1)"}};  // a draw in C has one order
  std::size_t moved = 0;
  for (const auto& [name, needs] : listed("orderer")) {
    if (name == "vertex-fetch") continue;  // orders vertices: OneDraw.HasTheOrderOfItsVertices
    const std::string before = needs == Json::array({"clustered"}) ? "tipsify, linear-clusters, " : "";
    ASSERT_TRUE(needs.empty() || !before.empty()) << name << " needs " << needs;
    const std::string line = before + name + (options.contains(name) ? options.at(name) : "");
    SCOPED_TRACE(line);
    std::vector<std::uint32_t> order(triangles_.index_count / 3);
    std::vector<std::uint16_t> ordered(triangles_.index_count);
    ASSERT_EQ(foredraw_order(context_.get(), line.c_str(), &triangles_, &positions_, order.data(), nullptr),
              FOREDRAW_DONE);
    ASSERT_EQ(foredraw_reorder_triangles(ordered.data(), &triangles_, order.data()), FOREDRAW_DONE);
    const Ended program =
        run_program(folder_, "optimize sheet.glb -o ordered.glb --with vertex-cache -p '" + line + "'");
    ASSERT_EQ(program.code, 0) << program.err;
    foredraw_scene* scene = nullptr;
    ASSERT_EQ(foredraw_read(context_.get(), (folder_ / "ordered.glb").c_str(), &scene, nullptr), FOREDRAW_DONE);
    EXPECT_EQ(std::vector<std::uint32_t>(ordered.begin(), ordered.end()), indices_of(SceneHandle(scene).get()));
    moved += ordered != sheet_.indices ? 1 : 0;
  }
  EXPECT_GE(moved, 6u);
}

TEST_F(EveryTechnique, OfClusterersIsTested) {
  std::set<std::string> names;
  for (const auto& [name, needs] : listed("clusterer")) names.insert(name);
  EXPECT_EQ(names, std::set<std::string>{"linear-clusters"});  // OneDraw.HasItsClusters
}

/// Whose usual work takes minutes do less of it; those that stand on libraries of their own take that long at least.
TEST_F(EveryTechnique, MeasuresAsInTheProgram) {
  const std::map<std::string, std::string> options = {
      {"antialiasing", "(size=16, views=1, frames=1, truth-samples=16)"},
      {"lod-walk", "(frames=2, width=16, height=16, pictures=0)"},
      {"thin-parts", "(size=32, views=1)"}};
  std::size_t measured = 0;
  for (const auto& [name, needs] : listed("evaluator")) {
    if (name == "overdraw-embree" || name == "overdraw-vulkan") continue;
    measured += has_same_figures(name + (options.contains(name) ? options.at(name) : "")) ? 1 : 0;
  }
  EXPECT_GE(measured, 8u);
}

TEST_F(EveryTechnique, MeasuresWithOtherLibrariesAsInTheProgramLong) {
  for (const auto& [name, needs] : listed("evaluator")) {
    if (name == "overdraw-embree" || name == "overdraw-vulkan") has_same_figures(name);
  }
}

}  // namespace
}  // namespace foredraw::testing::every_technique_test
