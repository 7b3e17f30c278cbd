#include <foredraw/measuring/overdraw_evaluator.h>

#include <foredraw/measuring/overdraw_details.h>
#include <foredraw/measuring/overdraw_samples.h>
#include <foredraw/measuring/overdraw_tally.h>
#include <foredraw/viewing/draw_mask.h>
#include <foredraw/viewing/drawn_orders.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace foredraw {

namespace {

std::vector<ViewTally> sums_by_view(std::span<const OverdrawTally> tallies, std::size_t views) {
  std::vector<ViewTally> sums(views);
  for (const OverdrawTally& tally : tallies) {
    for (std::size_t view = 0; view < tally.views.size(); ++view) sums[view] += tally.views[view];
  }
  return sums;
}

/// One evaluation of a scene. Where an error is wanted, how many samples there are is found out on the way.
class OverdrawEvaluation {
 public:
  OverdrawEvaluation(const OverdrawService& service, const OverdrawOptions& options, const Views& views)
      : service_(service), options_(options), samples_{views} {}

  void evaluate(const Scene& scene, Run& run) {
    SubjectsInPoses subjects{scene, subjects_of(scene, options_.subject), make_poses(scene, options_), {}};
    subjects.distinct = distinct_poses(scene, subjects.subjects, subjects.poses, run.executor);
    const OverdrawTallies tallies =
        options_.error ? counted_to(*options_.error, subjects, run) : counted(subjects, run);
    measure(subjects, tallies, run);
    if (options_.details) tell_overdraw_details(subjects, service_, samples_.views, options_.sequence, run);
    tell_of_poses(subjects, tallies, run);
    tell_what_is_not_as_drawn(scene, subjects.poses, tallies, run);
    service_.tell_more(scene, subjects.subjects, samples_.views, run);
  }

 private:
  /// What a subject counts in a pose.
  struct Counted {
    OverdrawCounts counts;  ///< empty where the subject looked so before
    std::size_t non_finite = 0;
  };

  /// Poses in parallel, few enough at a time that little is held, and merged in their sequence.
  OverdrawTallies counted(const SubjectsInPoses& subjects, Run& run) const {
    constexpr std::size_t at_a_time = 8;
    OverdrawTallies tallies(subjects, samples_.views.views.size());
    const std::size_t poses = subjects.poses.poses.size();
    std::atomic<std::size_t> done = 0;
    for (std::size_t first = 0; first < poses; first += at_a_time) {
      std::vector<std::vector<Counted>> some(std::min(at_a_time, poses - first));
      run.executor.for_each(some.size(), [&](std::size_t i) {
        some[i] = counted_in(subjects, first + i, run, [&] {
          if (run.progress) {
            run.progress(static_cast<double>(++done) / static_cast<double>(poses * subjects.subjects.size()));
          }
        });
      });
      for (std::size_t i = 0; i < some.size(); ++i) {
        for (std::size_t subject = 0; subject < some[i].size(); ++subject) {
          if (!subjects.is_new(subject, first + i)) continue;
          tallies.add(subjects, subject, first + i, some[i][subject].counts, samples_.views.views);
          tallies.non_finite[subject] = std::max(tallies.non_finite[subject], some[i][subject].non_finite);
        }
      }
    }
    return tallies;
  }

  /// Each subject that looks new in the pose.
  template <class Done>
  std::vector<Counted> counted_in(const SubjectsInPoses& subjects, std::size_t pose, Run& run, Done one_is_done) const {
    const PosedNodes nodes = posed_nodes(subjects.scene, subjects.poses.poses[pose]);
    std::vector<Counted> counted(subjects.subjects.size());
    run.executor.for_each(counted.size(), [&](std::size_t i) {
      if (run.cancelled()) throw std::runtime_error("cancelled");
      if (subjects.is_new(i, pose)) {
        const SubjectGeometry posed =
            subject_geometry(subjects.scene, subjects.subjects[i], options_.faces, nodes, run.analyses);
        counted[i].counts = drawn_in_orders(posed, subjects, i, pose, run);
        for (const RasterPart& part : posed.parts) counted[i].non_finite += count_non_finite_triangles(part);
      }
      one_is_done();
    });
    return counted;
  }

  /// From each view in the orders that the subject's tables give there, and in the sequence.
  OverdrawCounts drawn_in_orders(const SubjectGeometry& posed, const SubjectsInPoses& subjects, std::size_t i,
                                 std::size_t pose, Run& run) const {
    const Views& views = samples_.views;
    const Subject& subject = subjects.subjects[i];
    OverdrawCounts counts(posed.parts.size(), std::vector<OverdrawCount>(views.views.size()));
    for (const ViewsOfOrders& some :
         views_by_orders(subjects.scene, subject, subjects.poses.poses[pose], views.views, options_.sequence)) {
      const std::vector<RasterPart> drawn = parts_as_drawn(posed, subjects.scene, subject, some);
      const OverdrawCounts seen = service_.draw(drawn, chosen(views, some.views), run);
      for (std::size_t rank = 0; rank < seen.size(); ++rank) {
        for (std::size_t v = 0; v < some.views.size(); ++v) {
          counts[some.sequence[rank]][some.views[v]] = seen[rank][v];
        }
      }
    }
    return counts;
  }

