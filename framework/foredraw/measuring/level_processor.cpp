#include <foredraw/measuring/level_processor.h>

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/base/random.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace foredraw {

namespace {

void require(bool good, const std::string& mistake) {
  if (!good) throw std::runtime_error(mistake);
}

void check(const MadeLevel& level, const Draw& draw) {
  const std::string of = "one of its levels of " + draw.name + " ";
  const bool draws = !level.indices.empty() || draw.full().stream().indices.empty();
  require(level.vertices != nullptr && draws, of + "draws nothing");
  require(level.vertices->layout_stamp() == draw.full().vertices->layout_stamp(), of + "has different attributes");
  const bool of_triangles = draw.topology == Topology::triangles && level.indices.size() % 3 == 0;
  require(of_triangles, of + "is not made of triangles");
  const bool in_range =
      std::ranges::all_of(level.indices.view(), [&](std::uint32_t v) { return v < level.vertices->count; });
  require(in_range, of + "names a vertex that does not exist");
  const auto is_distance = [](double d) { return std::isfinite(d) && d >= 0; };
  require(is_distance(level.largest.value_or(0)) && is_distance(level.rms.value_or(0)),
          of + "claims an error that is not a distance");
}

class LevelProcessor final : public Processor {
 public:
  LevelProcessor(std::unique_ptr<const LevelMaker> maker, LevelProcessorOptions options)
      : maker_(std::move(maker)), options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<Subject> subjects = subjects_of(scene, run.subjects);
    const std::vector<std::vector<DrawId>> chosen = chosen_of(scene, subjects, draws, run);
    std::vector<SubjectLevels> made(subjects.size());
    std::vector<Findings> findings(subjects.size());
    run.executor.for_each(subjects.size(), [&](std::size_t i) {
      if (chosen[i].empty() || run.cancelled()) return;
      Run own{.analyses = run.analyses,
              .executor = run.executor,
              .findings = findings[i],
              .views = run.views,
              .poses = run.poses,
              .overdraw = run.overdraw,
              .seed = run.seed + i,
              .about = {.subject = static_cast<std::uint32_t>(i)},
              .cancel = run.cancel,
              .loans = run.loans,
              .subjects = run.subjects};
      made[i] = maker_->levels({scene, subjects[i], chosen[i]}, own);
      if (own.keeps()) made[i].clear();
      check_steps(made[i], chosen[i], scene);
      for (std::size_t d = 0; d < made[i].size(); ++d) measure(made[i][d], chosen[i][d], scene, own);
    });
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      add(std::move(findings[i]), subjects[i].name, run);
      for (std::size_t d = 0; d < made[i].size(); ++d) {
        put(std::move(made[i][d]), scene.draws[chosen[i][d]]);
        if (scene.draws[chosen[i][d]].levels.size() > 1) changed.push_back(chosen[i][d]);
      }
    }
    if (changed.empty()) run.keep("no subject gains enough from a level to justify its bytes");
    return changed;
  }

 private:
  /// A draw that is in several subjects belongs to the first.
  static std::vector<std::vector<DrawId>> chosen_of(const Scene& scene, const std::vector<Subject>& subjects,
                                                    const std::vector<DrawId>& draws, Run& run) {
    std::vector<bool> is_free(scene.draws.size(), false);
    for (const DrawId id : draws) {
      is_free[id] = scene.draws[id].levels.size() == 1;
      if (!is_free[id]) run.note_at({.draw = id}, "has-levels", "it already has levels of detail, which are kept");
    }
    std::vector<std::vector<DrawId>> chosen(subjects.size());
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      for (const SubjectPart& part : subjects[i].parts) {
        if (is_free[part.draw]) chosen[i].push_back(part.draw);
        is_free[part.draw] = false;
      }
    }
    return chosen;
  }

  static void check_steps(const SubjectLevels& made, const std::vector<DrawId>& draws, const Scene& scene) {
    require(made.empty() || made.size() == draws.size(),
            "it returned levels for a different number of draws than it was given");
    for (std::size_t d = 0; d < made.size(); ++d) {
      require(made[d].size() == made[0].size(), "it returned more levels for one draw of a subject than for another");
      for (const MadeLevel& level : made[d]) check(level, scene.draws[draws[d]]);
    }
  }

  /// `largest` of each level becomes the greatest of what is said, what is proved and that of the level before.
  void measure(std::vector<MadeLevel>& levels, DrawId id, const Scene& scene, Run& run) const {
    const Level& full = scene.draws[id].full();
    double before = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      MadeLevel& level = levels[i];
      const About about{.draw = id, .level = i + 1};
      const SurfaceInMemory of_full(run.analyses, *full.vertices, full.stream().indices);
      const SurfaceInMemory of_level(run.analyses, *level.vertices, level.indices);
      const auto farthest =
          hausdorff_distance(of_full.searched(), of_level.searched(), {.cancel = run.cancel}, run.executor);
      require(farthest.has_value(),
              "one of its levels of " + scene.draws[id].name + " has no triangle with finite positions");
      const Sampled rms = rms_between(of_full, of_level, run.seed + i, run.executor);
      run.count_at(about, "error.largest", farthest->bound);
      run.count_at(about, "error.found", farthest->found);
      run.measure_at(about, "error.rms", rms.value, 1, rms.error);
      // Positions are floats, so a distance is known to some parts in ten millions.
      constexpr double slack = 1e-6, errors = 3;
      const bool is_farther =
          level.largest && farthest->found > *level.largest * (1 + slack) + slack * of_full.points->extent();
      const bool is_rougher = level.rms && rms.value - errors * rms.error > *level.rms * (1 + slack);
      if (is_farther) {
        run.note_at(about, "error-claim",
                    fmt::format("its claimed distance from full detail is {:.4g}, but the measured one is {:.4g}",
                                *level.largest, farthest->found));
      }
      if (is_rougher) {
        run.note_at(about, "error-claim",
                    fmt::format("its claimed rms distance is {:.4g}, but the measured one is {:.4g} ± {:.2g}",
                                *level.rms, rms.value, rms.error));
      }
      if (!farthest->is_within_tolerance) {
        run.note_at(about, "error-bound",
                    fmt::format("its largest distance from full detail is hard to tell: {:.4g} is found, and no more "
                                "than {:.4g} is proved",
                                farthest->found, farthest->bound));
      }
      // The bound may lie somewhat above the distance, and so above a claim that holds.
      const bool holds = level.largest && farthest->bound > *level.largest && !is_farther &&
                         are_within(of_full.searched(), of_level.searched(), *level.largest, run);
      before = std::max({before, level.largest.value_or(0), holds ? 0 : farthest->bound});
      level.largest = before;
    }
  }

  static bool are_within(const SearchedSurface& a, const SearchedSurface& b, double distance, const Run& run) {
    const FarthestOptions search{.cancel = run.cancel};
    return is_within(a.surface, b.points, distance, search, run.executor).value_or(false) &&
           is_within(b.surface, a.points, distance, search, run.executor).value_or(false);
  }

  /// A surface with what finds its nearest points.
  struct SurfaceInMemory {
    std::shared_ptr<const Positions> positions;
    Shared<std::uint32_t> indices;
    std::shared_ptr<const ClosestPoints> points;

    SurfaceInMemory(Analyses& analyses, const VertexStreams& vertices, const Shared<std::uint32_t>& triangles)
        : positions(positions_of(analyses, vertices)),
          indices(triangles),
          points(closest_points_of(analyses, vertices, triangles)) {}

    Surface surface() const { return {positions->values, indices.view()}; }
    SearchedSurface searched() const { return {surface(), *points}; }
  };

  Sampled rms_between(const SurfaceInMemory& a, const SurfaceInMemory& b, std::uint64_t seed,
                      const Executor& executor) const {
    const auto samples = static_cast<std::size_t>(options_.samples);
    return rms_of_both(one_way_distance(a.surface(), *b.points, samples, derive_seed(seed, 0, 0), executor).rms,
                       one_way_distance(b.surface(), *a.points, samples, derive_seed(seed, 1, 0), executor).rms);
  }

  static float no_less_than(double distance) {
    const auto nearest = static_cast<float>(distance);
    return nearest < distance ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
  }

  static void put(std::vector<MadeLevel> levels, Draw& draw) {
    for (MadeLevel& made : levels) {
      Level level;
      level.vertices = std::move(made.vertices);
      level.orders.push_back({.indices = std::move(made.indices)});
      level.error = no_less_than(made.largest.value_or(0));
      draw.levels.push_back(std::move(level));
    }
  }

  static void add(Findings findings, const std::string& subject, Run& run) {
    for (Measured& measured : findings.measured) run.findings.measured.push_back(std::move(measured));
    for (Note& note : findings.notes) run.findings.notes.push_back(std::move(note));
    for (Attached& attached : findings.attached) run.findings.attached.push_back(std::move(attached));
    if (findings.nothing_to_gain) run.note("nothing-to-gain", subject + ": " + *findings.nothing_to_gain);
  }

  std::unique_ptr<const LevelMaker> maker_;
  LevelProcessorOptions options_;
};

}  // namespace

std::unique_ptr<Processor> level_processor(std::unique_ptr<const LevelMaker> maker, LevelProcessorOptions options) {
  return std::make_unique<LevelProcessor>(std::move(maker), options);
}

std::vector<Metric> level_metrics() {
  return {
      {"largest", "units", "Proved: no point of a level or of full detail is farther from the other one", true, true},
      {"found", "units", "Largest distance found between a level and full detail, either way", true, true},
      {"rms", "units", "Root mean square distance between a level and full detail, in both directions"}};
}

}  // namespace foredraw
