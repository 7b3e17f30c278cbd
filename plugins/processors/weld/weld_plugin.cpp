#include "weld.h"

#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <algorithm>

namespace foredraw {

namespace {

class WeldProcessor final : public Processor {
 public:
  explicit WeldProcessor(WeldOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<VertexGroup> groups = vertex_groups(scene);
    for (const HeldDraw& held : keep_groups_of(groups, draws)) {
      run.note_at(
          {held.draw}, "shared-vertices",
          "not welded: it shares its vertices with " + scene.draws[held.by].name + ", which must stay as it is");
    }

    std::vector<Weld> welds(groups.size());
    run.executor.for_each(groups.size(), [&](std::size_t i) {
      welds[i] = weld(*groups[i].vertices, index_streams_of(scene, groups[i]), options_);
    });
    std::vector<DrawId> welded;
    bool any = false;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      for (const VertexGroup::User& user : groups[i].users) welded.push_back(user.draw);
      const About first_user{.draw = groups[i].users.front().draw};
      run.count_at(first_user, "merged", welds[i].merged);
      run.count_at(first_user, "unused", welds[i].unused);
      if (welds[i].count == groups[i].vertices->count) continue;
      move_vertices(scene, groups[i], welds[i].destination, welds[i].count);
      any = true;
    }
    if (!any)
      run.keep(options_.keep_unused ? "no two vertices are equal" : "no two vertices are equal, and all are used");
    return welded;
  }

 private:
  WeldOptions options_;
};

}  // namespace

Plugin weld_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "weld",
      .summary =
          "Merges vertices that are equal in every bit of every attribute and morph target; put it before all orderers",
      .reference = "common practice",
      .acts_on = {traits::triangles},
      .provides = {traits::welded},
      .lossless = true,
      .metrics = {{"merged", "vertices", "Vertices removed because they equal an earlier one", false},
                  {"unused", "vertices", "Vertices removed because no triangle uses them", false}},
  };
  OptionTable<WeldOptions> table;
  table.row(&WeldOptions::keep_unused, "keep-unused", "Keep vertices that no triangle uses, instead of removing them");
  bind_options(plugin, table, [](const WeldOptions& options) { return std::make_unique<WeldProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
