#include <foredraw/measuring/level_processor.h>

#include <foredraw/analysis/surface_distance.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foredraw {

namespace {

void require(bool good, const std::string& mistake) {
  if (!good) throw std::runtime_error(mistake);
}

void check(const MadeLevel& level, const Draw& draw) {
  const std::string of = "one of its levels of " + draw.name + " ";
  require(level.vertices != nullptr && !level.indices.empty(), of + "draws nothing");
  require(level.vertices->layout_stamp() == draw.full().vertices->layout_stamp(), of + "has different attributes");
  const bool of_triangles = draw.topology == Topology::triangles && level.indices.size() % 3 == 0;
  require(of_triangles, of + "is not made of triangles");
  const bool in_range =
      std::ranges::all_of(level.indices.view(), [&](std::uint32_t v) { return v < level.vertices->count; });
  require(in_range, of + "names a vertex that does not exist");
  const auto is_distance = [](double d) { return std::isfinite(d) && d >= 0; };
  require(is_distance(level.largest) && is_distance(level.rms.value_or(0)),
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

  /// `largest` of each level becomes the greater of what is said and what was found.
  void measure(std::vector<MadeLevel>& levels, DrawId id, const Scene& scene, Run& run) const {
    const Level& full = scene.draws[id].full();
    const auto of_full = positions_of(run.analyses, *full.vertices);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      MadeLevel& level = levels[i];
      const About about{.draw = id, .level = i + 1};
      const auto of_level = positions_of(run.analyses, *level.vertices);
      const auto found =
          surface_distance({of_full->values, full.stream().indices.view()}, {of_level->values, level.indices.view()},
                           {static_cast<std::size_t>(options_.samples), run.seed + i}, run.executor);
      require(found.has_value(),
              "one of its levels of " + scene.draws[id].name + " has no triangle with finite positions");
      run.count_at(about, "error.largest", found->largest);
      run.measure_at(about, "error.rms", found->rms, 1, found->rms_error);
      // Positions are floats, so a distance is known to some parts in ten millions.
      constexpr double slack = 1e-6, errors = 3;
      const bool is_farther = found->largest > level.largest * (1 + slack) + slack * extent(of_full->values);
      const bool is_rougher = level.rms && found->rms - errors * found->rms_error > *level.rms * (1 + slack);
      if (is_farther) {
        run.note_at(about, "error-claim",
                    fmt::format("its claimed distance from full detail is {:.4g}, but the measured one is {:.4g}",
                                level.largest, found->largest));
      }
      if (is_rougher) {
        run.note_at(about, "error-claim",
                    fmt::format("its claimed rms distance is {:.4g}, but the measured one is {:.4g} ± {:.2g}",
                                *level.rms, found->rms, found->rms_error));
      }
      level.largest = std::max(level.largest, found->largest);
    }
  }

  static double extent(const std::vector<glm::vec3>& positions) {
    double most = 0;
    for (const glm::vec3& p : positions) {
      for (int axis = 0; axis < 3; ++axis) {
        if (std::isfinite(p[axis])) most = std::max<double>(most, std::abs(p[axis]));
      }
    }
    return most;
  }

  static void put(std::vector<MadeLevel> levels, Draw& draw) {
    for (MadeLevel& made : levels) {
      Level level;
      level.vertices = std::move(made.vertices);
      level.orders.push_back({.indices = std::move(made.indices)});
      level.error = static_cast<float>(made.largest);
      draw.levels.push_back(std::move(level));
    }
  }

  static void add(Findings findings, const std::string& subject, Run& run) {
    for (Measured& measured : findings.measured) run.findings.measured.push_back(std::move(measured));
    for (Note& note : findings.notes) run.findings.notes.push_back(std::move(note));
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
  return {{"largest", "units", "Largest measured distance between a level and full detail, in either direction", true,
           true},
          {"rms", "units", "Root mean square distance between a level and full detail, in both directions"}};
}

}  // namespace foredraw
