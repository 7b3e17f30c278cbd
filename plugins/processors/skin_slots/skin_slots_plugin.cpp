#include "skin_slots.h"

#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <algorithm>

namespace foredraw {

namespace {

class SkinSlotsProcessor final : public Processor {
 public:
  explicit SkinSlotsProcessor(SkinSlotsOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<VertexGroup> groups = vertex_groups(scene);
    for (const HeldDraw& held : keep_groups_of(groups, draws)) {
      run.note_at({held.draw}, "shared-vertices",
                  "its joints stay in their slots: it shares its vertices with " + scene.draws[held.by].name +
                      ", which must stay as it is");
    }
    std::vector<SlottedSkin> made(groups.size());
    run.executor.for_each(groups.size(), [&](std::size_t i) { made[i] = keep_slots(*groups[i].vertices, options_); });
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const About about{.draw = groups[i].users.front().draw};
      if (!made[i].why_not.empty()) run.note_at(about, "slots-stay", "its joints stay: " + made[i].why_not);
      if (made[i].vertices->stamp() == groups[i].vertices->stamp()) continue;
      run.count_at(about, "moved", made[i].moved);
      for (const VertexGroup::User& user : groups[i].users) {
        scene.draws[user.draw].levels[user.level].vertices = made[i].vertices;
        changed.push_back(user.draw);
      }
    }
    if (changed.empty()) run.keep("joints are in the slots of the vertices before already");
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

 private:
  SkinSlotsOptions options_;
};

}  // namespace

Plugin skin_slots_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "skin-slots",
      .summary =
          "Puts joints and weights into the slots where the vertex before has the same joints, so that compressed "
          "files "
          "are short; put it last",
      .reference = "own",
      .acts_on = {traits::triangles, traits::skinned},
      .pays_if = "the file is written compressed",
      .measured_by = {"scene-cost"},
      .metrics = {{"moved", "vertices", "Vertices whose joints have other slots", false}},
  };
  OptionTable<SkinSlotsOptions> table;
  table.row(
      &SkinSlotsOptions::zero_unused, "zero-unused",
      "Whether slots without weight name joint 0, as glTF advises; else they name the joint of the vertex before, "
      "which takes fewer bytes");
  bind_options(plugin, table,
               [](const SkinSlotsOptions& options) { return std::make_unique<SkinSlotsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
