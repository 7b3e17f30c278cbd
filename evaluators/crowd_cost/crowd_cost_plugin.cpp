#include "crowd_cost.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foredraw {

namespace {

constexpr double thousandths = 1000;

template <class T>
double sum_of(const std::vector<T>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Over all frames, as over all instances of all frames.
double squares_of(const std::vector<double>& rms) {
  double sum = 0;
  for (const double value : rms) sum += value * value;
  return sum;
}

void measure(const Crowd& crowd, const CrowdMethodCost& of, const About& about, const std::string& group,
             const Run& run) {
  const auto frames = static_cast<double>(of.triangles.size());
  const auto over = std::ranges::count_if(of.triangles, [&](std::uint64_t n) { return n > crowd.budget; });
  run.measure_at(about, group + "triangles", sum_of(of.triangles), frames);
  run.measure_at(about, group + "use", 100 * sum_of(of.triangles), frames * static_cast<double>(crowd.budget));
  run.measure_at(about, group + "over-budget", 100 * static_cast<double>(over), frames);
  run.measure_at(about, group + "rms", thousandths * std::sqrt(squares_of(of.rms) / frames), 1);
  run.measure_at(about, group + "largest", thousandths * *std::ranges::max_element(of.largest), 1);
  run.measure_at(about, group + "pops", sum_of(of.pops), std::max(frames - 1, 1.0));
}

/// One line for each method and each pipeline: the tables of the paper.
void tell(const Crowd& crowd, const CrowdCost& cost, const About& about, const Run& run) {
  for (const CrowdMethodCost& of : cost.methods) {
    const auto frames = static_cast<double>(of.triangles.size());
    run.note_at(
        about, "crowd",
        fmt::format(
            "{}: {:.0f} triangles a frame, {:.1f} % of the budget, {:.1f} % at most; off by {:.3f} "
            "mrad rms, {:.2f} at most; {:.2f} level changes a frame",
            to_text(of.method), sum_of(of.triangles) / frames,
            100 * sum_of(of.triangles) / (frames * static_cast<double>(crowd.budget)),
            100 * static_cast<double>(*std::ranges::max_element(of.triangles)) / static_cast<double>(crowd.budget),
            thousandths * std::sqrt(squares_of(of.rms) / frames), thousandths * *std::ranges::max_element(of.largest),
            sum_of(of.pops) / std::max(frames - 1, 1.0)));
  }
  for (const CrowdPipeline pipeline : all_crowd_pipelines) {
    const PipelineCost& of = cost.pipelines[static_cast<std::size_t>(pipeline)];
    const std::uint64_t frames = cost.methods.front().triangles.size();
    run.note_at(about, "crowd",
                fmt::format("{}: {} triangles a frame in all passes, {} vertices posed, {} bytes written, {} fetched",
                            to_text(pipeline), of.triangles / frames, of.posed / frames, of.written / frames,
                            of.fetched / frames));
  }
}

void attach(const Crowd& crowd, const CrowdCost& cost, const About& about, const Run& run) {
  Chart triangles{"triangles", "The dashed line is the budget.", "frame", "triangles of a pass", "", {}, {}};
  triangles.mark = Chart::Mark{"budget", static_cast<double>(crowd.budget)};
  Chart errors{"error", "Root mean square over all instances.", "frame", "distance from the finest level", "mrad", {},
               {}};
  Chart pops{"level changes", "Instances at another level than in the frame before.", "frame", "instances", "", {}, {}};
  for (const CrowdMethodCost& of : cost.methods) {
    const std::string name(to_text(of.method));
    std::vector<double> off;
    for (const double value : of.rms) off.push_back(thousandths * value);
    if (of.method != CrowdMethod::constant) {  // it would be so far above the others that nothing is seen of them
      triangles.lines.push_back({name, {of.triangles.begin(), of.triangles.end()}});
    }
    errors.lines.push_back({name, std::move(off)});
    pops.lines.push_back({name, {of.pops.begin(), of.pops.end()}});
  }
  for (Chart* chart : {&triangles, &errors, &pops}) run.attach_at(about, std::move(*chart));
}

class CrowdCostEvaluator final : public Evaluator {
 public:
  explicit CrowdCostEvaluator(const CrowdCostOptions& options) : options_(options) {}

  void evaluate(const Scene& scene, Run& run) const override {
    const auto* levels = scene.products.find<CrowdLevels>();
    if (levels == nullptr) {
      return run.note("no-crowd", "the scene has no levels of a crowd; put crowd-levels before it");
    }
    const std::vector<Subject> subjects = subjects_of(scene, run.subjects);
    for (const Crowd& crowd : crowds_of(*levels)) {
      if (run.cancelled()) return;
      const auto found = std::ranges::find_if(subjects, [&](const Subject& subject) {
        return std::ranges::find(subject.parts, crowd.draws.front(), &SubjectPart::draw) != subject.parts.end();
      });
      if (found == subjects.end()) continue;
      measure_crowd(scene, *levels, crowd, {.subject = static_cast<std::uint32_t>(found - subjects.begin())}, run);
    }
  }

 private:
  void measure_crowd(const Scene& scene, const CrowdLevels& levels, const Crowd& crowd, const About& about,
                     const Run& run) const {
    if (!(crowd_size(levels, crowd) > 0)) {
      return run.note_at(about, "no-size", "not measured: it has no area, so there is no size to place an eye by");
    }
    CrowdCostOptions options = options_;
    options.seed = run.seed;
    const auto cost = crowd_cost(scene, levels, crowd, options, run.cancel);
    if (!cost) return;
    for (const CrowdMethodCost& of : cost->methods) {
      measure(crowd, of, about, std::string(to_text(of.method)) + '.', run);
      if (&of == &cost->methods.back()) measure(crowd, of, about, "", run);
    }
    const auto frames = static_cast<double>(cost->methods.front().triangles.size());
    for (const CrowdPipeline pipeline : all_crowd_pipelines) {
      const PipelineCost& of = cost->pipelines[static_cast<std::size_t>(pipeline)];
      const std::string group = std::string(to_text(pipeline)) + '.';
      run.measure_at(about, group + "posed", static_cast<double>(of.posed), frames);
      run.measure_at(about, group + "written", static_cast<double>(of.written), frames);
      run.measure_at(about, group + "fetched", static_cast<double>(of.fetched), frames);
    }
    const PipelineCost& packed = cost->pipelines[static_cast<std::size_t>(CrowdPipeline::packed)];
    run.measure_at(about, "posed", static_cast<double>(packed.posed), frames);
    run.measure_at(about, "written", static_cast<double>(packed.written), frames);
    run.measure_at(about, "fetched", static_cast<double>(packed.fetched), frames);
    tell(crowd, *cost, about, run);
    tell_if_too_many(crowd, about, run);
    attach(crowd, *cost, about, run);
  }

  /// Nobody is left out, whatever the budget.
  void tell_if_too_many(const Crowd& crowd, const About& about, const Run& run) const {
    const auto fewest = std::ranges::min(crowd.levels, {}, &CrowdLevel::triangles).triangles;
    const std::uint64_t all = static_cast<std::uint64_t>(options_.instances) * fewest;
    if (all <= crowd.budget) return;
    run.note_at(
        about, "too-many",
        fmt::format("no choice keeps to the budget of {} triangles: {} instances take {} at the coarsest level; "
                    "make coarser levels, or raise crowd-levels.characters",
                    crowd.budget, options_.instances, all));
  }

  CrowdCostOptions options_;
};

}  // namespace

Plugin crowd_cost_plugin() {
  OptionTable<CrowdCostOptions> table;
  table.row(&CrowdCostOptions::instances, "instances", "Characters around the eye", {1, 1'000'000});
  table.row(&CrowdCostOptions::frames, "frames", "Frames of the path, 30 a second", {1, 100'000, "frames"});
  table.row(&CrowdCostOptions::near, "near", "How high the eye is, in sizes of a character", {0.01, 1e6, "sizes"});
  table.row(&CrowdCostOptions::far, "far", "How far away the corners of the square around the eye are",
            {0.02, 1e6, "sizes"});
  table.row(&CrowdCostOptions::eye_speed, "eye-speed", "How fast the eye walks; characters walk at up to 1.4",
            {0, 1000, "sizes a second"});
  table.row(&CrowdCostOptions::hysteresis, "hysteresis",
            "What a change of level has to gain, as a part of the mean squared error", {0, 1});
  table.choice(&CrowdCostOptions::fetching, "fetching",
               "How posed vertices of divided triangles are fetched. patch: each stored vertex once a pass, as Vulkan "
               "and Direct3D 11 do; vertex: three for each vertex that is made, as the paper's device did",
               {{"patch", CrowdFetching::by_patch}, {"vertex", CrowdFetching::by_vertex}});
  table.row(&CrowdCostOptions::passes, "passes", "Passes that draw the crowd: the picture, and maps of shadows",
            {1, 16, "passes"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "crowd-cost",
      .summary = "Walks an eye through a crowd and compares methods that choose the levels of its characters",
      .reference = "Tatarchuk, Barczak, Purnomo 2008",
      .metrics =
          {
              {"triangles", "triangles", "Triangles of a frame, in one pass"},
              {"use", "%", "Share of the budget that these triangles use", false, false, true},
              {"over-budget", "%", "Frames with more triangles than the budget"},
              {"rms", "mrad", "Root mean square error of the instances, divided by their distance"},
              {"largest", "mrad", "Largest error of an instance, divided by its distance", true, true},
              {"pops", "instances", "Instances at another level than in the frame before, for each frame"},
              {"posed", "vertices", "Vertices that are posed for a frame"},
              {"written", "bytes", "Bytes of posed vertices that are written for a frame"},
              {"fetched", "bytes", "Bytes of vertices that are fetched for a frame"},
          },
  };
  bind_options(plugin, std::move(table),
               [](const CrowdCostOptions& options) { return std::make_unique<CrowdCostEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw
