#include "tessellation_levels.h"
#include "tessellation_levels_product.h"

#include <foredraw/displaced/height_bits.h>
#include <foredraw/displaced/height_range.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

struct Options {
  LevelMethod method = LevelMethod::content;
  LevelGoal goal = LevelGoal::rms;
  std::optional<std::uint32_t> triangles;
  std::optional<double> error;
};

/// Without any limit: so many times the triangles that there are.
constexpr std::uint64_t usual_triangles = 4;

/// The displaced draws of a mesh, which share edges.
struct DisplacedDraws {
  std::vector<DrawId> draws;
  std::vector<LaidOutMap> maps;
  std::vector<std::vector<glm::vec3>> positions;

  std::vector<HeightPart> parts(const Scene& scene) const {
    std::vector<HeightPart> parts;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      parts.push_back({positions[i], scene.draws[draws[i]].full().stream().indices.view(), maps[i].places,
                       maps[i].sampled(), maps[i].displacement.factor});
    }
    return parts;
  }
};

DisplacementRange displacement_range(const HeightRange& heights, const Displacement& displacement) {
  const auto at = [&](std::uint32_t height) {
    return displacement.offset + displacement.factor * foredraw_height_part(height >> (16 - height_bits), height_bits);
  };
  const auto [least, most] = std::minmax({at(heights.least), at(heights.most)});
  return {least, most};
}

DrawTessellation stored(DrawId id, const Draw& draw, const LaidOutMap& map, std::span<const LogLevels> levels,
                        std::vector<TessellationScale> scales) {
  const IndexStream& stream = draw.full().stream();
  const auto indices = stream.indices.view();
  const HeightRanges heights(map.sampled());
  std::vector<std::uint32_t> begins = range_begins(stream);
  std::vector<DisplacementRange> ranges;
  for (std::size_t r = 0; r < begins.size(); ++r) {
    const std::size_t end = r + 1 < begins.size() ? begins[r + 1] : levels.size();
    HeightRange range;
    for (std::size_t t = begins[r]; t < end; ++t)
      range.add(
          heights.over({map.places[indices[3 * t]], map.places[indices[3 * t + 1]], map.places[indices[3 * t + 2]]}));
    ranges.push_back(displacement_range(range, map.displacement));
  }
  return {id, Shared<LogLevels>({levels.begin(), levels.end()}), std::move(scales), Shared(std::move(begins)),
          Shared(std::move(ranges))};
}

class TessellationLevelsProcessor final : public Processor {
 public:
  explicit TessellationLevelsProcessor(Options options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const auto* before = scene.products.find<StoredTessellations>();
    StoredTessellations all = before == nullptr ? StoredTessellations{} : *before;
    std::vector<DrawId> made;
    double undivided = 0;
    const std::vector<DisplacedDraws> measured = meshes(scene, draws, run);
    if (measured.empty()) {
      run.keep("no draw shows a map of heights that can be measured; the notes say why");
      return {};
    }
    for (const DisplacedDraws& mesh : measured) {
      if (run.cancelled()) return {};
      const std::vector<HeightPart> parts = mesh.parts(scene);
      const TessellationLimits limits = limits_of(parts);
      const ChosenLevels chosen = tessellation_levels(parts, options_.method, limits, run.executor);
      undivided = std::max(undivided, chosen.plain.rms);
      if (chosen.chosen.triangles == chosen.plain.triangles) {
        run.note_at({.draw = mesh.draws.front()}, "not-divided",
                    fmt::format("no level is above 1: its triangles show the displacement with an error of {:.4g} rms, "
                                "{:.4g} at most",
                                chosen.plain.rms, chosen.plain.largest));
        continue;
      }
      tell(chosen, limits, {.draw = mesh.draws.front()}, run);
      std::size_t first = 0;
      for (std::size_t i = 0; i < mesh.draws.size(); ++i) {
        const DrawId id = mesh.draws[i];
        const std::size_t count = parts[i].indices.size() / 3;
        std::erase_if(all.draws, [&](const DrawTessellation& of) { return of.draw == id; });
        all.draws.push_back(stored(id, scene.draws[id], mesh.maps[i], std::span(chosen.levels).subspan(first, count),
                                   chosen.scales[i]));
        first += count;
        made.push_back(id);
        const TessellationScale& scale = chosen.scales[i].front();
        run.count_at({.draw = id}, "triangles", scale.triangles);
        run.measure_at({.draw = id}, "rms-error", scale.rms, 1);
        run.measure_at({.draw = id}, "largest-error", scale.largest, 1);
      }
    }
    if (made.empty()) {
      run.keep(fmt::format("undivided triangles show the displacement with an error of {:.4g} units rms", undivided));
      return {};
    }
    std::ranges::sort(all.draws, {}, &DrawTessellation::draw);
    std::ranges::sort(made);
    scene.products.set(std::move(all));
    return made;
  }

