#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/cache/kept_milestones.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/canonical.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/presets.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

Stamp stamp_of(const std::string& text) { return content_hash(std::as_bytes(std::span(text))); }

/// What the program makes of a file, with a cache that keeps every milestone.
class KeptMilestonesTest : public testing::InFolder {
 protected:
  struct Made {
    std::vector<std::vector<std::byte>> files;
    Report report;
    std::size_t stages_cached = 0;
    std::size_t measures_cached = 0;
    std::vector<FileRead> read;
  };

  KeptMilestonesTest() : cache_(*Cache::in(folder_ / "cache", diagnostics_)) { add_built_in_plugins(registry_); }

  Pipeline pipeline(const std::string& text) {
    const auto pipeline = load_pipeline(text, diagnostics_);
    EXPECT_TRUE(pipeline) << to_text(diagnostics_);
    return *pipeline;
  }

  /// `known`: so many stages at the beginning have keys that were used before.
  MilestoneKeys keys(const Pipeline& whole, std::size_t known, const std::string& others) {
    MilestoneKeys keys;
    Pipeline part = whole;
    part.measure.clear();
    for (part.stages.clear(); const Stage& stage : whole.stages) {
      part.stages.push_back(stage);
      keys.stages.push_back(stamp_of(canonical_text(part, registry_) + (keys.stages.size() < known ? "" : others)));
    }
    keys.measures = stamp_of("measures");
    return keys;
  }

  Made run(const std::string& input, const Pipeline& pipeline, const MilestoneKeys* keys, double least_gain = 0) {
    const auto files = std::make_shared<FilesRead>();
    SceneInput how{.products = registry_.products(), .files = files};
    auto file = read_scene(input, diagnostics_, how);
    if (!file) throw std::runtime_error(to_text(diagnostics_));
    const auto plan = foredraw::plan(pipeline, registry_, file->scene, diagnostics_);
    if (!plan) throw std::runtime_error(to_text(diagnostics_));
    Analyses analyses(image_decoder(input, {}, files));
    std::optional<KeptMilestones> milestones;
    if (keys != nullptr) {
      milestones.emplace(KeptMilestones::Surroundings{cache_, *keys, input, files, nullptr,
                                                      [](const Diagnostics& damaged) { EXPECT_TRUE(damaged.empty()); },
                                                      [](const std::string& why) { EXPECT_EQ(why, ""); }, least_gain});
    }
    Result result = optimize(*plan, file->scene, {executor_, analyses, nullptr, {}, keys ? &*milestones : nullptr});
    EXPECT_FALSE(result.failed) << to_text(diagnostics_);
    Made made;
    const std::string output = (folder_ / ("out" + std::filesystem::path(input).extension().string())).string();
    auto files_made = encode_scene(result.scene, output, diagnostics_, {.products = registry_.products()});
    EXPECT_TRUE(files_made) << to_text(diagnostics_);
    for (OutputFile& one : *files_made) made.files.push_back(std::move(one.bytes));
    for (const StageRecord& stage : result.report.stages) made.stages_cached += stage.from_cache ? 1 : 0;
    made.report = std::move(result.report);
    made.read = milestones ? joined(files->all(), milestones->read_before()) : files->all();
    return made;
  }

  /// Without what differs from run to run.
  static Json told(const Report& report) {
    Json json = Json::parse(to_json(report));
    for (const char* key : {"seconds", "peak-memory", "threads"}) json.erase(key);
    for (const char* key : {"stages", "measures"}) {
      for (Json& stage : json[key]) {
        stage.erase("seconds");
        stage.erase("cached");
      }
    }
    return json;
  }

  static std::string of_corpus(const std::string& name) {
    return testing::project_file("benchmarks/corpus/" + name).string();
  }

  /// From each milestone on, the run comes to what a run without any comes to.
  void expect_same_from_each(const std::string& input, const Pipeline& pipeline) {
    const Made clean = run(input, pipeline, nullptr);
    const MilestoneKeys first = keys(pipeline, pipeline.stages.size(), "");
    const Made filling = run(input, pipeline, &first);
    EXPECT_EQ(filling.files == clean.files, true) << input;
    EXPECT_EQ(told(filling.report), told(clean.report));
    for (std::size_t behind = 1; behind < pipeline.stages.size(); ++behind) {
      const MilestoneKeys known = keys(pipeline, behind, "others " + std::to_string(++others_));
      const Made again = run(input, pipeline, &known);
      EXPECT_EQ(again.stages_cached, behind) << input;
      EXPECT_EQ(again.files == clean.files, true) << input << " from stage " << behind;
      EXPECT_EQ(told(again.report), told(clean.report)) << behind;
      EXPECT_EQ(again.read.size(), clean.read.size());
    }
  }

