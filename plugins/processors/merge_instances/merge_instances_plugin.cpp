#include "merge_instances.h"
#include "merge_scene.h"
#include "merged_draws_product.h"
#include "slot_order.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace foredraw {

namespace {

/// A note for each draw and reason, however many nodes place it.
void note_left_alone(const MergedScene& merged, const Run& run) {
  std::map<std::pair<DrawId, std::string>, std::size_t> placements;
  for (const processors::merge_instances::LeftAlone& left : merged.left_alone) {
    placements[{left.draw, left.why}] += left.node ? 1 : 0;
  }
  for (const auto& [place, count] : placements) {
    const auto& [draw, why] = place;
    run.note_at({draw}, "not-merged",
                count == 0
                    ? fmt::format("not merged: {}", why)
                    : fmt::format("not merged in {} {}: {}", count, count == 1 ? "placement" : "placements", why));
  }
  for (const processors::merge_instances::MergeableSet& set : merged.not_merged) {
    if (set.meshes.empty()) continue;
    const std::size_t others = set.meshes.size() - 1;
    const std::string with = others == 0 ? ""
                                         : fmt::format(", with {} other {} of the same material and vertex layout",
                                                       others, others == 1 ? "draw" : "draws");
    run.note_at({set.meshes.front().draw}, "not-merged", fmt::format("not merged{}: {}", with, set.why_not));
  }
}

/// Draw calls of nodes that merged draws do not show whole.
std::size_t draws_left(const Scene& scene) {
  const std::vector<MergedPlace> merged = merged_places(scene);
  std::size_t draws = 0;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh || !node.is_shown) continue;
    for (std::uint32_t primitive = 0; primitive < scene.meshes[*node.mesh].draws.size(); ++primitive) {
      const auto drawn = [](const MergedPlace& place) { return std::pair(place.node, place.primitive); };
      const auto first = std::ranges::lower_bound(merged, std::pair(n, primitive), {}, drawn);
      const auto end = std::ranges::upper_bound(merged, std::pair(n, primitive), {}, drawn);
      draws += static_cast<std::size_t>(end - first) < std::max<std::size_t>(1, node.instances.size());
    }
  }
  return draws;
}

/// Of a group by itself, from all views.
OverdrawCount overdraw_of(const Scene& scene, const MergedInstances& merged, std::uint32_t group, Run& run) {
  const Scene alone = processors::merge_instances::group_scene(scene, merged, group);
  Subject subject{scene.name, {}};
  for (DrawId id = 0; id < alone.draws.size(); ++id) subject.parts.push_back({id, {}});
  OverdrawCount sum;
  for (const auto& part : run.overdraw->count(alone, subject, run.views, run)) {
    for (const OverdrawCount& count : part) sum += count;
  }
  return sum;
}

/// Slots sorted where that lowers their group's measured overdraw: the rule is a guess.
MergedInstances with_less_overdraw(const Scene& scene, MergedInstances merged, Run& run) {
  MergedInstances sorted = merged;
  sorted.slots = Shared(processors::merge_instances::outward_slots(merged, run.executor));
  std::vector<MergedSlot> slots(merged.slots.view().begin(), merged.slots.view().end());
  OverdrawCount before, after;
  for (std::uint32_t g = 0; g < merged.groups.size() && !run.cancelled(); ++g) {
    if (run.progress) run.progress(static_cast<double>(g) / static_cast<double>(merged.groups.size()));
    const OverdrawCount as_is = overdraw_of(scene, merged, g, run);
    const OverdrawCount outwards = overdraw_of(scene, sorted, g, run);
    const bool is_better = outwards.shaded < as_is.shaded;
    before += as_is;
    after += is_better ? outwards : as_is;
    if (!is_better) continue;
    for (const MergedDraw& draw : merged.draws) {
      if (draw.group != g) continue;
      std::ranges::copy(sorted.slots.view().subspan(draw.first_slot, draw.slot_count), slots.begin() + draw.first_slot);
    }
  }
  merged.slots = Shared(std::move(slots));
  const auto ratio = [](const OverdrawCount& count) {
    return count.visible == 0 ? 1 : static_cast<double>(count.shaded) / static_cast<double>(count.visible);
  };
  run.note_at(
      {}, "overdraw",
      fmt::format("slots sorted: the groups' overdraw went from {:.4f} to {:.4f}", ratio(before), ratio(after)));
  return merged;
}

struct Options : MergeSceneOptions {
  bool overdraw_order = false;  // sort the slots of each group where that pays
};

