#include "prune.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/base/counted.h>
#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

struct PruneOptions {
  bool attributes = true;
  bool tracks = true;
  bool lists = true;
  bool equal = true;
  bool names = true;
};

class PruneProcessor final : public Processor {
 public:
  explicit PruneProcessor(PruneOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawId> changed = prune_vertices(scene, draws, run);
    const ListCare before = scene.lists;
    scene.lists = {.leaves_out_unnamed = before.leaves_out_unnamed || options_.lists,
                   .joins_equal = before.joins_equal || options_.equal,
                   .keeps_names = before.keeps_names && options_.names};
    const std::size_t tracks = options_.tracks ? prune_tracks(scene, draws, run) : 0;
    run.count_at({}, "tracks-left-out", static_cast<double>(tracks));
    if (changed.empty() && tracks == 0 && scene.lists == before) run.keep("all attributes and tracks are needed");
    return draws;
  }

 private:
  /// Of all that draw the same vertices.
  std::optional<VertexNeeds> needs_of_group(const VertexGroup& group, const Scene& scene) const {
    if (!options_.attributes) return std::nullopt;
    VertexNeeds all;
    for (const VertexGroup::User& user : group.users) {
      const auto needs = needs_of(scene.draws[user.draw], scene);
      if (!needs) return std::nullopt;
      all.texcoords |= needs->texcoords;
      all.has_tangents |= needs->has_tangents;
    }
    return all;
  }

  std::vector<DrawId> prune_vertices(Scene& scene, const std::vector<DrawId>& draws, Run& run) const {
    std::vector<VertexGroup> groups = vertex_groups(scene);
    keep_groups_of(groups, draws);
    std::vector<DrawId> changed;
    for (const VertexGroup& group : groups) {
      const PrunedStreams made = prune_streams(*group.vertices, needs_of_group(group, scene));
      if (made.pruned.empty()) continue;
      const About about{.draw = group.users.front().draw};
      for (const PrunedStream& stream : made.pruned) {
        run.note_at(about, "left-out", stream.semantic + " is left out: " + stream.why);
      }
      for (const VertexGroup::User& user : group.users) {
        scene.draws[user.draw].levels[user.level].vertices = made.vertices;
        changed.push_back(user.draw);
      }
    }
    return changed;
  }

  /// How many.
  static std::size_t prune_tracks(Scene& scene, const std::vector<DrawId>& draws, Run& run) {
    double size = 0;
    for (const DrawId id : draws) {
      size = std::max(size, diagonal_of(positions_of(run.analyses, *scene.draws[id].full().vertices)->values));
    }
    std::size_t count = 0;
    for (Animation& animation : scene.animations) {
      const std::vector<bool> rest = resting_tracks(animation, scene.nodes, {.translation = 1e-6 * size});
      std::vector<AnimationChannel> left;
      for (std::size_t c = 0; c < rest.size(); ++c) {
        if (!rest[c]) left.push_back(std::move(animation.channels[c]));
      }
      count += rest.size() - left.size();
      animation.channels = std::move(left);
    }
    if (count > 0) {
      run.note("left-out", fmt::format("tracks of animations are left out, as they stay where their node rests: {}",
                                       counted(count)));
    }
    return count;
  }

  PruneOptions options_;
};

}  // namespace

Plugin prune_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "prune",
      .summary =
          "Leaves out attributes, tracks of animations, materials, images and nodes that change nothing of what is "
          "shown",
      .reference = "common practice",
      .acts_on = {traits::triangles},
      .pays_if = "some attribute or track changes nothing",
      .measured_by = {"scene-cost"},
      .metrics = {{"tracks-left-out", "tracks", "Tracks that stay where their node rests", false}},
  };
  OptionTable<PruneOptions> table;
  table.row(&PruneOptions::attributes, "attributes",
            "Leave out texture coordinates and tangents that no texture of the material needs. Turn it off where an "
            "engine puts materials of its own");
  table.row(
      &PruneOptions::tracks, "tracks",
      "Leave out tracks that stay where their node rests. Turn it off where an engine plays one clip after another "
      "without going back to rest");
  table.row(
      &PruneOptions::lists, "lists",
      "Leave out materials, textures, images, skins and cameras that nothing names, and nodes without a name that "
      "show and move nothing, where glTF is written");
  table.row(&PruneOptions::equal, "equal",
            "Write equal materials, textures, samplers and images once, and in compressed files equal accessors");
  table.row(&PruneOptions::names, "names",
            "Whether equal materials of different names stay, and nodes with a name that show and move nothing, as "
            "engines may look for them");
  bind_options(plugin, table, [](const PruneOptions& options) { return std::make_unique<PruneProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
