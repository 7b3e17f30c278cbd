// Models that nobody would make on purpose, made coarser by the program's presets: it ends well, says what it says
// plainly, and what it writes draws what was there.
#include "odd_models.h"
#include "plain_messages.h"

#include "support/products.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/io/scene_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw::odd_models_test {
namespace {

using testing::Ended;
using testing::OddModel;

std::string name_of(const OddModel& model) { return model.name + ".glb"; }

struct Range {
  float least = std::numeric_limits<float>::infinity(), most = -least;
};

/// Of each component of a stream, over the vertices that triangles use.
std::vector<Range> ranges_of(const VertexStream& stream) {
  std::vector<Range> ranges(stream.format.components);
  for (std::size_t v = 0; v < stream.count(); ++v) {
    for (std::size_t c = 0; c < ranges.size(); ++c) {
      const float value = decode_component(stream, v, c);
      ranges[c].least = std::min(ranges[c].least, value);
      ranges[c].most = std::max(ranges[c].most, value);
    }
  }
  return ranges;
}

bool is_finite(const VertexStream& stream) {
  for (std::size_t v = 0; v < stream.count(); ++v) {
    for (std::size_t c = 0; c < stream.format.components; ++c) {
      if (!std::isfinite(decode_component(stream, v, c))) return false;
    }
  }
  return true;
}

/// What a mesh made coarser carries lies between what was there. Normals are of a length of 1, or what they were.
void expect_to_lie_between(const VertexStream& made, const VertexStream& was) {
  ASSERT_TRUE(is_finite(made)) << made.semantic;
  const std::vector<Range> now = ranges_of(made), before = ranges_of(was);
  for (std::size_t c = 0; c < now.size() && made.count() > 0; ++c) {
    const bool is_unit = made.semantic == "NORMAL";
    const float least = is_unit ? std::min(before[c].least, -1.0f) : before[c].least;
    const float most = is_unit ? std::max(before[c].most, 1.0f) : before[c].most;
    const float slack = 1e-5f * std::max(std::abs(least), std::abs(most));
    EXPECT_GE(now[c].least, least - slack) << made.semantic << ' ' << c;
    EXPECT_LE(now[c].most, most + slack) << made.semantic << ' ' << c;
  }
}

class OddModels : public testing::InFolder {
 protected:
  OddModels() : models_(testing::odd_models()) {
    std::filesystem::create_directory(folder_ / "in");
    for (const OddModel& model : models_) {
      const std::vector<std::byte> bytes = model.file.glb();
      testing::put(folder_ / "in" / name_of(model), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
  }

  Ended run(const std::string& arguments) {
    const Ended ended = testing::run_program(folder_, arguments);
    testing::expect_plain_messages(ended, arguments);
    return ended;
  }

  /// One of them has no attribute, which is no glTF, and costs itself alone.
  void optimize(const std::string& preset, const std::string& more) {
    const Ended ended = run("optimize in -o out -p " + preset + " --threads 2 --report report.json " + more);
    EXPECT_EQ(ended.code, 2) << ended.err;
    const nlohmann::json report = nlohmann::json::parse(testing::content(folder_ / "report.json"));
    std::size_t refused = 0;
    for (const auto& file : report["files"]) refused += file["outcome"] != "done";
    EXPECT_EQ(report["files"].size(), models_.size());
    EXPECT_EQ(refused, 1u) << ended.err;
    EXPECT_NE(ended.err.find("in/mesh 0.glb: error: "), std::string::npos) << ended.err;
    for (const OddModel& model : models_) {
      SCOPED_TRACE(preset + ": " + model.name);
      const auto out = folder_ / "out" / name_of(model);
      ASSERT_EQ(std::filesystem::exists(out), model.name != "mesh 0");
      if (model.name != "mesh 0") expect_right(model, read(folder_ / "in" / name_of(model)), read(out), preset);
    }
    std::filesystem::remove_all(folder_ / "out");
  }

  static std::optional<SceneFile> read(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    auto file = read_scene(path.string(), diagnostics, {.products = testing::built_in_products()});
    EXPECT_TRUE(file && diagnostics.all().empty()) << to_text(diagnostics);
    return file;
  }

  /// Sequences are for later stages, and no file is to have them.
  static void expect_right(const OddModel& model, const std::optional<SceneFile>& in,
                           const std::optional<SceneFile>& out, const std::string& preset) {
    ASSERT_TRUE(in && out);
    EXPECT_FALSE(out->scene.products.has("collapse-sequences"));
    ASSERT_EQ(out->scene.draws.size(), in->scene.draws.size());
    for (std::size_t d = 0; d < in->scene.draws.size(); ++d) {
      const Draw &was = in->scene.draws[d], &made = out->scene.draws[d];
      ASSERT_EQ(made.topology, was.topology);
      if (was.topology != Topology::triangles) continue;
      const std::size_t triangles = was.full().stream().triangle_count();
      EXPECT_LE(made.full().stream().triangle_count(), triangles);
      if (preset != "@simplify") {
        EXPECT_EQ(made.full().stream().triangle_count(), triangles);
      }
      EXPECT_EQ(made.full().stream().indices.empty(), triangles == 0);
      for (const Level& level : made.levels) expect_level(model, was, level);
      for (std::size_t l = 1; l < made.levels.size(); ++l) {
        EXPECT_GE(made.levels[l].error, made.levels[l - 1].error);
        EXPECT_LT(made.levels[l].stream().triangle_count(), made.levels[l - 1].stream().triangle_count());
        expect_error_to_hold(model, made, l);
      }
    }
  }

  static void expect_level(const OddModel& model, const Draw& was, const Level& level) {
    EXPECT_TRUE(std::isfinite(level.error) && level.error >= 0);
    for (const std::uint32_t v : level.stream().indices.view()) ASSERT_LT(v, level.vertices->count);
    if (!model.is_finite) return;
    ASSERT_EQ(level.vertices->base.size(), was.full().vertices->base.size());
    for (const VertexStream& stream : level.vertices->base) {
      const VertexStream* before = was.full().vertices->find(stream.semantic);
      ASSERT_NE(before, nullptr);
      if (stream.semantic == "POSITION" || stream.semantic.starts_with("JOINTS_")) continue;
      if (stream.semantic.starts_with("WEIGHTS_")) continue;
      expect_to_lie_between(stream, *before);
    }
    expect_weights_to_add_up(*level.vertices);
  }

  /// Those of one joint may stand in one place after, and in several before; in models of theirs they are 0, or add up
  /// to 1.
  static void expect_weights_to_add_up(const VertexStreams& vertices) {
    for (std::size_t v = 0; v < vertices.count; ++v) {
      float sum = 0;
      bool has_any = false;
      for (const VertexStream& stream : vertices.base) {
        if (!stream.semantic.starts_with("WEIGHTS_")) continue;
        has_any = true;
        for (std::size_t c = 0; c < 4; ++c) {
          EXPECT_GE(decode_component(stream, v, c), 0);
          sum += decode_component(stream, v, c);
        }
      }
      EXPECT_NEAR(sum, has_any && sum > 0.5f ? 1 : 0, 1e-5);
    }
  }

  static void expect_error_to_hold(const OddModel& model, const Draw& draw, std::size_t l) {
    Analyses analyses;
    const auto surface_of = [&](const Level& level) {
      return Surface{positions_of(analyses, *level.vertices)->values, level.stream().indices.view()};
    };
    const Surface full = surface_of(draw.full());
    if (!model.is_finite || full.indices.size() > 30'000) return;  // a hub's nearest triangles are all of them
    double largest = 0;
    for (const glm::vec3& p : full.positions) {
      for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(double{p[k]}));
    }
    const auto distance = surface_distance(full, surface_of(draw.levels[l]), {.samples = 300, .seed = 3}, Executor(1));
    if (!distance) return;
    EXPECT_GE(draw.levels[l].error + 1e-7 * largest, distance->largest) << "level " << l;
  }

  std::vector<OddModel> models_;
};

TEST_F(OddModels, ComeOutOfEachPresetDrawingWhatWasThere) {
  for (const char* preset : {"@simplify", "@levels", "@streaming"}) optimize(preset, "--with vertex-cache");
}

/// Measured as the presets measure, and looked at by the other commands.
TEST_F(OddModels, ComeThroughEveryCommandLong) {
  for (const char* preset : {"@default", "@simplify", "@levels", "@streaming"}) optimize(preset, "");
  for (const char* more : {"quadric-collapse.placement=endpoint", "quadric-collapse.solve=false",
                           "quadric-collapse.parts=1", "simplify.ratio=0.05"}) {
    optimize("@simplify", std::string("--with vertex-cache --set ") + more);
  }
  EXPECT_EQ(run("optimize in -o lod -p @levels --levels msft-lod --with vertex-cache").code, 2);
  std::filesystem::remove(folder_ / "in/mesh 0.glb");
  EXPECT_EQ(run("measure in --with 'surface-error, attribute-error, vertex-cache, scene-cost'").code, 0);
  EXPECT_EQ(run("measure lod --with 'surface-error, attribute-error, vertex-cache, scene-cost'").code, 0);
  EXPECT_EQ(
      run("compare in -p @simplify -p @levels -p @streaming -p @default --with 'vertex-cache, surface-error'").code, 0);
}

TEST_F(OddModels, OfIndicesOutOfRangeAreRefused) {
  const std::vector<std::byte> bytes = testing::model_with_indices_out_of_range().glb();
  testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  for (const char* command :
       {"optimize in.glb -o out.glb -p @simplify", "measure in.glb", "compare in.glb -p @levels"}) {
    const Ended ended = run(command);
    EXPECT_EQ(ended.code, 2) << command << '\n' << ended.err;
    EXPECT_NE(ended.err.find("in.glb: error: "), std::string::npos) << ended.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.glb"));
}

}  // namespace
}  // namespace foredraw::odd_models_test
