#include "applied_sides.h"
#include "side_choices.h"
#include "side_gains.h"
#include "side_search.h"
#include "sides.h"
#include "surrounding.h"

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/draw_mask.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

namespace foredraw {

namespace {

using processors::sides::Side;

enum class SeenFrom { anywhere, outside };

using processors::sides::Choice, processors::sides::Plan;

struct Options : processors::sides::SideSearchOptions, processors::sides::ChoiceOptions {
  SeenFrom seen_from = SeenFrom::anywhere;
};

/// Why the sides that are drawn of a double-sided draw have to stay, or nothing. `given`: [draw]
std::string why_kept(const Scene& scene, DrawId id, const std::vector<bool>& given, Analyses& analyses) {
  const Draw& draw = scene.draws[id];
  const Material& material = *scene.material_of(draw);
  if (material.alpha_mode == AlphaMode::blend) return "it is blended";
  if (material.displacement) return "a map of heights moves its surface";
  if (material.keeps_sides) return "light passes through its material, or an animation or a variant changes it";
  if (draw.levels.size() != 1) return "it has several levels of detail";
  if (draw.full().orders.size() != 1) return "it has several orders";
  if (draw.full().vertices->find("POSITION") == nullptr) return "it has no positions";
  if (const auto mask = mask_of(analyses, scene, draw); std::holds_alternative<std::string>(mask)) {
    return "it is not known where its holes are: " + std::get<std::string>(mask);
  }
  for (DrawId other = 0; other < scene.draws.size(); ++other) {
    if (given[other]) continue;
    for (const Level& level : scene.draws[other].levels) {
      if (level.vertices == draw.full().vertices) {
        return "it shares its vertices with " + scene.draws[other].name + ", which stays as it is";
      }
    }
  }
  return "";
}

/// Of a draw: triangles seen from both sides, and from behind alone.
struct Counted {
  explicit Counted(std::span<const Side> wanted)
      : triangles(wanted.size()),
        both(static_cast<std::size_t>(std::ranges::count(wanted, processors::sides::both))),
        turned(static_cast<std::size_t>(std::ranges::count(wanted, processors::sides::back))) {}

  std::size_t triangles, both, turned;
};

std::string copies_text(const Counted& count) {
  std::string text;
  if (count.both > 0) {
    text = fmt::format("{} of its {} triangles are seen from both sides and were copied", count.both, count.triangles);
  }
  if (count.turned > 0) {
    text += fmt::format("{}{} are seen only from behind and were flipped", text.empty() ? "" : "; ", count.turned);
  }
  return text;
}

/// How many its triangles use.
double vertices_of(const Draw& draw) {
  std::vector<bool> is_used(draw.full().vertices->count, false);
  for (const std::uint32_t index : draw.full().stream().indices.view()) is_used[index] = true;
  return static_cast<double>(std::ranges::count(is_used, true));
}

/// Fragments shaded of subjects with one of some draws, over a few poses, from a few of the run's views: this is told,
/// and decides nothing.
double shaded(const Scene& scene, std::span<const DrawId> draws, Run& run) {
  constexpr std::size_t most_poses = 4, most_views = 20;
  double result = 0;
  Views views{{}, run.views.size};
  const std::size_t every = (run.views.views.size() + most_views - 1) / most_views;
  for (std::size_t v = 0; v < run.views.views.size(); v += every) views.views.push_back(run.views.views[v]);
  const std::size_t step = (run.poses.poses.size() + most_poses - 1) / most_poses;
  for (const Subject& subject : subjects_of(scene, run.subjects)) {
    const bool is_asked = std::ranges::any_of(
        subject.parts, [&](const SubjectPart& part) { return std::ranges::binary_search(draws, part.draw); });
    if (!is_asked) continue;
    const bool moves = subject.is_placed() && run.poses.poses.size() > 1;
    for (std::size_t pose = 0; pose < (moves ? run.poses.poses.size() : 1); pose += step) {
      const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene, run.poses.poses[pose]) : PosedNodes();
      const auto drawn =
          subject_geometry(scene, subject, run.overdraw->faces(), nodes, run.analyses, ShownSurface::stored);
      for (const auto& part : run.overdraw->draw(drawn.parts, views, run)) {
        for (const OverdrawCount& count : part) result += static_cast<double>(count.shaded);
      }
    }
  }
  return result;
}

class SidesProcessor final : public Processor {
 public:
  explicit SidesProcessor(const Options& options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawId> asked = candidates(scene, draws, run);
    if (asked.empty()) {
      run.keep(run.findings.notes.empty() ? "no draw is double-sided"
                                          : "no double-sided draw can be changed; the notes say why");
      return draws;
    }
    processors::sides::SideSearchOptions search = options_;
    search.views = run.views;
    search.poses = run.poses;
    search.subjects = run.subjects;
    search.seed = run.seed;
    search.cancel = run.cancel;
    if (run.progress) search.progress = [&](double part) { run.progress(0.9 * part); };
    const processors::sides::FoundSides found =
        processors::sides::find_sides(scene, asked, search, run.analyses, run.executor);
    if (run.cancelled()) return {};
    processors::sides::SideGains gains = processors::sides::side_gains(scene, found.wanted, run.views, run.poses,
                                                                       run.subjects, run.analyses, run.executor);
    constexpr int rounds = 4;  // what is copied hangs together then, and shares its vertices
    for (auto& [id, of_triangles] : gains.of) {
      for (int i = 0; i < rounds; ++i) processors::sides::smooth(found.surfaces.at(id), of_triangles);
    }
    const std::map<DrawId, Plan> plans = planned(scene, found, gains);
    const double before = shaded(scene, asked, run);
    tell(scene, found, gains, plans, run);
    apply(scene, found, plans);
    if (before > 0) run.measure_at({}, "fragments", shaded(scene, asked, run), before);
    std::vector<DrawId> changed;
    for (const auto& [id, plan] : plans) {
      if (plan.choice != Choice::left) changed.push_back(id);
    }
    if (changed.empty()) run.keep("no change of a double-sided draw pays; the notes say why");
    return changed;
  }