class MergeInstancesProcessor final : public Processor {
 public:
  explicit MergeInstancesProcessor(const Options& options) : options_(options) {
    if (options.multiple % 3 == 0) return;
    throw std::invalid_argument(
        fmt::format("multiple is {}; it must be a multiple of 3, so that no triangle is cut", options.multiple));
  }

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    MergeSceneOptions options = options_;
    options.poses = run.poses;
    const MergedScene merged = merge_scene(scene, draws, options, run.executor);
    note_left_alone(merged, run);
    if (merged.merged.empty()) {
      run.keep(draws.empty() ? "there is no draw to merge" : "nothing is worth merging; the notes say why");
      return {};
    }
    std::vector<DrawId> changed;
    const auto* before = scene.products.find<MergedDraws>();
    MergedDraws all = before == nullptr ? MergedDraws() : *before;
    for (const MergedSet& set : merged.merged) {
      MergedInstances made = merged_instances(scene, set);
      all.sets.push_back(options_.overdraw_order ? with_less_overdraw(scene, std::move(made), run) : std::move(made));
      for (const processors::merge_instances::MergeableMesh& mesh : set.set.meshes) {
        changed.push_back(mesh.draw);
      }
    }
    scene.products.set(std::move(all));
    measure(merged, scene, run);
    std::ranges::sort(changed);
    return changed;
  }

 private:
  static void measure(const MergedScene& merged, const Scene& scene, const Run& run) {
    double entries = 0, padded = 0, slots = 0, placed = 0, bytes = 0, groups = 0, wasted = 0;
    double draws = static_cast<double>(draws_left(scene));
    for (const MergedInstances& set : merged_sets(scene)) draws += static_cast<double>(set.draws.size());
    for (const MergedSet& set : merged.merged) {
      entries += static_cast<double>(set.packed.drawn_entries);
      padded += static_cast<double>(set.packed.padded_entries);
      slots += static_cast<double>(set.packed.slots.size());
      placed += static_cast<double>(set.packed.placed.size());
      bytes += static_cast<double>(set.packed.bytes());
      groups += static_cast<double>(set.layout.groups.size());
      wasted += set.layout.groups.cost.wasted;
    }
    run.measure_at({}, "padding", padded, entries + padded);
    run.count_at({}, "draws", draws);
    run.count_at({}, "slots", slots);
    run.measure_at({}, "slot-bytes", 8 * slots, placed);
    run.count_at({}, "bytes", bytes);
    run.count_at({}, "groups", groups);
    run.measure_at({}, "wasted", wasted, entries);
  }

  Options options_;
};

}  // namespace

Plugin merge_instances_plugin() {
  OptionTable<Options> table;
  table.choice(&MergeSceneOptions::materials, "materials",
               "Which draws are merged. alike: those whose materials look the same; kind: those whose materials differ "
               "only in factors and textures, which the shader looks up for each instance",
               {{"alike", processors::merge_instances::SharedMaterials::alike},
                {"kind", processors::merge_instances::SharedMaterials::kind}});
  table.row(&MergeSceneOptions::skinned, "skinned",
            "Merge skinned draws too; the groups' boxes then enclose them in the pipeline's poses");
  table.row(&MergeInstancesOptions::multiple, "multiple",
            "Slot sizes are multiples of this: 3, or the size of the GPU's primitive groups", {3, 3072, "entries"});
  table.row(&MergeInstancesOptions::frequencies, "frequencies",
            "Most slot sizes; more pad less or need fewer slots, but each adds a draw call to each group",
            {1, 4, "sizes"});
  table.choice(&MergeInstancesOptions::goal, "goal",
               "How slot sizes are chosen. fewest-slots: the fewest within most-padding; least-cost: the lowest cost "
               "of padding, slot records and draw calls",
               {{"fewest-slots", FrequencyGoal::fewest_slots}, {"least-cost", FrequencyGoal::least_cost}});
  table.row(&MergeInstancesOptions::most_padding, "most-padding",
            "With fewest-slots: largest share of padding among all index entries", {0, 1, ""});
  table.row(&MergeInstancesOptions::padded_cost, "padded-cost", "With least-cost: cost of a padded index entry",
            {0, 1e6, "bytes"});
  table.row(&MergeInstancesOptions::slot_byte_cost, "slot-byte-cost", "With least-cost: cost of a byte of slot records",
            {0, 1e6, "bytes"});
  table.row(&MergeInstancesOptions::draw_cost, "draw-cost",
            "Cost of a draw call; higher merges more meshes into fewer, larger groups",
            {0, 1e9, "vertex shader calls"});
  table.row(&MergeInstancesOptions::most_indices, "most-indices", "Most index entries of a group",
            {3, 4294967295.0, "entries"});
  table.row(&MergeInstancesOptions::most_instances, "most-instances", "Most instances of a group",
            {1, 4294967295.0, "instances"});
  table.row(&MergeInstancesOptions::most_size, "most-size",
            "Longest side that a group's box may have, in the scene's units; 0: any", {0, 1e30, ""});
  table.row(&MergeInstancesOptions::view_distance, "view-distance",
            "How far cameras see, in the scene's units, which decides how large groups get; 0: a quarter of the "
            "scene's diagonal",
            {0, 1e30, ""});
  table.row(&MergeInstancesOptions::cut_well, "cut-well",
            "Use the padding to cut meshes into slots where few vertices are shared");
  table.row(&Options::overdraw_order, "overdraw-order",
            "Sort the slots of each group for low overdraw, and keep that where its overdraw from the pipeline's views "
            "falls; takes time");

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "merge-instances",
      .summary =
          "Merges many instances of many meshes into few draw calls, no vertex stored twice; the nodes stay as a "
          "fallback",
      .reference = "Persson, Graphics Gems for Games, SIGGRAPH 2012, Merge-Instancing",
      .acts_on = {traits::triangles},
      .pays_if =
          "several meshes of the same material and vertex layout are placed often, and vertex shading is not the "
          "bottleneck",
      .uses_overdraw = true,
      .lossless = true,
      .measured_by = {"scene-cost"},
      .metrics = {{"padding", "of index entries", "Share of padding among the index entries drawn"},
                  {"draws", "draws", "Draw calls of the scene: the merged ones and those that remain"},
                  {"slots", "slots", "Slots of all merged draws"},
                  {"slot-bytes", "bytes", "Bytes of slot records for each merged instance"},
                  {"bytes", "bytes", "Bytes of merged indices, slot records and transforms"},
                  {"groups", "groups", "Groups of instances, each culled as a whole"},
                  {"wasted", "of index entries",
                   "Share of index entries drawn although their instance alone would be culled, expected over all "
                   "camera positions and directions that see some of the scene"}},
  };
  plugin.products = {merged_draws_product()};
  bind_options(plugin, std::move(table),
               [](const Options& options) { return std::make_unique<MergeInstancesProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