  Registry registry_;
  Diagnostics diagnostics_;
  Cache cache_;
  Executor executor_{2};
  int others_ = 0;
};

TEST_F(KeptMilestonesTest, RunsComeToTheSameFromEachOn) {
  for (const Preset& preset : presets()) {
    Pipeline pipeline = this->pipeline("@" + std::string(preset.name));
    std::erase_if(pipeline.stages, [](const Stage& stage) { return !stage.enabled; });
    pipeline.measure = *parse_stages("vertex-cache, scene-cost", "measure", diagnostics_);
    SCOPED_TRACE(preset.name);
    if (preset.name == "sprites") {
      expect_same_from_each(of_corpus("particles/atlas_playcanvas_numbers.json"), pipeline);
      continue;
    }
    expect_same_from_each(of_corpus("scenes/kaykit_city/bench.gltf"), pipeline);
    expect_same_from_each(of_corpus("animated/fox.glb"), pipeline);
  }
}

/// Stages that made the outputs that are furthest from the input, each behind the others that it can follow.
TEST_F(KeptMilestonesTest, ProductsAreKept) {
  for (const char* stages :
       {"merge-instances, tipsify, vertex-fetch", "weld, quadric-collapse, levels, geomorphs, tipsify, vertex-fetch",
        "weld, quadric-collapse, progressive-stream, vertex-fetch", "weld, vertex-pack, tipsify, vertex-fetch",
        "weld, quadric-collapse, levels, lod-table, tipsify, vertex-fetch", "second-depth, tipsify, vertex-fetch"}) {
    SCOPED_TRACE(stages);
    expect_same_from_each(of_corpus("scenes/kaykit_city/building_A.gltf"), pipeline(stages));
  }
}

TEST_F(KeptMilestonesTest, WhatIsQuickIsMadeAgain) {
  const std::string input = of_corpus("scenes/kaykit_city/bench.gltf");
  const Pipeline pipeline = this->pipeline("weld, tipsify, vertex-fetch");
  const MilestoneKeys all = keys(pipeline, 3, "");
  run(input, pipeline, &all, 1e6);
  EXPECT_EQ(run(input, pipeline, &all).stages_cached, 0u);
  EXPECT_EQ(run(input, pipeline, &all).stages_cached, 2u);
}

struct Secret {
  static constexpr std::string_view product = "secret";
  int number = 0;
  friend bool operator==(const Secret&, const Secret&) = default;
};

/// Its extension does not say the number.
class SecretRow final : public ProductRow {
 public:
  SecretRow() : ProductRow({.name = "secret", .title = "secrets", .extension = "TEST_secret", .remedy = ""}) {}
  std::string read(ExtensionReader& from, Scene& scene) const override {
    if (from.of_file() != nullptr) scene.products.set(Secret{});
    return {};
  }
  void write(const Scene&, ExtensionWriter& to) const override { to.put_on_file("a secret"); }
  std::vector<std::string> follow(const Scene&, Scene&) const override { return {}; }
  ProductText told(const Scene&) const override { return {}; }
};

class MakesSecret final : public Processor {
 public:
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>&, Run&) const override {
    scene.products.set(Secret{7});
    return {};
  }
};

TEST_F(KeptMilestonesTest, WhatCanNotBeHeldIsToldAndMadeAgain) {
  Plugin secret = *registry_.find("weld");
  secret.card = {.name = "secret", .summary = "Makes a product that no file holds."};
  secret.kind = Kind::processor;
  secret.options.clear();
  secret.products = {std::make_shared<const SecretRow>()};
  secret.create = [](const Settings&) -> Technique { return std::make_unique<MakesSecret>(); };
  registry_.add(secret);
  const std::string input = of_corpus("scenes/kaykit_city/bench.gltf");
  const Pipeline pipeline = this->pipeline("weld, secret, tipsify, vertex-fetch");
  const MilestoneKeys all = keys(pipeline, 4, "");
  for (int round = 0; round < 2; ++round) {
    const Made made = run(input, pipeline, &all);
    EXPECT_EQ(made.stages_cached, round == 0 ? 0u : 1u) << "behind weld";
    const auto& notes = made.report.stages[1].notes;
    const auto note = std::ranges::find(notes, "not-cached", &NoteRecord::code);
    ASSERT_NE(note, notes.end());
    EXPECT_THAT(note->message, HasSubstr("'secret' holds more than its extension says"));
  }
}

}  // namespace
}  // namespace foredraw
