#include <foredraw/technique/overdraw_evaluator.h>

#include <foredraw/analysis/overdraw_figures.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <numeric>
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

class OverdrawEvaluator final : public Evaluator {
 public:
  OverdrawEvaluator(std::unique_ptr<OverdrawService> service, const OverdrawOptions& options)
      : service_(std::move(service)), faces_(options.faces), views_(make_views(options)) {}

  void evaluate(const Scene& scene, Run& run) override {
    const std::vector<Subject> subjects = subjects_of(scene);
    const std::vector<glm::mat4> world = world_transforms(scene);
    std::vector<OverdrawCounts> of_subject(subjects.size());  // [subject][part][view]
    std::vector<std::size_t> non_finite(subjects.size(), 0);
    std::atomic<std::size_t> done = 0;
    run.executor.for_each(subjects.size(), [&](std::size_t i) {
      if (run.cancelled()) throw std::runtime_error("cancelled");
      const DrawnSubject drawn = drawn_subject(scene, subjects[i], faces_, world);
      of_subject[i] = service_->draw(drawn.parts, views_, run);
      for (const RasterPart& part : drawn.parts) non_finite[i] += count_non_finite_triangles(part);
      if (run.progress) run.progress(static_cast<double>(++done) / static_cast<double>(subjects.size()));
    });

    const std::size_t views = views_.views.size();
    OverdrawCounts by_draw(scene.draws.size(), std::vector<OverdrawCount>(views));
    std::vector<OverdrawCount> pictures(subjects.size() * views);  // [subject * views + view]
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      for (std::size_t part = 0; part < of_subject[i].size(); ++part) {
        for (std::size_t view = 0; view < views; ++view) {
          by_draw[subjects[i].parts[part].draw][view] += of_subject[i][part][view];
          pictures[i * views + view] += of_subject[i][part][view];
        }
      }
    }
    for (DrawId draw = 0; draw < by_draw.size(); ++draw) measure(run, {draw, {}, {}}, by_draw[draw], by_draw[draw]);
    std::vector<OverdrawCount> by_view(views);
    for (std::size_t i = 0; i < pictures.size(); ++i) by_view[i % views] += pictures[i];
    measure(run, {}, by_view, pictures);
    tell_what_is_not_as_drawn(scene, run, std::reduce(non_finite.begin(), non_finite.end()));
    service_->tell_more(scene, views_, run);
  }

 private:
  /// `views`: summed over whatever the place holds; `pictures`: each picture that somebody sees, for the mean.
  void measure(const Run& run, Place place, std::span<const OverdrawCount> views,
               std::span<const OverdrawCount> pictures) const {
    OverdrawCount sum;
    for (const OverdrawCount& count : views) sum += count;
    if (sum.shaded + sum.ties == 0) return;  // never seen
    const Estimate ratio = overdraw_ratio(views, views_.views);
    const Estimate mean = overdraw_view_mean(pictures, views_.views);
    run.measure_at(place, "ratio", ratio.numerator, ratio.denominator, ratio.error);
    run.measure_at(place, "view-mean", mean.numerator, mean.denominator, mean.error);
    if (const auto worst = worst_picture(pictures)) {
      run.measure_at(place, "worst-view", static_cast<double>(pictures[*worst].shaded),
                     static_cast<double>(pictures[*worst].visible));
    }
    run.count_at(place, "ties", static_cast<double>(sum.ties));
  }

  void tell_what_is_not_as_drawn(const Scene& scene, const Run& run, std::size_t non_finite) const {
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
    if (non_finite > 0) {
      run.count("triangles-left-out", static_cast<double>(non_finite));
      run.note("not-finite", fmt::format("{} triangles are left out: positions that are not finite", non_finite));
    }
    if (views_.views == run.views.views) {
      run.note("same-views", "these are the views that orders are optimised for; figures from others tell more");
    }
  }

  std::unique_ptr<OverdrawService> service_;
  Faces faces_;
  Views views_;
};

}  // namespace

std::vector<Metric> overdraw_metrics() {
  return {
      {"ratio", "fragments per pixel",
       "Fragments that pass the depth test over those that stay, of all views; 1 is the limit"},
      {"view-mean", "fragments per pixel", "The mean of the views' ratios, as papers print it"},
      {"worst-view", "fragments per pixel", "The highest ratio of any view"},
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
