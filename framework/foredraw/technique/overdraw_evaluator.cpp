#include <foredraw/technique/overdraw_evaluator.h>

#include <foredraw/analysis/overdraw_figures.h>
#include <foredraw/technique/overdraw_details.h>
#include <foredraw/technique/overdraw_samples.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace foredraw {

namespace {

/// "3 draws (Glass, Smoke, Flame/1)", with the first few names.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t few = 5;
  const std::size_t shown = std::min(few, names.size());
  return fmt::format("{} {} ({}{})", names.size(), names.size() == 1 ? "draw" : "draws",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     shown < names.size() ? ", ..." : "");
}

OverdrawCount sum_of(std::span<const OverdrawCount> counts) {
  OverdrawCount sum;
  for (const OverdrawCount& count : counts) sum += count;
  return sum;
}

class OverdrawEvaluator final : public Evaluator {
 public:
  OverdrawEvaluator(std::unique_ptr<OverdrawService> service, const OverdrawOptions& options)
      : service_(std::move(service)), options_(options), samples_{make_views(options)} {}

  void evaluate(const Scene& scene, Run& run) override {
    const std::vector<Subject> subjects = subjects_of(scene);
    const PosedNodes nodes = posed_nodes(scene);
    std::vector<DrawnSubject> drawn(subjects.size());
    run.executor.for_each(subjects.size(),
                          [&](std::size_t i) { drawn[i] = drawn_subject(scene, subjects[i], options_.faces, nodes); });
    const std::vector<OverdrawCounts> counts =
        options_.error ? counted_to(*options_.error, drawn, run) : counted(drawn, run);
    measure(scene, subjects, counts, run);
    if (options_.details) tell_overdraw_details(scene, subjects, drawn, *service_, samples_.views, run);
    tell_what_is_not_as_drawn(scene, drawn, run);
    service_->tell_more(scene, subjects, drawn, samples_.views, run);
  }

 private:
  /// [subject][part][view]
  std::vector<OverdrawCounts> counted(std::span<const DrawnSubject> drawn, Run& run) const {
    std::vector<OverdrawCounts> counts(drawn.size());
    std::atomic<std::size_t> done = 0;
    run.executor.for_each(drawn.size(), [&](std::size_t i) {
      if (run.cancelled()) throw std::runtime_error("cancelled");
      counts[i] = service_->draw(drawn[i].parts, samples_.views, run);
      if (run.progress) run.progress(static_cast<double>(++done) / static_cast<double>(drawn.size()));
    });
    return counts;
  }

  /// Looks from ever more sides until the error is as wanted.
  std::vector<OverdrawCounts> counted_to(double wanted, std::span<const DrawnSubject> drawn, Run& run) {
    constexpr std::size_t first = 12;
    constexpr std::size_t most = 4096;
    for (std::size_t views = first;;) {
      samples_ = turned_sets(views, static_cast<std::uint64_t>(options_.seed), options_.distance.value_or(0),
                             balanced_size(most_triangles(drawn)));
      std::vector<OverdrawCounts> counts = counted(drawn, run);
      const double bound = errors_to_bound * largest_error(counts);
      if (bound > wanted && views < most) {
        views = std::min(most, views_for(views, bound, wanted));
        continue;
      }
      run.note("views", fmt::format("looked from {} x {} views of {} x {} pixels", sets_of_views, views,
                                    samples_.views.size, samples_.views.size));
      if (bound > wanted) {
        run.note("error-not-reached", fmt::format("the error is up to {:.2g}; more views were not tried", bound));
      }
      return counts;
    }
  }

  static std::size_t most_triangles(std::span<const DrawnSubject> drawn) {
    std::size_t most = 0;
    for (const DrawnSubject& subject : drawn) {
      std::size_t triangles = 0;
      for (const RasterPart& part : subject.parts) triangles += part.indices.size() / 3;
      most = std::max(most, triangles);
    }
    return most;
  }

  /// The standard error of the subject's ratio that is least sure.
  double largest_error(std::span<const OverdrawCounts> counts) const {
    double largest = 0;
    for (const OverdrawCounts& parts : counts) {
      std::vector<OverdrawCount> sum(samples_.views.views.size());
      for (const auto& part : parts) add(sum, part);
      largest = std::max(largest, ratio_of(sum).error);
    }
    return largest;
  }

  static void add(std::span<OverdrawCount> sum, std::span<const OverdrawCount> counts) {
    for (std::size_t view = 0; view < sum.size(); ++view) sum[view] += counts[view];
  }

  /// Views that are samples by themselves weigh as they say; in sets of views all weigh the same.
  Estimate ratio_of(std::span<const OverdrawCount> views) const {
    return overdraw_ratio(summed_by_sample(views, samples_.views_in_sample), samples_.views.views);
  }

