// The experiment of Han, Sander: Triangle Reordering for Reduced Overdraw in Animated Scenes, I3D 2016, on the animated
// models of the corpus, with occlusion-order beside it. All figures go to a file, which han_sander_2016_page.py makes a
// page of.
//
//     han-sander-2016-bench --tsv=FILE [--motions=N] [--keyframes=N] [--sweeps=MODEL]
//
// Of each model the N motions with most keys (6), each at N poses at most spread evenly over it (50). Orders are made
// for 162 orthographic views, and judged from 300 random views three bounding-sphere radii away, in the same poses,
// front faces alone. --sweeps adds other sizes of patches and numbers of orders, of the model's first motion.

#include "by_keyframe.h"

#include "bench_meshes.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/viewing/pose_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::array models = {
    "cesium_man_notex", "fox", "kaykit_knight", "mannequiny", "quaternius_smooth_female_dress", "robot_expressive"};
constexpr double unsorted = 3;  // lambda: every triangle a patch

struct Arguments {
  std::string tsv;
  int motions = 6;
  int keyframes = 50;
  std::string sweeps;
};

// --- what is compared ------------------------------------------------------------------------------------------------

std::string tipsy() { return fmt::format(R"({{ use = "tipsify", cache-size = {} }})", cache_size); }
std::string patched(const std::string& cut) {
  return fmt::format(R"({}, {{ use = "linear-clusters", {} }})", tipsy(), cut);
}
std::string kmeans(const std::string& cut, int k) {
  return fmt::format(R"({}, {{ use = "animated-kmeans", k = {} }})", patched(cut), k);
}

Figures ordered(Lab& lab, const Scene& scene, const std::string& stages, const std::string& motion, int keyframes) {
  const Result result = lab.run(scene, stages, keyframes);
  if (result.failed) throw std::runtime_error(to_text(result.report.diagnostics.front()));
  Figures figures = lab.measured(result.scene, motion, keyframes);
  figures.seconds = result.report.stages.back().seconds;
  return figures;
}

/// Nothing shades more vertices than `most_acmr` says.
Figures occlusion_ordered(Lab& lab, const Scene& scene, int k, double most_acmr, const std::string& motion,
                          int keyframes) {
  const std::string base = fmt::format(R"({{ use = "lookahead", cache-size = {} }})", cache_size);
  const Scene cached = lab.run(scene, base, keyframes).scene;
  const double budget = std::max(1.0, most_acmr / lab.measured(cached, motion, 1).acmr);
  return ordered(
      lab, scene,
      fmt::format(
          R"({}, {{ use = "occlusion-order", k = {}, acmr-budget = {:.4f}, vertex-weight = 0, sequences = false }})",
          base, k, budget),
      motion, keyframes);
}

// --- models and motions ----------------------------------------------------------------------------------------------

Scene model_scene(Lab& lab, const std::string& model) {
  Diagnostics diagnostics;
  auto file = read_scene(testing::project_file("benchmarks/corpus/animated/" + model + ".glb").string(), diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  return lab.run(file->scene, R"("weld")", 1).scene;
}

Scene with_motions(Scene scene, std::span<const AnimationId> motions) {
  std::vector<Animation> kept;
  for (const AnimationId id : motions) kept.push_back(scene.animations[id]);
  scene.animations = std::move(kept);
  return scene;
}

/// Those with most keys, in the file's sequence.
std::vector<AnimationId> motions_of(const Scene& scene, int most) {
  std::vector<std::pair<std::size_t, AnimationId>> keys;
  for (AnimationId id = 0; id < scene.animations.size(); ++id) {
    keys.emplace_back(make_poses(with_motions(scene, {{id}}), {.poses = "all"}).poses.size(), id);
  }
  std::ranges::stable_sort(keys, std::greater(), [](const auto& pair) { return pair.first; });
  std::vector<AnimationId> motions;
  for (const auto& [count, id] : keys) motions.push_back(id);
  if (motions.size() > static_cast<std::size_t>(most)) motions.resize(static_cast<std::size_t>(most));
  std::ranges::sort(motions);
  return motions;
}

/// As linear-clusters is told it: the paper's lambda, or where it is out of reach a growth in its place.
std::string cut_of(const Scene& scene) {
  std::size_t vertices = 0, triangles = 0;
  for (const Draw& draw : scene.draws) {
    vertices += draw.levels[0].vertices->count;
    triangles += draw.levels[0].orders[0].triangle_count();
  }
  constexpr double lambda = 0.85;
  return static_cast<double>(vertices) < lambda * static_cast<double>(triangles) ? "lambda = 0.85" : "growth = 1.3";
}

class Table {
 public:
  explicit Table(const std::string& path) : file_(path) {
    if (!file_) throw std::runtime_error(path + ": cannot be written");
    file_ << "model\ttriangles\tmotion\tkeyframes\tmethod\tcut\tk\tacmr\tratio\tseconds\n";
  }
  void begin(std::string model, std::string motion) { model_ = std::move(model), motion_ = std::move(motion); }
  void set_scene(const Scene& scene, int keyframes) {
    triangles_ = 0;
    for (const Draw& draw : scene.draws) triangles_ += draw.levels[0].orders[0].triangle_count();
    keyframes_ = make_poses(scene, {.poses = std::to_string(keyframes)}).poses.size();
  }
  void add(const std::string& method, const std::string& cut, int k, const Figures& figures) {
    const std::string row =
        fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.4f}\t{:.5f}\t{:.2f}\n", model_, triangles_, motion_, keyframes_,
                    method, cut, k, figures.acmr, figures.ratio, figures.seconds);
    file_ << row << std::flush;
    fmt::print("{}", row);
    std::fflush(stdout);
  }

 private:
  std::ofstream file_;
  std::string model_, motion_;
  std::size_t triangles_ = 0, keyframes_ = 0;
};

