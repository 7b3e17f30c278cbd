#include "sprite_frames.h"

#include "quad_cutting.h"

#include <foredraw/measuring/alpha_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

/// What is to become of a draw.
struct Cut {
  std::vector<SpriteFrame> frames;
  std::string why_not;
};

/// Puts the draws in the place of one. A mesh that held it alone holds the first of them; nodes that showed it hold a
/// node for each, and so stay what animations move.
std::vector<DrawId> put_in_place(Scene& scene, DrawId id, std::vector<Draw> cut) {
  const std::size_t first_new = scene.draws.size();
  std::vector<DrawId> ids{id};
  for (std::size_t i = 1; i < cut.size(); ++i) ids.push_back(static_cast<DrawId>(first_new + i - 1));
  scene.draws[id] = std::move(cut[0]);
  std::move(cut.begin() + 1, cut.end(), std::back_inserter(scene.draws));

  const std::size_t meshes = scene.meshes.size();
  for (MeshId m = 0; m < meshes; ++m) {
    if (std::ranges::find(scene.meshes[m].draws, id) == scene.meshes[m].draws.end()) continue;
    const bool was_alone = scene.meshes[m].draws.size() == 1;
    std::vector<MeshId> made;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Mesh mesh{scene.draws[ids[i]].name, {ids[i]}, {}};
      if (i == 0 && was_alone) {
        scene.meshes[m] = std::move(mesh);
        made.push_back(m);
      } else {
        made.push_back(static_cast<MeshId>(scene.meshes.size()));
        scene.meshes.push_back(std::move(mesh));
      }
    }
    if (!was_alone) std::erase(scene.meshes[m].draws, id);

    const std::size_t nodes = scene.nodes.size();
    for (NodeId n = 0; n < nodes; ++n) {
      if (scene.nodes[n].mesh != m) continue;
      if (was_alone) scene.nodes[n].mesh.reset();
      for (const MeshId mesh : made) {
        scene.nodes[n].children.push_back(static_cast<NodeId>(scene.nodes.size()));
        Node child;
        child.name = scene.meshes[mesh].name;
        child.mesh = mesh;
        scene.nodes.push_back(std::move(child));
      }
    }
  }
  return ids;
}

class SpriteFramesProcessor final : public Processor {
 public:
  explicit SpriteFramesProcessor(const SpriteFramesOptions& options) : options_(options) {
    if (options.find && (options.columns > 1 || options.rows > 1)) {
      throw std::invalid_argument(
          "find = true finds the frames by itself: leave out columns and rows, or set find = false");
    }
  }

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    if (draws.empty()) {
      run.keep("there is no sprite to cut");
      return {};
    }
    if (!options_.find && options_.columns == 1 && options_.rows == 1) {
      run.keep("neither a grid nor find is set: set columns and rows, or find = true");
      return {};
    }
    std::vector<Cut> cuts(draws.size());
    run.executor.for_each(draws.size(), [&](std::size_t i) { cuts[i] = cut_of(scene, scene.draws[draws[i]], run); });
    std::vector<DrawId> done;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const DrawId id = draws[i];
      if (!cuts[i].why_not.empty()) {
        run.note_at({id}, "not-cut", "not cut into frames: " + cuts[i].why_not);
        continue;
      }
      run.count_at({id}, "frames", static_cast<double>(cuts[i].frames.size()));
      const std::vector<DrawId> ids = put_in_place(scene, id, named_cuts(scene, id, cuts[i].frames));
      done.insert(done.end(), ids.begin(), ids.end());
    }
    if (done.empty()) run.keep("no sprite can be cut; the notes say why");
    std::ranges::sort(done);
    return done;
  }

 private:
  Cut cut_of(const Scene& scene, const Draw& draw, const Run& run) const {
    Cut cut{{}, why_not_cut(scene, draw)};
    if (!cut.why_not.empty()) return cut;
    if (options_.find) {
      cut.frames = found_in(scene, draw, run);
      if (cut.frames.empty()) cut.why_not = "no texel is above the threshold";
      if (cut.frames.size() == 1 && cut.frames[0] == *draw.frame)
        cut.why_not = "it is a single part that fills its frame";
      return cut;
    }
    try {
      cut.frames = grid_frames(*draw.frame, options_.columns, options_.rows);
    } catch (const std::invalid_argument& too_small) {
      cut.why_not = too_small.what();
    }
    return cut;
  }

  std::vector<SpriteFrame> found_in(const Scene& scene, const Draw& draw, const Run& run) const {
    const Image& image = scene.images[*scene.material_of(draw)->base_colour->image];
    const auto decoded = alpha_image_of(run.analyses, image, options_.channel);
    if (const std::string* why = std::get_if<std::string>(&decoded)) {
      throw std::runtime_error(fmt::format("{}: its image cannot be read: {}", draw.name, *why));
    }
    const AlphaImage& alpha = *std::get<std::shared_ptr<const AlphaImage>>(decoded);
    if (alpha.width != image.facts->width || alpha.height != image.facts->height) {
      throw std::runtime_error(draw.name + ": its image does not have the size that its header states");
    }
    try {
      return found_frames(alpha, *draw.frame, options_);
    } catch (const std::runtime_error& problem) {
      throw std::runtime_error(fmt::format("{}: {}", draw.name, problem.what()));
    }
  }

  /// "Smoke/00" to "Smoke/15".
  static std::vector<Draw> named_cuts(const Scene& scene, DrawId id, std::span<const SpriteFrame> frames) {
    std::vector<Draw> cut = cut_draws(scene, scene.draws[id], frames);
    const std::size_t digits = std::to_string(cut.size() - 1).size();
    for (std::size_t i = 0; i < cut.size(); ++i) cut[i].name = fmt::format("{}/{:0{}}", cut[i].name, i, digits);
    return cut;
  }

  SpriteFramesOptions options_;
};

}  // namespace

Plugin sprite_frames_plugin() {
  OptionTable<SpriteFramesOptions> table;
  table.row(&SpriteFramesOptions::columns, "columns",
            "Columns of a grid of equal cells; with one column and one row nothing is cut", {1, 1024, "columns"});
  table.row(&SpriteFramesOptions::rows, "rows", "Rows of the grid", {1, 1024, "rows"});
  table.row(&SpriteFramesOptions::find, "find",
            "Find the sprites by the empty gaps between them, instead of by a grid");
  table.row(&SpriteFramesOptions::threshold, "threshold",
            "With find: texels with more alpha than this belong to a sprite", {0, 1, ""});
  add_alpha_channel(table, &SpriteFramesOptions::channel);
  table.row(&SpriteFramesOptions::gutter, "gutter",
            "With find: fewest empty texels between two sprites; what lies closer is one sprite", {1, 1024, "texels"});

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "sprite-frames",
      .summary = "Cuts sheets of sprites into one draw for each sprite, by a grid or at the empty gaps",
      .reference = "own",
      .acts_on = {traits::sprite},
      .breaks = {traits::clustered, traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered},
      .pays_if = "a grid or find is set, and the draw is one quad that shows its frame of an image",
      .measured_by = {"sprite-fill"},
      .metrics = {{"frames", "frames", "Draws that a sheet was cut into", false}},
  };
  bind_options(plugin, std::move(table),
               [](const SpriteFramesOptions& options) { return std::make_unique<SpriteFramesProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
