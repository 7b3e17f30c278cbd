#include "applied_sides.h"
#include "side_choices.h"
#include "side_search.h"
#include "sides.h"
#include "surrounding.h"

#include <foredraw/technique/overdraw_service.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/draw_mask.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using sides::Side;

enum class SeenFrom { anywhere, outside };

using sides::Choice, sides::Counted;

struct Options : sides::SideSearchOptions, sides::ChoiceOptions {
  SeenFrom seen_from = SeenFrom::anywhere;
};

/// Why the sides that are drawn of a double-sided draw have to stay, or nothing. `given`: [draw]
std::string why_kept(const Scene& scene, DrawId id, const std::vector<bool>& given, Analyses& analyses) {
  const Draw& draw = scene.draws[id];
  const Material& material = *scene.material_of(draw);
  if (material.alpha_mode == AlphaMode::blend) return "it is blended";
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

std::string copies_text(const Counted& count) {
  std::string text;
  if (count.added > 0) {
    text = fmt::format("{} of its {} triangles are seen from both sides and were copied", count.added, count.triangles);
  }
  if (count.turned > 0) {
    text += fmt::format("{}{} are seen only from behind and were flipped", text.empty() ? "" : "; ", count.turned);
  }
  return text;
}

/// [draw] fragments shaded, and of all: visible; of subjects with one of some draws, over a few poses, from a few of
/// the run's views: a price need not be known to the hundredth.
struct Shaded {
  std::map<DrawId, double> of;
  double visible = 0;
};

Shaded shaded(const Scene& scene, std::span<const DrawId> draws, Run& run) {
  constexpr std::size_t most_poses = 4, most_views = 20;
  Shaded result;
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
      const auto drawn = subject_geometry(scene, subject, run.overdraw->faces(), nodes, run.analyses);
      const OverdrawCounts counts = run.overdraw->draw(drawn.parts, views, run);
      for (std::size_t part = 0; part < counts.size(); ++part) {
        for (const OverdrawCount& count : counts[part]) {
          result.of[subject.parts[part].draw] += static_cast<double>(count.shaded);
          result.visible += static_cast<double>(count.visible);
        }
      }
    }
  }
  return result;
}

