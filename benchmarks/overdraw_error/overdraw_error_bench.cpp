// How far from the truth every evaluator of overdraw is, against the time that it takes: over resolutions, numbers of
// views and ways to sample a pixel, on models of the corpus, the views turned at random by each seed. All figures go to
// a file, which overdraw_error_page.py makes a page of.
//
//     overdraw-error-bench --tsv=FILE [--seeds=N] [--quick]
//
// The truth is the orthographic integral over all directions: two differently turned Fibonacci sets of 2562 views of
// 2048 x 2048 pixels (--quick: 642 of 512), drawn by overdraw-raster on all threads. What is timed runs on one.

#include "support/meshes.h"

#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/technique/registry.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

namespace foredraw::bench {
namespace {

constexpr std::array models = {
    "static/spot", "static/head", "animated/kaykit_knight", "animated/mannequiny", "animated/robot_expressive",
    "scenes/house"};
constexpr std::array sizes = {32, 64, 128, 256, 512, 1024, 2048};
constexpr std::array counts = {12, 42, 162, 642, 2562};

struct Contestant {
  std::string evaluator;
  std::string sampling;  ///< how it differs from the evaluator's defaults
  Settings settings;
  double most_samples;  ///< of all views of a picture: what takes longer is left out
};

std::vector<Contestant> contestants(const Registry& registry) {
  const std::vector<Contestant> all = {
      {"overdraw-raster", "", {}, 0x1p27},
      {"overdraw-raster", "icosphere", {{"views", std::string("icosphere")}}, 0x1p27},
      {"overdraw-embree", "", {}, 0x1p23},
      {"overdraw-embree", "4 samples a pixel", {{"samples", std::int64_t{4}}}, 0x1p23},
      {"overdraw-vulkan", "", {}, 0x1p24},
  };
  std::vector<Contestant> there;
  for (const Contestant& contestant : all) {
    const Plugin* plugin = registry.find(contestant.evaluator);
    if (plugin == nullptr || (plugin->unavailable && plugin->unavailable())) {
      fmt::print(stderr, "{} is left out: it is not available on this machine\n", contestant.evaluator);
    } else {
      there.push_back(contestant);
    }
  }
  return there;
}

struct Measurement {
  double ratio = 0;
  double claimed = 0;  ///< standard error
  double milliseconds = 0;
};

Measurement measured(const Plugin& plugin, const Settings& settings, const Scene& scene, int threads) {
  const auto begin = std::chrono::steady_clock::now();
  const Technique technique = plugin.create(settings);
  Analyses analyses(image_decoder({}));
  const Executor executor(threads);
  Findings findings;
  const Views views;
  Run run{analyses, executor, findings, views};
  std::get<std::unique_ptr<Evaluator>>(technique)->evaluate(scene, run);
  Measurement result;
  result.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  for (const Measured& figure : findings.measured) {
    if (figure.metric != "ratio" || figure.about != About{}) continue;
    result.ratio = figure.numerator / *figure.denominator;
    result.claimed = figure.error;
  }
  return result;
}

Settings looks(int count, int size, std::int64_t rotation) {
  return {{"count", std::int64_t{count}},
          {"size", std::int64_t{size}},
          {"rotation", rotation},
          {"poses", std::string("bind")}};
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

double root_mean_square(const std::vector<double>& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

class Bench {
 public:
  Bench(const Registry& registry, int seeds, bool is_quick, std::ostream& out)
      : registry_(registry), contestants_(contestants(registry)), seeds_(seeds), is_quick_(is_quick), out_(out) {
    out_ << "model\tevaluator\tsampling\tviews\tsize\tseeds\tmilliseconds\terror\tclaimed\twithin\n";
  }

  void run(const std::string& model) {
    Diagnostics diagnostics;
    const auto file = read_scene(testing::project_file("benchmarks/corpus/" + model + ".glb").string(), diagnostics);
    if (!file) throw std::runtime_error(to_text(diagnostics));
    const double truth = truth_of(model, file->scene);
    for (const int count : counts) {
      for (const int size : sizes) run_all(model, file->scene, truth, count, size);
    }
    for (const double wanted : {0.01, 0.003, 0.001}) run_to_error(model, file->scene, truth, wanted);
  }

 private:
  double truth_of(const std::string& model, const Scene& scene) {
    const Plugin& raster = *registry_.find("overdraw-raster");
    const int count = is_quick_ ? 642 : 2562;
    const int size = is_quick_ ? 512 : 2048;
    const double one = measured(raster, looks(count, size, 1001), scene, 0).ratio;
    const double other = measured(raster, looks(count, size, 1002), scene, 0).ratio;
    fmt::print(stderr, "{}: overdraw {:.6f}, known to {:.6f}\n", model, (one + other) / 2, std::abs(one - other) / 2);
    out_ << fmt::format("{}\ttruth\t\t{}\t{}\t2\t\t{:.7f}\t\t{:.7f}\n", model, count, size, std::abs(one - other) / 2,
                        (one + other) / 2);
    return (one + other) / 2;
  }

  /// The contestants one behind the other for each seed, so that a noisy moment hits all alike.
  void run_all(const std::string& model, const Scene& scene, double truth, int count, int size) {
    std::vector<std::vector<Measurement>> by_contestant(contestants_.size());
    for (int seed = 0; seed < seeds_; ++seed) {
      for (std::size_t i = 0; i < contestants_.size(); ++i) {
        const Contestant& contestant = contestants_[i];
        if (static_cast<double>(count) * size * size > contestant.most_samples / (is_quick_ ? 16 : 1)) continue;
        Settings settings = looks(count, size, seed);
        settings.insert(contestant.settings.begin(), contestant.settings.end());
        by_contestant[i].push_back(measured(*registry_.find(contestant.evaluator), settings, scene, 1));
      }
    }
    for (std::size_t i = 0; i < contestants_.size(); ++i) {
      if (by_contestant[i].empty()) continue;
      write(model, contestants_[i], std::to_string(count), size, by_contestant[i], truth, "");
    }
  }

  void run_to_error(const std::string& model, const Scene& scene, double truth, double wanted) {
    const int trials = is_quick_ ? 3 : 13;
    std::vector<Measurement> measurements;
    int within = 0;
    for (int seed = 0; seed < trials; ++seed) {
      const Settings settings = {{"error", wanted}, {"seed", std::int64_t{seed}}, {"poses", std::string("bind")}};
      measurements.push_back(measured(*registry_.find("overdraw-raster"), settings, scene, 1));
      within += std::abs(measurements.back().ratio - truth) < wanted ? 1 : 0;
    }
    write(model, {"overdraw-raster", fmt::format("error = {}", wanted), {}, 0}, "", 0, measurements, truth,
          std::to_string(within));
  }

  void write(const std::string& model, const Contestant& contestant, const std::string& count, int size,
             const std::vector<Measurement>& measurements, double truth, const std::string& within) {
    std::vector<double> errors, claimed, times;
    for (const Measurement& measurement : measurements) {
      errors.push_back(measurement.ratio - truth);
      claimed.push_back(measurement.claimed);
      times.push_back(measurement.milliseconds);
    }
    out_ << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{:.3f}\t{:.7f}\t{:.7f}\t{}\n", model, contestant.evaluator,
                        contestant.sampling, count, size == 0 ? "" : std::to_string(size), measurements.size(),
                        median(times), root_mean_square(errors), root_mean_square(claimed), within)
         << std::flush;
  }

  const Registry& registry_;
  std::vector<Contestant> contestants_;
  int seeds_;
  bool is_quick_;
  std::ostream& out_;
};

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw;
  std::string tsv;
  int seeds = 7;
  bool is_quick = false;
  for (const std::string_view word : std::span(argv + 1, argv + argc)) {
    const std::string_view value = word.substr(std::min(word.find('=') + 1, word.size()));
    if (word.starts_with("--tsv=")) {
      tsv = value;
    } else if (word.starts_with("--seeds=")) {
      std::from_chars(value.data(), value.data() + value.size(), seeds);
    } else if (word == "--quick") {
      is_quick = true;
    } else {
      std::cerr << argv[0] << ": '" << word << "' is unknown; use --tsv=FILE, --seeds=N, --quick\n";
      return 1;
    }
  }
  std::ofstream out(tsv);
  if (!out || seeds < 1) {
    std::cerr << argv[0] << ": --tsv=FILE must name a file that can be written, and --seeds=N must be 1 or more\n";
    return 1;
  }
  Registry registry;
  add_built_in_plugins(registry);
  bench::Bench bench(registry, seeds, is_quick, out);
  for (const char* model : bench::models) bench.run(model);
  return out.flush() ? 0 : 1;
}