 private:
  std::vector<DrawId> candidates(const Scene& scene, const std::vector<DrawId>& draws, Run& run) const {
    std::vector<bool> given(scene.draws.size(), false);
    for (const DrawId id : draws) given[id] = true;
    std::vector<DrawId> result;
    for (const DrawId id : draws) {
      const Material* material = scene.material_of(scene.draws[id]);
      if (material == nullptr || !material->double_sided || scene.draws[id].full().stream().indices.empty()) continue;
      const std::string why = why_kept(scene, id, given, run.analyses);
      if (!why.empty()) {
        run.note_at({id}, "stays-double-sided", "stays double-sided: " + why);
        continue;
      }
      result.push_back(id);
    }
    if (result.empty() || options_.seen_from == SeenFrom::outside) return result;
    const std::vector<bool> surrounds = processors::sides::surrounding_draws(scene, run.executor);
    std::erase_if(result, [&](DrawId id) {
      if (!surrounds[id]) return false;
      run.note_at({id}, "surrounds",
                  "stays double-sided: it surrounds other things, so a camera may stand inside (seen-from = outside "
                  "changes it all the same)");
      return true;
    });
    return result;
  }

  std::map<DrawId, Plan> planned(const Scene& scene, const processors::sides::FoundSides& found,
                                 const processors::sides::SideGains& gains) const {
    processors::sides::Sizes sizes{.visible = gains.visible};
    for (const Draw& draw : scene.draws) {
      sizes.triangles += static_cast<double>(draw.full().stream().triangle_count());
      sizes.vertices += vertices_of(draw);
    }
    std::map<DrawId, processors::sides::Sided> draws;
    for (const auto& [id, wanted] : found.wanted) {
      draws[id] = {wanted, gains.of.at(id), vertices_of(scene.draws[id])};
    }
    processors::sides::ChoiceOptions options = options_;
    options.split &= scene.products.empty();  // two draws have other numbers than one, which no product must mind
    return processors::sides::plans(draws, sizes, options);
  }

  static void apply(Scene& scene, const processors::sides::FoundSides& found, const std::map<DrawId, Plan>& plans) {
    processors::sides::SingleSidedMaterials materials(scene);
    for (const auto& [id, plan] : plans) {
      if (plan.choice == Choice::left) continue;
      if (plan.choice == Choice::two_draws) {
        processors::sides::split(scene, id, found.wanted.at(id), plan.stays, materials);
      } else {
        processors::sides::make_single_sided(scene, id, found.wanted.at(id), materials);
      }
    }
  }

