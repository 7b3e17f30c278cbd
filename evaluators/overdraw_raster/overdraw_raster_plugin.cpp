#include "overdraw_raster.h"

#include "drawn_subject.h"
#include "overdraw_figures.h"

#include <foredraw/technique/plugin.h>
#include <foredraw/technique/view_options.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>

namespace foredraw {

namespace {

class OverdrawRasterService final : public OverdrawService {
 public:
  explicit OverdrawRasterService(Faces faces) : faces_(faces) {}

  OverdrawCounts count(const Scene& scene, const Subject& subject, const Views& views, Run& run) override {
    return overdraw_raster(drawn_subject(scene, subject, faces_, world_transforms(scene)), views, run.executor);
  }

  bool can_capture() const override { return true; }

  std::optional<FragmentLayers> layers(const Scene& scene, const Subject& subject, const Views& views, Run& run,
                                       std::size_t most_bytes) override {
    const DrawnSubject drawn = drawn_subject(scene, subject, faces_, world_transforms(scene));
    return fragment_layers(drawn.parts, views, run.executor, most_bytes);
  }

 private:
  Faces faces_;
};

/// "3 draws (Glass, Smoke, Flame/1)", with the first few names.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t few = 5;
  const std::size_t shown = std::min(few, names.size());
  return fmt::format("{} {} ({}{})", names.size(), names.size() == 1 ? "draw" : "draws",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     shown < names.size() ? ", ..." : "");
}

class OverdrawRaster final : public Evaluator {
 public:
  explicit OverdrawRaster(const OverdrawRasterOptions& options) : faces_(options.faces), views_(make_views(options)) {}

  void evaluate(const Scene& scene, Run& run) override {
    const std::vector<Subject> subjects = subjects_of(scene);
    const std::vector<glm::mat4> world = world_transforms(scene);
    OverdrawCounts by_draw(scene.draws.size(), std::vector<OverdrawCount>(views_.views.size()));
    std::vector<OverdrawCount> by_subject;                    // [subject * views + view]
    std::vector<OverdrawCounts> of_subject(subjects.size());  // [subject][part][view]
    std::vector<std::size_t> non_finite(subjects.size(), 0);
    std::atomic<std::size_t> done = 0;
    run.executor.for_each(subjects.size(), [&](std::size_t i) {
      if (run.cancelled()) throw std::runtime_error("cancelled");
      const DrawnSubject drawn = drawn_subject(scene, subjects[i], faces_, world);
      of_subject[i] = overdraw_raster(drawn, views_, run.executor);
      for (const RasterPart& part : drawn.parts) non_finite[i] += count_non_finite_triangles(part);
      if (run.progress) run.progress(static_cast<double>(++done) / static_cast<double>(subjects.size()));
    });
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      by_subject.resize((i + 1) * views_.views.size());
      for (std::size_t part = 0; part < of_subject[i].size(); ++part) {
        std::vector<OverdrawCount>& sums = by_draw[subjects[i].parts[part].draw];
        for (std::size_t view = 0; view < sums.size(); ++view) {
          sums[view] += of_subject[i][part][view];
          by_subject[i * sums.size() + view] += of_subject[i][part][view];
        }
      }
    }
    for (DrawId draw = 0; draw < by_draw.size(); ++draw) measure(run, {draw, {}}, by_draw[draw], by_draw[draw]);
    std::vector<OverdrawCount> by_view(views_.views.size());
    for (std::size_t i = 0; i < by_subject.size(); ++i) by_view[i % by_view.size()] += by_subject[i];
    measure(run, {}, by_view, by_subject);
    tell_what_is_not_as_drawn(scene, run, std::reduce(non_finite.begin(), non_finite.end()));
  }

 private:
  /// `views`: summed over whatever the place holds; `pictures`: each picture that somebody sees, for the mean.
  static void measure(const Run& run, Place place, std::span<const OverdrawCount> views,
                      std::span<const OverdrawCount> pictures) {
    OverdrawCount sum;
    for (const OverdrawCount& count : views) sum += count;
    if (sum.shaded + sum.ties == 0) return;  // never seen
    const Estimate ratio = overdraw_ratio(views);
    const Estimate mean = overdraw_view_mean(pictures);
    run.measure_at(place, "ratio", ratio.numerator, ratio.denominator, ratio.error);
    run.measure_at(place, "view-mean", mean.numerator, mean.denominator, mean.error);
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

  Faces faces_;
  Views views_;
};

void add_faces_row(OptionTable<OverdrawRasterOptions>& table) {
  table.choice(&OverdrawRasterOptions::faces, "faces",
               "Which faces are drawn: as the material culls, or front faces alone as in published figures",
               {{"material", Faces::material}, {"front", Faces::front}});
}

}  // namespace

Plugin overdraw_raster_plugin() {
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "overdraw-raster",
      .summary = "Counts overdraw exactly by drawing every subject from all sides on the processor",
      .reference = "Han, Sander 2016, section 1 (overdraw ratio); own",
      .acts_on = {traits::triangles},
      .metrics =
          {
              {"ratio", "fragments per pixel",
               "Fragments that pass the depth test over those that stay, of all views; 1 is the limit"},
              {"view-mean", "fragments per pixel", "The mean of the views' ratios, as papers print it"},
              {"ties", "fragments", "Fragments exactly as near as what was drawn before them, of all views"},
              {"blended-left-out", "draws", "Blended draws, which are left out"},
              {"triangles-left-out", "triangles", "Triangles with positions that are not finite, which are left out"},
          },
  };
  OptionTable<OverdrawRasterOptions> table;
  add_view_rows(table);
  add_faces_row(table);
  bind_options(plugin, std::move(table), [](const OverdrawRasterOptions& options) {
    if (const auto mistake = mistake_in(options)) throw std::invalid_argument(*mistake);
    return std::make_unique<OverdrawRaster>(options);
  });
  OptionTable<OverdrawRasterOptions> service_table;
  add_faces_row(service_table);
  plugin.service_options = service_table.specs();
  plugin.overdraw_service = [service_table](const Settings& settings) {
    return std::make_unique<OverdrawRasterService>(service_table.read(settings).faces);
  };
  return plugin;
}

}  // namespace foredraw
