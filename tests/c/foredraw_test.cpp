// The library for C beside the program: the same bytes, the same reports; and what is wrong is said.

#include <foredraw/c/foredraw.h>

#include "handles.h"

#include <support/program.h>

#include <cmath>
#include <future>
#include <memory>
#include <thread>

namespace foredraw::testing::foredraw_test {
namespace {

const std::string spot = FOREDRAW_SOURCE_DIR "/benchmarks/corpus/static/spot.glb";

class ForC : public InFolder {
 protected:
  SceneHandle read(const std::string& path) const {
    foredraw_scene* scene = nullptr;
    EXPECT_EQ(foredraw_read(context_.get(), path.c_str(), &scene, nullptr), FOREDRAW_DONE);
    return SceneHandle(scene);
  }

  const Context context_{foredraw_context_new(nullptr)};
};

TEST_F(ForC, MakesTheBytesAndTheReportOfTheProgram) {
  const SceneHandle scene = read(spot);
  foredraw_scene* cheaper = nullptr;
  Told report;
  ASSERT_EQ(foredraw_optimize(context_.get(), scene.get(), "weld, lookahead, vertex-fetch", &cheaper, report.out()),
            FOREDRAW_DONE);
  const SceneHandle made(cheaper);
  const std::filesystem::path ours = folder_ / "ours.glb";
  ASSERT_EQ(foredraw_write(context_.get(), made.get(), ours.c_str(), nullptr), FOREDRAW_DONE);
  const Ended program =
      run_program(folder_, "optimize '" + spot + "' -o theirs.glb --json -p 'weld, lookahead, vertex-fetch'");
  ASSERT_EQ(program.code, 0) << program.err;
  EXPECT_EQ(content(ours), content(folder_ / "theirs.glb"));
  const Json mine = report.json(), theirs = Json::parse(program.out);
  EXPECT_EQ(mine.at("totals"), theirs.at("totals"));
  EXPECT_EQ(mine.at("input"), theirs.at("input"));
  EXPECT_EQ(mine.at("pipeline"), theirs.at("pipeline"));
}

TEST_F(ForC, TakesPresetsAndTextsOfFiles) {
  const SceneHandle scene = read(spot);
  EXPECT_EQ(foredraw_optimize(context_.get(), scene.get(), "@cache-only", nullptr, nullptr), FOREDRAW_DONE);
  Told report;
  EXPECT_EQ(
      foredraw_optimize(context_.get(), scene.get(),
                        "pipeline = 1\nstages = [\"tipsify\"]\nmeasure = [\"vertex-cache\"]\n", nullptr, report.out()),
      FOREDRAW_DONE);
  EXPECT_TRUE(report.json().at("totals").at("metrics").contains("vertex-cache"));
}

TEST_F(ForC, MeasuresWhatItIsAskedFor) {
  const SceneHandle scene = read(spot);
  Told asked, usual;
  ASSERT_EQ(foredraw_measure(context_.get(), scene.get(), "vertex-cache(cache-size=24)", asked.out()), FOREDRAW_DONE);
  EXPECT_TRUE(asked.json().at("totals").at("metrics").contains("vertex-cache"));
  ASSERT_EQ(foredraw_measure(context_.get(), scene.get(), nullptr, usual.out()), FOREDRAW_DONE);
  EXPECT_TRUE(usual.json().at("totals").at("metrics").contains("overdraw-raster"));
}

TEST_F(ForC, ComparesAsTheProgramDoes) {
  const SceneHandle scene = read(spot);
  const foredraw_scene* scenes[] = {scene.get(), scene.get()};
  const char* pipelines[] = {"tipsify, vertex-fetch", "@cache-only"};
  Told told, lost, wrong;
  ASSERT_EQ(foredraw_compare(context_.get(), scenes, 2, pipelines, 2, 0, told.out()), FOREDRAW_DONE);
  const Ended program =
      run_program(folder_, "compare '" + spot + "' '" + spot + "' --json -p 'tipsify, vertex-fetch' -p @cache-only");
  ASSERT_EQ(program.code, 0) << program.err;
  const Json mine = told.json(), theirs = Json::parse(program.out);
  ASSERT_EQ(mine.at("files").size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(mine.at("files").at(i).at("metrics"), theirs.at("files").at(i).at("metrics"));
  }
  const char* one_is_lost[] = {"tipsify", "particle-trim(required=true)"};
  EXPECT_EQ(foredraw_compare(context_.get(), scenes, 1, one_is_lost, 2, 0, lost.out()), FOREDRAW_FAILED);
  EXPECT_TRUE(lost.json().at("files").at(0).at("branches").at(1).at("lost"));
  const char* one_is_wrong[] = {"tipsify", "tipsify("};
  EXPECT_EQ(foredraw_compare(context_.get(), scenes, 1, one_is_wrong, 2, 0, wrong.out()), FOREDRAW_MISTAKE);
  EXPECT_FALSE(wrong.json().at("diagnostics").empty());
  EXPECT_EQ(foredraw_compare(context_.get(), scenes, 1, nullptr, 1, 0, nullptr), FOREDRAW_NULL_POINTER);
}

TEST_F(ForC, SaysWhatIsWrong) {
  foredraw_scene* scene = nullptr;
  Told missing, damaged, wrong, unwritable;
  EXPECT_EQ(foredraw_read(context_.get(), "none.glb", &scene, missing.out()), FOREDRAW_FAILED);
  EXPECT_EQ(scene, nullptr);
  EXPECT_EQ(missing.json().at("diagnostics").at(0).at("code"), "no-such-file");
  EXPECT_EQ(foredraw_read_memory(context_.get(), "glTF", 4, "four bytes", &scene, damaged.out()), FOREDRAW_FAILED);
  EXPECT_EQ(damaged.json().at("diagnostics").at(0).at("file"), "four bytes");
  const SceneHandle good = read(spot);
  foredraw_scene* result = good.get();
  EXPECT_EQ(foredraw_optimize(context_.get(), good.get(), "tipsfy", &result, wrong.out()), FOREDRAW_MISTAKE);
  EXPECT_EQ(result, nullptr);
  EXPECT_NE(wrong.json().at("diagnostics").at(0).at("hint").get<std::string>().find("tipsify"), std::string::npos);
  EXPECT_EQ(foredraw_write(context_.get(), good.get(), "/nowhere/x.glb", unwritable.out()), FOREDRAW_FAILED);
  EXPECT_FALSE(unwritable.json().at("diagnostics").empty());
}

TEST_F(ForC, NullIsRefusedEverywhere) {
  const SceneHandle scene = read(spot);
  foredraw_scene* made = nullptr;
  foredraw_draw draw{.size = sizeof draw};
  EXPECT_EQ(foredraw_read(nullptr, "x", &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_read(context_.get(), nullptr, &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_read(context_.get(), "x", nullptr, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_read_memory(context_.get(), nullptr, 1, nullptr, &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_make_scene(context_.get(), nullptr, 1, &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_write(context_.get(), nullptr, "x", nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_optimize(context_.get(), nullptr, "", &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_optimize(context_.get(), scene.get(), nullptr, &made, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_measure(nullptr, scene.get(), nullptr, nullptr), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_scene_draw(nullptr, 0, &draw), FOREDRAW_NULL_POINTER);
  EXPECT_EQ(foredraw_scene_draw(scene.get(), 1, &draw), FOREDRAW_MISTAKE);
  EXPECT_EQ(foredraw_scene_draws(nullptr), 0u);
  EXPECT_EQ(foredraw_scene_copy(nullptr), nullptr);
  foredraw_cancel(nullptr);
  foredraw_scene_free(nullptr);
  foredraw_context_free(nullptr);
  foredraw_text_free(nullptr);
}

/// A sheet in memory, with padded normals, whose triangles come in a sequence that suits no cache.
struct Sheet {
  explicit Sheet(std::uint32_t cells) {
    for (std::uint32_t i = 0; i < (cells + 1) * (cells + 1); ++i) {
      const std::uint32_t x = i % (cells + 1), y = i / (cells + 1);
      positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y % 7)});
      padded_normals.insert(padded_normals.end(), {0, 0, 127, 99});
    }
    for (std::uint32_t i = 0; i < cells * cells; ++i) {
      const std::uint32_t cell = i * 619 % (cells * cells);  // a prime, so that each comes once
      const std::uint32_t a = cell / cells * (cells + 1) + cell % cells, c = a + cells + 1;
      for (const std::uint32_t corner : {a, a + 1, c, c, a + 1, c + 1}) indices.push_back(corner);
    }
  }

  foredraw_draw draw() const {
    return {.size = sizeof(foredraw_draw),
            .vertex_count = static_cast<std::uint32_t>(positions.size() / 3),
            .triangle_count = indices.size() / 3,
            .name = "sheet",
            .indices = indices.data(),
            .positions = positions.data(),
            .stream_count = 1,
            .streams = &normals};
  }

  std::vector<std::uint32_t> indices;
  std::vector<float> positions;
  std::vector<std::int8_t> padded_normals;
  foredraw_stream normals{"NORMAL", nullptr, 4, FOREDRAW_INT8, 3, 1};
};

TEST_F(ForC, MakesScenesOfMemoryAndLendsWhatBecameOfThem) {
  Sheet sheet(150);
  sheet.normals.bytes = sheet.padded_normals.data();
  const foredraw_draw draws[] = {sheet.draw(), sheet.draw()};
  foredraw_scene *scene = nullptr, *cheaper = nullptr;
  ASSERT_EQ(foredraw_make_scene(context_.get(), draws, 2, &scene, nullptr), FOREDRAW_DONE);
  ASSERT_EQ(foredraw_optimize(context_.get(), scene, "tipsify, vertex-fetch", &cheaper, nullptr), FOREDRAW_DONE);
  foredraw_scene_free(scene);
  const SceneHandle made(foredraw_scene_copy(cheaper));
  foredraw_scene_free(cheaper);
  ASSERT_EQ(foredraw_scene_draws(made.get()), 2u);
  foredraw_draw draw{.size = sizeof draw};
  ASSERT_EQ(foredraw_scene_draw(made.get(), 1, &draw), FOREDRAW_DONE);
  EXPECT_EQ(draw.triangle_count, draws[1].triangle_count);
  ASSERT_EQ(draw.stream_count, 1u);
  EXPECT_STREQ(draw.streams[0].semantic, "NORMAL");
  EXPECT_EQ(draw.streams[0].component, FOREDRAW_INT8);
  const std::uint32_t* triangles = nullptr;
  const std::uint32_t* vertices = nullptr;
  std::uint64_t count = 0;
  ASSERT_EQ(foredraw_scene_moves(made.get(), 1, &triangles, &vertices, &count), FOREDRAW_DONE);
  ASSERT_NE(triangles, nullptr);
  ASSERT_NE(vertices, nullptr);
  ASSERT_EQ(count, draws[1].vertex_count);
  for (std::size_t i = 0; i < 3 * draw.triangle_count; ++i) {
    const std::uint32_t before = sheet.indices[3 * triangles[i / 3] + i % 3];
    ASSERT_EQ(draw.indices[i], vertices[before]);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(draw.positions[3 * draw.indices[i] + k], sheet.positions[3 * before + k]);
  }
}

TEST_F(ForC, WrongDrawsAreNamed) {
  Sheet sheet(2);
  sheet.normals.bytes = sheet.padded_normals.data();
  const foredraw_draw good = sheet.draw();
  const auto problem = [&](const foredraw_draw& draw) {
    foredraw_scene* scene = nullptr;
    Told told;
    EXPECT_EQ(foredraw_make_scene(context_.get(), &draw, 1, &scene, told.out()), FOREDRAW_MISTAKE);
    EXPECT_EQ(scene, nullptr);
    return told.json().at("diagnostics").at(0).at("message").get<std::string>();
  };
  foredraw_draw bad = good;
  bad.size = 8;
  EXPECT_TRUE(problem(bad).starts_with("sheet: size is 8"));
  bad = good, bad.vertex_count = 3;
  EXPECT_EQ(problem(bad), "sheet: an index names a position that does not exist");
  bad = good, bad.indices = nullptr;
  EXPECT_EQ(problem(bad), "sheet: indices is NULL, but triangle_count is above 0");
  bad = good, bad.positions = nullptr;
  EXPECT_EQ(problem(bad), "sheet: positions is NULL, but vertex_count is above 0");
  bad = good, bad.triangle_count = ~std::uint64_t{0};
  EXPECT_NE(problem(bad).find("too many"), std::string::npos);
  sheet.normals.component = 9;
  EXPECT_NE(problem(good).find("component type 9"), std::string::npos);
  sheet.normals.component = FOREDRAW_INT8, sheet.normals.components = 0;
  EXPECT_NE(problem(good).find("1 to 16"), std::string::npos);
  sheet.normals.components = 3, sheet.normals.semantic = nullptr;
  EXPECT_NE(problem(good).find("semantic"), std::string::npos);
}

/// The run waits in its first call of progress until another thread has cancelled it.
TEST_F(ForC, EndsAfterACancelFromAnotherThread) {
  struct Meeting {
    std::promise<void> has_begun, is_cancelled;
    int calls = 0;
  } meeting;
  foredraw_settings settings{.size = sizeof settings, .threads = 1, .progress = nullptr, .user = &meeting};
  settings.progress = [](void* user, const char*, double) {
    auto& meeting = *static_cast<Meeting*>(user);
    if (meeting.calls++ > 0) return 0;
    meeting.has_begun.set_value();
    meeting.is_cancelled.get_future().wait();
    return 0;
  };
  const Context context(foredraw_context_new(&settings));
  const SceneHandle scene = read(spot);
  std::thread canceller([&] {
    meeting.has_begun.get_future().wait();
    foredraw_cancel(context.get());
    meeting.is_cancelled.set_value();
  });
  foredraw_scene* made = nullptr;
  EXPECT_EQ(foredraw_optimize(context.get(), scene.get(), "@default", &made, nullptr), FOREDRAW_CANCELLED);
  canceller.join();
  EXPECT_EQ(made, nullptr);
}

TEST_F(ForC, ProgressTellsAndMayCancel) {
  struct Heard {
    int calls = 0;
    double last = 0;
  } heard;
  foredraw_settings settings{.size = sizeof settings, .threads = 1, .progress = nullptr, .user = &heard};
  settings.progress = [](void* user, const char* what, double part) {
    auto& heard = *static_cast<Heard*>(user);
    EXPECT_NE(std::string(what), "");
    EXPECT_GE(part, heard.last);
    heard.last = part;
    return ++heard.calls == 2 ? 1 : 0;
  };
  const Context context(foredraw_context_new(&settings));
  const SceneHandle scene = read(spot);
  EXPECT_EQ(foredraw_optimize(context.get(), scene.get(), "weld, lookahead, vertex-fetch", nullptr, nullptr),
            FOREDRAW_CANCELLED);
  EXPECT_GE(heard.calls, 2);
}

TEST_F(ForC, ThreadsShareAContextAndAScene) {
  const SceneHandle scene = read(spot);
  std::vector<std::string> outputs(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    threads.emplace_back([&, i] {
      foredraw_scene* made = nullptr;
      const std::string path = (folder_ / std::to_string(i)).string() + ".glb";
      EXPECT_EQ(foredraw_optimize(context_.get(), scene.get(), "weld, tipsify, vertex-fetch", &made, nullptr),
                FOREDRAW_DONE);
      EXPECT_EQ(foredraw_write(context_.get(), made, path.c_str(), nullptr), FOREDRAW_DONE);
      foredraw_draw draw{.size = sizeof draw};
      EXPECT_EQ(foredraw_scene_draw(scene.get(), 0, &draw), FOREDRAW_DONE);
      foredraw_scene_free(made);
      outputs[i] = content(path);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& output : outputs) EXPECT_EQ(output, outputs.front());
  EXPECT_FALSE(outputs.front().empty());
}

TEST_F(ForC, KnowsItsVersion) { EXPECT_EQ(foredraw_version(), FOREDRAW_VERSION_NUMBER); }

}  // namespace
}  // namespace foredraw::testing::foredraw_test