  /// Looks from ever more sides until the error is as wanted.
  OverdrawTallies counted_to(double wanted, const SubjectsInPoses& subjects, Run& run) {
    constexpr std::size_t first = 12;
    constexpr std::size_t most = 4096;
    std::size_t most_triangles = 0;
    for (const Subject& subject : subjects.subjects) {
      most_triangles = std::max(most_triangles, count_triangles(subjects.scene, subject));
    }
    for (std::size_t views = first;;) {
      samples_ = turned_sets(views, static_cast<std::uint64_t>(options_.seed), options_.distance.value_or(0),
                             balanced_size(most_triangles));
      OverdrawTallies tallies = counted(subjects, run);
      const double bound = errors_to_bound * largest_error(tallies);
      if (bound > wanted && views < most) {
        views = std::min(most, views_for(views, bound, wanted));
        continue;
      }
      run.note("views", fmt::format("used {} x {} views of {} x {} pixels", sets_of_views, views, samples_.views.size,
                                    samples_.views.size));
      if (bound > wanted) {
        run.note(
            "error-not-reached",
            fmt::format("the error is up to {:.2g}, above the requested one; the limit of views is reached", bound));
      }
      return tallies;
    }
  }

  /// The standard error of the subject's ratio that is least sure.
  double largest_error(const OverdrawTallies& tallies) const {
    double largest = 0;
    for (const OverdrawTally& subject : tallies.subjects) largest = std::max(largest, ratio_of(subject.views).error);
    return largest;
  }

  /// Views that are samples by themselves weigh as they say; in sets of views all weigh the same.
  Estimate ratio_of(std::span<const ViewTally> views) const {
    return overdraw_ratio(summed_by_sample(views, samples_.views_in_sample), samples_.views.views);
  }

  void measure(const SubjectsInPoses& subjects, const OverdrawTallies& tallies, const Run& run) const {
    for (DrawId draw = 0; draw < tallies.draws.size(); ++draw) {
      std::vector<OverdrawTally> in_subjects;
      for (const auto& [subject, tally] : tallies.draws[draw]) in_subjects.push_back(tally);
      measure_at({draw, {}, {}}, in_subjects, run);
    }
    measure_at({}, tallies.subjects, run);
    if (subjects.poses.poses.size() == 1 || subjects.poses.poses.size() > most_told_poses) return;
    const std::vector<std::string> clips = clip_names(subjects.scene);
    for (std::size_t pose = 0; pose < tallies.poses.size(); ++pose) {
      const Estimate ratio = ratio_in_pose(tallies, pose);
      if (ratio.denominator == 0) continue;
      run.measure_at({}, fmt::format("poses.{}.ratio", pose_name(subjects.poses.poses[pose], clips)), ratio.numerator,
                     ratio.denominator, ratio.error);
    }
  }

  Estimate ratio_in_pose(const OverdrawTallies& tallies, std::size_t pose) const {
    const std::vector<ViewTally>& views = tallies.poses[pose];
    const std::size_t in_sample = std::min(samples_.views_in_sample, views.size());
    return overdraw_ratio(summed_by_sample(views, in_sample), std::vector<View>(1));
  }

  /// A place is its part in each of some subjects.
  void measure_at(About about, std::span<const OverdrawTally> tallies, const Run& run) const {
    double hidden = 0;
    double staying = 0;
    double ties = 0;
    double discarded = 0;
    OverdrawCount worst;
    std::vector<ViewTally> pictures;
    for (const OverdrawTally& tally : tallies) {
      hidden += tally.hidden;
      for (const ViewTally& view : tally.views) staying += view.visible;
      ties += tally.ties;
      discarded += tally.discarded;
      if (is_worse(tally.worst, worst)) worst = tally.worst;
      pictures.insert(pictures.end(), tally.views.begin(), tally.views.end());
    }
    const Estimate ratio = ratio_of(sums_by_view(tallies, samples_.views.views.size()));
    if (ratio.numerator + ties + discarded == 0) return;  // never seen
    const Estimate mean = overdraw_view_mean(pictures, samples_.views.views);
    run.measure_at(about, "ratio", ratio.numerator, ratio.denominator, ratio.error);
    run.measure_at(about, "view-mean", mean.numerator, mean.denominator, mean.error);
    if (worst.visible > 0) {
      run.measure_at(about, "worst-view", static_cast<double>(worst.shaded), static_cast<double>(worst.visible));
    }
    // It is (ratio - 1) times what stays, which no order changes: as unsure as the ratio is.
    run.findings.measured.push_back({"hidden", hidden, std::nullopt, ratio.error * staying, about});
    run.count_at(about, "ties", ties);
    if (about == About() && ratio.error > 0 && ties > ratio.error * ratio.denominator) {
      run.note("close",
               fmt::format(
                   "some surfaces lie closer together than depths can tell apart ({:.4f} ties per pixel, more than the "
                   "error of the ratio); another renderer may measure a different ratio",
                   ties / ratio.denominator));
    }
    if (discarded > 0) run.count_at(about, "discarded", discarded);
  }

