#include "progressive_stream.h"
#include "stream_product.h"

#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/technique/plugin.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

struct StageOptions : ProgressiveStreamOptions {
  bool keep_sequences = false;
};

/// A mesh's stream, or why it has none.
struct Answer {
  Shared<std::byte> bytes;
  std::size_t vertices = 0;
  std::string why_not;
};

class ProgressiveStreamProcessor final : public Processor {
 public:
  explicit ProgressiveStreamProcessor(StageOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawsCollapse> meshes = sequences_of(scene, draws);
    std::vector<Answer> answers(meshes.size());
    run.executor.for_each(meshes.size(), [&](std::size_t i) { answers[i] = stream_of(meshes[i], scene, run); });
    ProgressiveStreams all;
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < meshes.size() && !run.cancelled(); ++i) {
      const About about{.draw = meshes[i].draws.front()};
      if (!answers[i].why_not.empty()) {
        run.note_at(about, "no-stream", "no progressive stream: " + answers[i].why_not);
        continue;
      }
      const auto bytes = static_cast<double>(answers[i].bytes.size());
      run.measure_at(about, "bytes", bytes, static_cast<double>(answers[i].vertices));
      changed.insert(changed.end(), meshes[i].draws.begin(), meshes[i].draws.end());
      all.meshes.push_back({meshes[i].draws, answers[i].bytes});
    }
    if (meshes.empty()) {
      run.keep("no mesh has a sequence of collapses, such as `quadric-collapse` finds before this stage");
      return {};
    }
    std::ranges::sort(changed);
    if (!all.meshes.empty()) scene.products.set(std::move(all));
    if (!options_.keep_sequences) remove_sequences(scene, meshes);
    return changed;
  }

 private:
  Answer stream_of(const DrawsCollapse& of, const Scene& scene, Run& run) const {
    const auto mesh = joined_mesh(scene, of.draws, run.analyses);
    if (!mesh) return {{}, 0, "a draw of its sequence of collapses is gone"};
    const Replay replayed = replay(*of.sequence, mesh->positions, mesh->indices, mesh->part);
    if (!replayed.mistake.empty()) throw std::runtime_error(replayed.mistake);
    if (!leaves_vertices(*of.sequence, *mesh)) {
      return {{}, 0, "its vertices move as it becomes coarser; set quadric-collapse.placement to \"endpoint\""};
    }
    try {
      ProgressiveStream stream = progressive_stream(*mesh, *of.sequence, options_, run.cancel);
      return {Shared<std::byte>(std::move(stream.bytes)), stream.vertex.size(), {}};
    } catch (const std::runtime_error& error) {
      return {{}, 0, error.what()};
    }
  }

  StageOptions options_;
};

}  // namespace

Plugin progressive_stream_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "progressive-stream",
      .summary = "Packs each mesh into a small stream of chunks, each of which makes what is drawn finer",
      .reference = "Hoppe 1996, sections 3 and 5",
      .acts_on = {traits::triangles},
      .needs = {traits::progressive},
      .lossless = true,
      .metrics = {{"bytes", "bytes per vertex", "size of the streams, with all attributes that vertices have"}},
  };
  plugin.products = {stream_product(), collapse_product()};
  OptionTable<StageOptions> table;
  table
      .row(&StageOptions::position_bits, "position-bits", "How finely positions are stored, along the longest side",
           {4, 20, "bits"})
      .row(&StageOptions::uv_bits, "uv-bits", "How finely texture coordinates are stored", {4, 24, "bits"})
      .row(&StageOptions::normal_bits, "normal-bits", "How finely normals and tangents are stored", {4, 24, "bits"})
      .row(&StageOptions::other_bits, "other-bits", "How finely other numbers are stored, if they are floats",
           {4, 24, "bits"})
      .row(&StageOptions::lossless, "lossless", "Store all floats exactly; position-bits then only guides the coder")
      .row(&StageOptions::chunk_size, "chunk-size", "Approximate size of a chunk", {1024, 1 << 24, "bytes"})
      .row(&StageOptions::growth, "growth",
           "How many times as many vertices a pass over the mesh may reach as the one before: near 1 for chunks that "
           "are closer to the best mesh of their size, more for smaller streams",
           {1.05, 16})
      .row(&StageOptions::keep_sequences, "keep-sequences",
           "Keep the sequences of collapses for a later stage, and in the file; otherwise they are used up");
  bind_options(plugin, table,
               [](const StageOptions& options) { return std::make_unique<ProgressiveStreamProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