void run_model(Lab& lab, Table& table, const std::string& model, const Arguments& arguments) {
  const Scene scene = model_scene(lab, model);
  const std::vector<AnimationId> motions = motions_of(scene, arguments.motions);
  const std::string cut = cut_of(scene), finest = fmt::format("lambda = {}", unsorted);
  const int keyframes = arguments.keyframes;
  constexpr int k = 5;

  const Scene together = with_motions(scene, motions);
  const std::vector<std::string> names = clip_names(together);
  std::array<Result, 2> joint;
  if (motions.size() > 1) {
    for (std::size_t i = 0; i < 2; ++i) joint[i] = lab.run(together, kmeans(i == 0 ? cut : finest, k), 2 * keyframes);
  }
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const Scene alone = with_motions(scene, {&motions[m], 1});
    const std::string name = clip_names(alone)[0];
    table.begin(model, names[m]);
    table.set_scene(alone, keyframes);
    table.add("least", "", 0, least_of_sequence(lab, alone, keyframes));
    table.add("original", "", 1, ordered(lab, alone, tipsy(), name, keyframes));
    Figures sorted;
    for (const std::string& size : {cut, finest}) {
      table.add("dot-rule", size, 0,
                dot_rule_per_keyframe(lab, lab.run(alone, patched(size), keyframes).scene, keyframes));
      const Figures single = ordered(lab, alone, kmeans(size, k), name, keyframes);
      table.add("animated-kmeans", size, k, single);
      if (size == cut) sorted = single;
      if (motions.size() > 1) {
        const Result& of_all = joint[size == cut ? 0 : 1];
        Figures figures = lab.measured(of_all.scene, names[m], keyframes);
        figures.seconds = of_all.report.stages.back().seconds;
        table.add("animated-kmeans joint", size, k, figures);
      }
    }
    for (const int orders : {k, 1}) {
      table.add("occlusion-order", "", orders, occlusion_ordered(lab, alone, orders, sorted.acmr, name, keyframes));
    }
    if (arguments.sweeps != model || m > 0) continue;
    for (const char* growth : {"1", "1.05", "1.1", "1.2", "1.4", "1.7", "2.2"}) {
      const std::string size = fmt::format("growth = {}", growth);
      const Figures figures = ordered(lab, alone, kmeans(size, k), name, keyframes);
      table.add("sweep animated-kmeans", size, k, figures);
      table.add("sweep occlusion-order", size, k, occlusion_ordered(lab, alone, k, figures.acmr, name, keyframes));
    }
    for (const int orders : {1, 2, 3, 5, 8, 12, 20}) {
      table.add("sweep animated-kmeans", cut, orders, ordered(lab, alone, kmeans(cut, orders), name, keyframes));
      table.add("sweep occlusion-order", cut, orders,
                occlusion_ordered(lab, alone, orders, sorted.acmr, name, keyframes));
    }
  }
}

int number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1) {
    throw std::runtime_error(fmt::format("'{}' is not a whole number of 1 or more", text));
  }
  return value;
}

Arguments parsed(std::span<char*> words) {
  Arguments arguments;
  for (const std::string_view word : words) {
    if (word.starts_with("--tsv="))
      arguments.tsv = word.substr(6);
    else if (word.starts_with("--motions="))
      arguments.motions = number(word.substr(10));
    else if (word.starts_with("--keyframes="))
      arguments.keyframes = number(word.substr(12));
    else if (word.starts_with("--sweeps="))
      arguments.sweeps = word.substr(9);
    else
      throw std::runtime_error(
          fmt::format("'{}' is unknown; use --tsv=FILE, --motions=N, --keyframes=N, --sweeps=MODEL", word));
  }
  if (arguments.tsv.empty()) throw std::runtime_error("no output file; --tsv=FILE sets where the figures go");
  return arguments;
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** words) {
  using namespace foredraw::bench;
  try {
    const Arguments arguments = parsed({words + 1, static_cast<std::size_t>(count - 1)});
    Lab lab;
    Table table(arguments.tsv);
    for (const char* model : models) run_model(lab, table, model, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "han-sander-2016-bench: {}\n", error.what());
    return 1;
  }
}
