#include "draw_sequence.h"

#include <foredraw/measuring/subject_capture.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::size_t most_parts = 1024;  // every one is tried at every place, from every start

/// Why there is nothing to decide; empty where there is.
std::string why_not(const SubjectView& view, const Run& run) {
  const std::size_t parts = view.subject.parts.size();
  if (run.about.level > 0) return "coarser levels are drawn in the sequence of full detail";
  if (parts < 2) return "a single draw has no sequence";
  if (parts > most_parts) return fmt::format("it has {} draws; at most {} are put into sequence", parts, most_parts);
  if (!view.scene.products.empty()) return "something in the scene may refer to its draws by their place";
  if (view.groups.empty()) return "none of its draws can change places in the file";
  return {};
}

/// The parts that are drawn elsewhere among the others: all but those of a longest rising row.
std::vector<std::uint32_t> moved_parts(std::span<const std::uint32_t> sequence) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> length(sequence.size(), 1), last(sequence.size(), none);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (sequence[j] > sequence[i] || length[j] < length[i]) continue;
      length[i] = length[j] + 1;
      last[i] = j;
    }
  }
  std::vector<bool> stays(sequence.size(), false);
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  for (std::size_t i = longest; i != none; i = last[i]) stays[i] = true;
  std::vector<std::uint32_t> moved;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (!stays[i]) moved.push_back(sequence[i]);
  }
  return moved;
}

/// Draws are large beside triangles: small pictures tell which of them hides which, and so do poses that share views.
SubjectCapture captured_by_draws(const SubjectView& view, const Run& run) {
  constexpr int small = 64;
  const Views views{run.views.views, std::min(run.views.size, small)};
  Run in_small{.analyses = run.analyses,
               .executor = run.executor,
               .findings = run.findings,
               .views = views,
               .overdraw = run.overdraw,
               .about = run.about,
               .cancel = run.cancel,
               .subjects = run.subjects};
  Poses poses = run.poses;
  poses.share_views = true;
  return capture_subject(
      view, poses,
      [](const Draw& draw) {
        const auto triangles = static_cast<std::uint32_t>(draw.full().stream().triangle_count());
        return triangles > 0 ? Clusters{{0, triangles}} : Clusters{{0}};
      },
      in_small);
}

class DrawSequenceOrderer final : public SubjectOrderer {
 public:
  explicit DrawSequenceOrderer(const DrawSequenceOptions& options) : options_(options) {}

  SubjectOrders order(const SubjectView& view, Run& run) const override {
    if (const std::string why = why_not(view, run); !why.empty()) {
      run.keep(why);
      return {};
    }
    if (!may_overdraw(view, run)) return {};
    const SubjectCapture captured = captured_by_draws(view, run);
    DrawSequenceOptions options = options_;
    options.seed = run.seed;
    JudgedSequence found = judged_sequence(captured.seen, static_cast<std::uint32_t>(view.subject.parts.size()),
                                           view.groups, options, run.executor);
    if (std::ranges::is_sorted(found.sequence)) {
      run.keep("no sequence of its draws was found in which less is overdrawn");
      return {};
    }
    if (!is_confirmed(found, run)) return {};
    tell(view, found, run);
    return {{}, {}, std::move(found.sequence)};
  }

 private:
  static double ratio(const ViewTally& tally) { return tally.shaded / tally.visible; }

  static bool is_confirmed(const JudgedSequence& found, Run& run) {
    if (found.before.visible == 0) {
      run.keep("there are too few views and poses to hold some out, which judge the sequence");
      return false;
    }
    if (found.after.shaded < found.before.shaded) return true;
    run.keep(fmt::format(
        "measured from held-out views, overdraw between draws is {:.4f}, and {:.4f} in the sequence that was found",
        ratio(found.before), ratio(found.after)));
    return false;
  }

  static void tell(const SubjectView& view, const JudgedSequence& found, const Run& run) {
    constexpr std::size_t most_named = 8;
    std::vector<std::string> names;
    for (const std::uint32_t part : moved_parts(found.sequence)) {
      names.push_back(view.scene.draws[view.subject.parts[part].draw].name);
    }
    const std::size_t unnamed = names.size() - std::min(names.size(), most_named);
    names.resize(names.size() - unnamed);
    const std::string more = unnamed > 0 ? fmt::format(" and {} more", unnamed) : "";
    run.note(
        "sequence",
        fmt::format("measured from held-out views, overdraw between draws falls from {:.4f} to {:.4f}; moved: {}{}",
                    ratio(found.before), ratio(found.after), fmt::join(names, ", "), more));
  }

  DrawSequenceOptions options_;
};

}  // namespace

Plugin draw_sequence_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "draw-sequence",
      .summary =
          "Puts the draws of a subject into the sequence that overdraws least, as measured; put occlusion-order after "
          "it",
      .reference = "own; one start as in Eades, Lin, Smyth 1993",
      .acts_on = {traits::triangles},
      .breaks = {traits::overdraw_ordered},
      .pays_if =
          "the subject has several draws, and the new sequence lowers overdraw from views held out of the search",
      .uses_overdraw = true,
  };
  OptionTable<DrawSequenceOptions> table;
  table.row<int>(&DrawSequenceOptions::restarts, "restarts",
                 "Random sequences that the search starts from, besides the present one and two more; the best result "
                 "is kept",
                 {0, 1000, "times"});
  bind_options(plugin, table,
               [](const DrawSequenceOptions& options) { return std::make_unique<DrawSequenceOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