class Sides final : public Processor {
 public:
  explicit Sides(const Options& options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawId> asked = candidates(scene, draws, run);
    if (asked.empty()) {
      run.keep(run.findings.notes.empty() ? "no draw is double-sided"
                                          : "no double-sided draw can be changed; the notes say why");
      return draws;
    }
    sides::SideSearchOptions search = options_;
    search.views = run.views;
    search.poses = run.poses;
    search.subjects = run.subjects;
    search.seed = run.seed;
    search.cancel = run.cancel;
    if (run.progress) search.progress = [&](double part) { run.progress(0.9 * part); };
    const sides::FoundSides found = sides::find_sides(scene, asked, search, run.analyses, run.executor);
    if (run.cancelled()) return {};
    const Shaded before = shaded(scene, asked, run);
    std::map<DrawId, Counted> counts;
    for (const auto& [id, wanted] : found.wanted) counts[id] = sides::counted(wanted);
    std::map<DrawId, Choice> choices = chosen(scene, counts);
    for (;;) {
      Scene changed = scene;
      const std::map<DrawId, DrawId> added = apply(changed, found, choices);
      const Shaded after = shaded(changed, asked, run);
      if (!leave_what_does_not_pay(scene, counts, before, after, added, choices, run)) {
        tell(scene, found, counts, before, after, choices, run);
        scene = std::move(changed);
        break;
      }
    }
    std::vector<DrawId> changed;
    for (const auto& [id, choice] : choices) {
      if (choice != Choice::left) changed.push_back(id);
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
    const std::vector<bool> surrounds = sides::surrounding_draws(scene, run.executor);
    std::erase_if(result, [&](DrawId id) {
      if (!surrounds[id]) return false;
      run.note_at({id}, "surrounds",
                  "stays double-sided: it surrounds other things, so a camera may stand inside (seen-from = outside "
                  "changes it all the same)");
      return true;
    });
    return result;
  }

  std::map<DrawId, Choice> chosen(const Scene& scene, const std::map<DrawId, Counted>& counts) const {
    std::size_t triangles = 0;
    for (const Draw& draw : scene.draws) triangles += draw.full().stream().triangle_count();
    sides::ChoiceOptions options = options_;
    options.split &= scene.products.empty();  // two draws have other numbers than one, which no product must mind
    return sides::first_choices(counts, triangles, options);
  }

  /// [draw] the draw that was made beside it.
  static std::map<DrawId, DrawId> apply(Scene& scene, const sides::FoundSides& found,
                                        const std::map<DrawId, Choice>& choices) {
    sides::SingleSidedMaterials materials(scene);
    std::map<DrawId, DrawId> added;
    for (const auto& [id, choice] : choices) {
      if (choice == Choice::left) continue;
      if (choice == Choice::two_draws) {
        added[id] = static_cast<DrawId>(scene.draws.size());
        sides::split(scene, id, found.wanted.at(id), materials);
      } else {
        sides::make_single_sided(scene, id, found.wanted.at(id), materials);
      }
    }
    return added;
  }

  /// Leaves those alone that save less than they cost; whether there are any.
  bool leave_what_does_not_pay(const Scene& scene, const std::map<DrawId, Counted>& counts, const Shaded& before,
                               const Shaded& after, const std::map<DrawId, DrawId>& added,
                               std::map<DrawId, Choice>& choices, Run& run) const {
    double vertices = 0;
    for (const Draw& draw : scene.draws) vertices += static_cast<double>(draw.full().vertices->count);
    bool any = false;
    for (auto& [id, choice] : choices) {
      const Counted& count = counts.at(id);
      const auto second = added.find(id);
      double saved = value(before.of, id) - value(after.of, id);
      if (second != added.end()) saved -= value(after.of, second->second);
      if (sides::pays(choice, count, saved, before.visible, vertices, options_)) continue;
      run.note_at(
          {id}, "stays-double-sided",
          fmt::format("stays double-sided: {} of its {} triangles show their back, and {} would save {:.2f} "
                      "per cent of the fragments",
                      count.backs(), count.triangles, choice == Choice::two_draws ? "two draws" : "copies of these",
                      100 * std::max(0.0, saved) / std::max(1.0, before.visible)));
      choice = Choice::left;
      any = true;
    }
    return any;
  }

  static double value(const std::map<DrawId, double>& of, DrawId id) {
    const auto found = of.find(id);
    return found == of.end() ? 0 : found->second;
  }

  static void tell(const Scene& scene, const sides::FoundSides& found, const std::map<DrawId, Counted>& counts,
                   const Shaded& before, const Shaded& after, const std::map<DrawId, Choice>& choices, Run& run) {
    double single = 0, two = 0, added = 0, turned = 0, triangles = 0;
    for (const Draw& draw : scene.draws) triangles += static_cast<double>(draw.full().stream().triangle_count());
    for (const auto& [id, choice] : choices) {
      const Counted& count = counts.at(id);
      if (choice == Choice::left) continue;
      (choice == Choice::two_draws ? two : single) += 1;
      if (choice == Choice::single_sided) {
        run.note_at({id}, "single-sided",
                    found.is_closed.at(id) ? "drawn single-sided: closed and facing outwards, confirmed by pictures"
                                           : "drawn single-sided: no picture and no ray shows a back of it");
      } else if (choice == Choice::copies) {
        added += static_cast<double>(count.added);
        turned += static_cast<double>(count.turned);
        run.note_at({id}, "single-sided", fmt::format("drawn single-sided: {}", copies_text(count)));
      } else {
        run.note_at({id}, "two-draws",
                    fmt::format("drawn as two draws: {} of its {} triangles show their back and stay double-sided",
                                count.added + count.turned, count.triangles));
      }
    }
    double shaded_before = 0, shaded_after = 0;
    for (const auto& [id, count] : before.of) shaded_before += count;
    for (const auto& [id, count] : after.of) shaded_after += count;
    run.count_at({}, "single-sided", single);
    run.count_at({}, "two-draws", two);
    run.measure_at({}, "added", added, triangles);
    run.measure_at({}, "turned", turned, triangles);
    if (shaded_before > 0) run.measure_at({}, "fragments", shaded_after, shaded_before);
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
  table.row(&sides::ChoiceOptions::most_added, "most-added",
            "Most triangles that may be added to the scene as reversed copies, as a share of its triangles",
            {0, 1, ""});
  table.row(&sides::ChoiceOptions::split, "split",
            "Split a draw in two, one of them double-sided, where too many triangles would be added");
  table.row(&sides::ChoiceOptions::vertex_weight, "vertex-weight",
            "What a shaded vertex weighs beside a fragment: copies must save more than they add", {0, 1000, ""});
  table.row(&sides::SideSearchOptions::rays, "rays",
            "Rays cast from each side that no picture shows, half of them into an opening; more find smaller gaps and "
            "take longer",
            {0, 65536, "rays"});
  table.row(
      &sides::SideSearchOptions::checks, "checks",
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
  bind_options(plugin, std::move(table), [](const Options& options) { return std::make_unique<Sides>(options); });
  return plugin;
}

}  // namespace foredraw