  void measure(const Scene& scene, std::span<const Subject> subjects, std::span<const OverdrawCounts> counts,
               const Run& run) const {
    const std::size_t views = samples_.views.views.size();
    OverdrawCounts by_draw(scene.draws.size(), std::vector<OverdrawCount>(views));
    std::vector<OverdrawCount> by_view(views);
    std::vector<OverdrawCount> pictures(subjects.size() * views);  // [subject * views + view]
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      for (std::size_t part = 0; part < counts[i].size(); ++part) {
        add(by_draw[subjects[i].parts[part].draw], counts[i][part]);
        add(by_view, counts[i][part]);
        add(std::span(pictures).subspan(i * views, views), counts[i][part]);
      }
    }
    for (DrawId draw = 0; draw < by_draw.size(); ++draw) measure_at({draw, {}, {}}, by_draw[draw], by_draw[draw], run);
    measure_at({}, by_view, pictures, run);
  }

  /// `views`: summed over whatever the place holds; `pictures`: each picture that somebody sees.
  void measure_at(Place place, std::span<const OverdrawCount> views, std::span<const OverdrawCount> pictures,
                  const Run& run) const {
    const OverdrawCount sum = sum_of(views);
    if (sum.shaded + sum.ties == 0) return;  // never seen
    const Estimate ratio = ratio_of(views);
    const Estimate mean = overdraw_view_mean(pictures, samples_.views.views);
    run.measure_at(place, "ratio", ratio.numerator, ratio.denominator, ratio.error);
    run.measure_at(place, "view-mean", mean.numerator, mean.denominator, mean.error);
    if (const auto worst = worst_picture(pictures)) {
      run.measure_at(place, "worst-view", static_cast<double>(pictures[*worst].shaded),
                     static_cast<double>(pictures[*worst].visible));
    }
    run.count_at(place, "hidden", static_cast<double>(sum.shaded - sum.visible));
    run.count_at(place, "ties", static_cast<double>(sum.ties));
  }

  void tell_what_is_not_as_drawn(const Scene& scene, std::span<const DrawnSubject> drawn, const Run& run) const {
    std::vector<std::string> blended;
    std::vector<std::string> masked;
    for (const Draw& draw : scene.draws) {
      if (draw.topology != Topology::triangles) continue;
      const Material* material = scene.material_of(draw);
      if (is_blended(scene, draw)) blended.push_back(draw.name);
      if (material != nullptr && material->alpha_mode == AlphaMode::mask) masked.push_back(draw.name);
    }
    if (!blended.empty()) {
      run.count("blended-left-out", static_cast<double>(blended.size()));
      run.note("blended", fmt::format("left out as blended: {}", listed(blended)));
    }
    if (!masked.empty()) run.note("masked", fmt::format("drawn as if opaque, though masked: {}", listed(masked)));
    std::size_t non_finite = 0;
    for (const DrawnSubject& subject : drawn) {
      for (const RasterPart& part : subject.parts) non_finite += count_non_finite_triangles(part);
    }
    if (non_finite > 0) {
      run.count("triangles-left-out", static_cast<double>(non_finite));
      run.note("not-finite", fmt::format("{} triangles are left out: positions that are not finite", non_finite));
    }
    if (samples_.views.views == run.views.views) {
      run.note("same-views", "these are the views that orders are optimised for; figures from others tell more");
    }
  }

  std::unique_ptr<OverdrawService> service_;
  OverdrawOptions options_;
  OverdrawSamples samples_;
};

}  // namespace

std::vector<Metric> overdraw_metrics() {
  return {
      {"ratio", "fragments per pixel",
       "Fragments that pass the depth test over those that stay, of all views; 1 is the limit"},
      {"view-mean", "fragments per pixel", "The mean of the views' ratios, as papers print it"},
      {"worst-view", "fragments per pixel", "The highest ratio of any view"},
      {"hidden", "fragments", "Fragments that pass but do not stay, of all views: a draw's part of the overdraw"},
      {"ties", "fragments", "Fragments exactly as near as what was drawn before them, of all views"},
      {"blended-left-out", "draws", "Blended draws, which are left out"},
      {"triangles-left-out", "triangles", "Triangles with positions that are not finite, which are left out"},
  };
}

std::unique_ptr<Evaluator> overdraw_evaluator(std::unique_ptr<OverdrawService> service,
                                              const OverdrawOptions& options) {
  if (const auto mistake = mistake_in(options)) throw std::invalid_argument(*mistake);
  return std::make_unique<OverdrawEvaluator>(std::move(service), options);
}

}  // namespace foredraw