  static void tell(const Scene& scene, const processors::sides::FoundSides& found,
                   const processors::sides::SideGains& gains, const std::map<DrawId, Plan>& plans, Run& run) {
    double single = 0, two = 0, added = 0, turned = 0, triangles = 0;
    for (const Draw& draw : scene.draws) triangles += static_cast<double>(draw.full().stream().triangle_count());
    for (const auto& [id, plan] : plans) {
      const Counted count(found.wanted.at(id));
      if (plan.choice == Choice::left) {
        double gain = 0;
        for (const double of_triangle : gains.of.at(id)) gain += of_triangle;
        run.note_at({id}, "stays-double-sided",
                    fmt::format("stays double-sided: {} of its {} triangles show their back, and at most {:.2f} per "
                                "cent of the fragments could be saved",
                                count.both + count.turned, count.triangles, 100 * gain / std::max(1.0, gains.visible)));
        continue;
      }
      (plan.choice == Choice::two_draws ? two : single) += 1;
      added += static_cast<double>(plan.added);
      turned += static_cast<double>(count.turned);
      if (plan.choice == Choice::single_sided) {
        run.note_at({id}, "single-sided",
                    std::ranges::all_of(found.surfaces.at(id).is_closed, std::identity())
                        ? "drawn single-sided: closed and facing outwards, confirmed by pictures"
                        : "drawn single-sided: no picture and no ray shows a back of it");
      } else if (plan.choice == Choice::copies) {
        run.note_at({id}, "single-sided", fmt::format("drawn single-sided: {}", copies_text(count)));
      } else {
        run.note_at({id}, "two-draws",
                    fmt::format("drawn as two draws: {} of its {} triangles are seen from both sides; {} of these stay "
                                "double-sided, and {} were copied",
                                count.both, count.triangles, count.both - plan.added, plan.added));
      }
    }
    run.count_at({}, "single-sided", single);
    run.count_at({}, "two-draws", two);
    run.measure_at({}, "added", added, triangles);
    run.measure_at({}, "turned", turned, triangles);
    if (found.shown > 0) {
      run.measure_at({}, "contradicted", static_cast<double>(found.wrong), static_cast<double>(found.shown));
    }
  }

  Options options_;
};

}  // namespace

Plugin sides_plugin() {
  OptionTable<Options> table;
  table.choice(&Options::seen_from, "seen-from",
               "Where cameras may be. anywhere: draws that surround other things, such as a sky dome or a room, stay "
               "double-sided; outside: cameras never stand inside anything",
               {{"anywhere", SeenFrom::anywhere}, {"outside", SeenFrom::outside}});
  table.row(&processors::sides::ChoiceOptions::most_added, "most-added",
            "Most triangles that may be added to the scene as reversed copies, as a share of its triangles",
            {0, 1, ""});
  table.row(&processors::sides::ChoiceOptions::split, "split",
            "Split a draw in two, one of them double-sided, where too many triangles would be added");
  table.row(&processors::sides::ChoiceOptions::vertex_weight, "vertex-weight",
            "Where triangles are copied: how many per cent of the fragments one per cent more vertices must save",
            {0, 1000, ""});
  table.row(&processors::sides::SideSearchOptions::rays, "rays",
            "Rays cast from each side that no picture shows, half of them into an opening; more find smaller gaps and "
            "take longer",
            {0, 65536, "rays"});
  table.row(
      &processors::sides::SideSearchOptions::checks, "checks",
      "Pictures of 256 x 256, from views and in poses not used before, that the last check of the result takes; of "
      "large meshes fewer and larger ones",
      {1, 100000, "pictures"});

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "sides",
      .summary = "Draws double-sided meshes single-sided and leaves out back sides that are never seen",
      .reference = "own",
      .acts_on = {traits::triangles},
      .breaks = {traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "a double-sided mesh has back sides that are drawn but never seen",
      .uses_overdraw = true,
      .metrics = {{"single-sided", "draws", "Double-sided draws that became single-sided", false},
                  {"two-draws", "draws", "Double-sided draws that became two, one of them single-sided", false},
                  {"added", "per triangle", "Triangles added as reversed copies"},
                  {"turned", "per triangle", "Triangles of which only the back is seen, now flipped", false},
                  {"fragments", "per fragment before", "Fragments shaded after the stage, with triangles as they came"},
                  {"contradicted", "per pixel checked",
                   "Pixels of the last check that lacked a side, which was put back"}},
  };
  bind_options(plugin, std::move(table),
               [](const Options& options) { return std::make_unique<SidesProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