  void tell_of_poses(const SubjectsInPoses& subjects, const OverdrawTallies& tallies, const Run& run) const {
    if (const auto why = why_at_rest(subjects.scene, options_)) run.note("at-rest", "drawn at rest: " + *why);
    const std::vector<Pose>& poses = subjects.poses.poses;
    if (poses.size() == 1) return;
    std::size_t worst = 0;
    double highest = 0;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      const Estimate ratio = ratio_in_pose(tallies, pose);
      if (ratio.denominator == 0 || ratio.numerator / ratio.denominator <= highest) continue;
      highest = ratio.numerator / ratio.denominator;
      worst = pose;
    }
    if (highest == 0) return;
    run.note("worst-pose", fmt::format("measured in {}; the worst is {}, with {:.4f} fragments per pixel",
                                       poses_text(poses.size(), count_different(subjects.distinct)),
                                       pose_name(poses[worst], clip_names(subjects.scene)), highest));
  }

  void tell_what_is_not_as_drawn(const Scene& scene, const Poses& poses, const OverdrawTallies& tallies,
                                 const Run& run) const {
    std::vector<std::string> blended;
    std::vector<std::string> unknown;
    std::string why;
    for (const Draw& draw : scene.draws) {
      if (draw.topology != Topology::triangles) continue;
      if (is_blended(scene, draw)) blended.push_back(draw.name);
      const auto mask = mask_of(run.analyses, scene, draw);
      if (const std::string* text = std::get_if<std::string>(&mask)) {
        unknown.push_back(draw.name);
        if (why.empty()) why = *text;
      }
    }
    if (!blended.empty()) {
      run.count("blended-left-out", static_cast<double>(blended.size()));
      run.note("blended", fmt::format("left out because they are blended: {}", listed_draws(blended)));
    }
    if (!unknown.empty()) {
      run.count("masked-left-out", static_cast<double>(unknown.size()));
      run.note("masked", fmt::format("left out because their holes are unknown: {}; {}", listed_draws(unknown), why));
    }
    const std::size_t non_finite =
        std::accumulate(tallies.non_finite.begin(), tallies.non_finite.end(), std::size_t{0});
    if (non_finite > 0) {
      run.count("triangles-left-out", static_cast<double>(non_finite));
      run.note("not-finite", fmt::format("{} triangles are left out: their positions are not finite", non_finite));
    }
    if (samples_.views.views == run.views.views && poses == run.poses) {
      run.note("same-views", "these are the views that orders are optimised for; other views give a fairer figure");
    }
  }

  const OverdrawService& service_;
  const OverdrawOptions& options_;
  OverdrawSamples samples_;
};

class OverdrawEvaluator final : public Evaluator {
 public:
  OverdrawEvaluator(std::unique_ptr<const OverdrawService> service, const OverdrawOptions& options)
      : service_(std::move(service)), options_(options), views_(make_views(options)) {}

  void evaluate(const Scene& scene, Run& run) const override {
    OverdrawEvaluation(*service_, options_, views_).evaluate(scene, run);
  }

  const OverdrawOptions& options() const { return options_; }

 private:
  std::unique_ptr<const OverdrawService> service_;
  OverdrawOptions options_;
  Views views_;
};

}  // namespace

std::vector<Metric> overdraw_metrics() {
  return {
      {"ratio", "fragments per pixel",
       "Fragments that pass the depth test per fragment that stays, over all views and poses; 1 is the minimum"},
      {"view-mean", "fragments per pixel", "The mean of the ratios of all views and poses, as papers report it"},
      {"worst-view", "fragments per pixel", "The highest ratio of any view and pose", true, true},
      {"hidden", "fragments",
       "Fragments that pass but do not stay, over all views and poses: a draw's part of the overdraw"},
      {"ties", "fragments", "Fragments exactly as near as what was drawn before them, over all views and poses"},
      {"discarded", "fragments",
       "Fragments that pass the depth test but fall into the holes of a mask, over all views and poses; no ratio "
       "includes them"},
      {"blended-left-out", "draws", "Blended draws, which are left out", true, false, true},
      {"masked-left-out", "draws", "Masked draws whose holes are unknown, which are left out", true, false, true},
      {"triangles-left-out", "triangles", "Triangles with positions that are not finite, which are left out", true,
       false, true},
  };
}

std::unique_ptr<Evaluator> overdraw_evaluator(std::unique_ptr<OverdrawService> service,
                                              const OverdrawOptions& options) {
  if (const auto mistake = mistake_in(static_cast<const PoseSet&>(options))) throw std::invalid_argument(*mistake);
  return std::make_unique<OverdrawEvaluator>(std::move(service), options);
}

const OverdrawOptions* overdraw_options_of(const Technique& technique) {
  const auto* held = std::get_if<std::unique_ptr<Evaluator>>(&technique);
  const auto* evaluator = held == nullptr ? nullptr : dynamic_cast<const OverdrawEvaluator*>(held->get());
  return evaluator == nullptr ? nullptr : &evaluator->options();
}

}  // namespace foredraw