 private:
  static std::vector<DisplacedDraws> meshes(const Scene& scene, const std::vector<DrawId>& draws, Run& run) {
    std::vector<DisplacedDraws> result;
    std::vector<bool> is_taken(scene.draws.size(), false);
    const auto take = [&](DrawId id, DisplacedDraws& mesh) {
      if (is_taken[id] || !std::ranges::binary_search(draws, id)) return;
      is_taken[id] = true;
      auto map = laid_out_map(scene, id, run.analyses);
      if (const std::string* why = std::get_if<std::string>(&map)) {
        run.note_at({.draw = id}, "no-levels", "no levels: " + *why);
        return;
      }
      mesh.draws.push_back(id);
      mesh.maps.push_back(std::get<LaidOutMap>(std::move(map)));
      mesh.positions.push_back(decode_vec3(*scene.draws[id].full().vertices->find("POSITION")));
    };
    for (const Mesh& mesh : scene.meshes) {
      DisplacedDraws of;
      for (const DrawId id : mesh.draws) take(id, of);
      if (!of.draws.empty()) result.push_back(std::move(of));
    }
    for (const DrawId id : draws) {  // that no mesh has
      DisplacedDraws of;
      take(id, of);
      if (!of.draws.empty()) result.push_back(std::move(of));
    }
    return result;
  }

  TessellationLimits limits_of(std::span<const HeightPart> parts) const {
    TessellationLimits limits{.error = options_.error, .goal = options_.goal};
    if (options_.triangles) limits.triangles = *options_.triangles;
    if (limits.triangles || limits.error) return limits;
    std::uint64_t triangles = 0;
    for (const HeightPart& part : parts) triangles += part.indices.size() / 3;
    limits.triangles = usual_triangles * triangles;
    return limits;
  }

  static void tell(const ChosenLevels& of, const TessellationLimits& limits, const About& about, Run& run) {
    const double error = limits.goal == LevelGoal::rms ? of.chosen.rms : of.chosen.largest;
    if (limits.error && error > *limits.error) {
      run.note_at(about, "error-not-reached",
                  fmt::format("the error is {:.4g}, above the requested {:.4g}: {}", error, *limits.error,
                              limits.triangles ? "it would take more triangles than `triangles` allows, or a finer map"
                                               : "no level of 64 or fewer parts, each a texel long, comes closer"));
    }
  }

  Options options_;
};

}  // namespace

Plugin tessellation_levels_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "tessellation-levels",
      .summary = "Chooses how finely a tessellator divides each triangle, by what the map of heights shows on it",
      .reference = "own; levels for each edge: Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::triangles, traits::displaced},
      .uses = {traits::clustered},
      .pays_if = "some triangles have to be divided further than others to show the map",
      .lossless = true,
      .metrics = {{"triangles", "triangles", "Triangles that a tessellator makes of the levels", true},
                  {.name = "rms-error",
                   .unit = "units",
                   .doc = "Root of the mean square, over the area, of how far displacements are off",
                   .worst_stands = true},
                  {.name = "largest-error",
                   .unit = "units",
                   .doc = "How far a displacement is off at most",
                   .worst_stands = true}},
  };
  plugin.products = {tessellation_levels_product()};
  OptionTable<Options> table;
  table.choice(&Options::method, "method",
               "What levels follow: the error that a triangle would have, the length of its edges, or nothing",
               {{"content", LevelMethod::content},
                {"edge-length", LevelMethod::edge_length},
                {"constant", LevelMethod::constant}});
  table.choice(&Options::goal, "goal", "Which error is to be small",
               {{"rms", LevelGoal::rms}, {"max", LevelGoal::largest}});
  table.row(
      &Options::triangles, "triangles",
      "Most triangles that a tessellator may make of a mesh; without it and `error`, four times as many as it has",
      {1, 4'000'000'000, "triangles"});
  table.row(&Options::error, "error",
            "Error of displacements to reach with as few triangles as possible, and never with more than `triangles`",
            {0, 1e30, "units"});
  bind_options(plugin, table,
               [](const Options& options) { return std::make_unique<TessellationLevelsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
