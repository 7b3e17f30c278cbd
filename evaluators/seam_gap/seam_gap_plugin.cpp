#include "direction_gap.h"
#include "influence_gap.h"
#include "seam_gap.h"

#include <foredraw/displaced/map_seams.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foredraw {

namespace {

constexpr std::size_t named_edges = 3;

std::string side_text(const Scene& scene, const MapSeams& of, const EdgeSide& side) {
  return fmt::format("{}, triangle {}, edge {}", scene.draws[of.draws[side.mesh]].name, side.triangle, side.corner);
}

class SeamGapEvaluator final : public Evaluator {
 public:
  explicit SeamGapEvaluator(SeamGapOptions options) : options_(options) {}

  void evaluate(const Scene& scene, Run& run) const override {
    std::vector<DrawId> draws;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const Material* material = scene.material_of(scene.draws[id]);
      if (material != nullptr && material->displacement) draws.push_back(id);
    }
    const SceneSeams found = seams_of_maps(scene, draws, run.analyses, run.cancel);
    if (run.cancelled()) return;
    for (const auto& [draw, why] : found.left_out) run.note_at({.draw = draw}, "no-seams", "not measured: " + why);
    std::vector<SeamGap> gaps(found.maps.size());
    run.executor.for_each(gaps.size(), [&](std::size_t i) {
      if (!run.cancelled()) gaps[i] = seam_gap(found.maps[i].seams, found.maps[i].sampled(), options_);
    });
    measure(gaps, run);
    for (std::size_t i = 0; i < gaps.size(); ++i) name_edges(scene, found.maps[i], gaps[i], run);
    measure_vertices(scene, found, run);
  }

 private:
  static void measure(const std::vector<SeamGap>& gaps, const Run& run) {
    SeamGap all;
    for (const SeamGap& gap : gaps) {
      all.edges += gap.edges;
      all.samples += gap.samples;
      all.largest = std::max(all.largest, gap.largest);
      all.squares += gap.squares;
      all.points += gap.points;
      all.unequal += gap.unequal;
      all.below += gap.below;
      all.torn += gap.torn;
    }
    const auto part = [&](const char* metric, std::size_t of, std::size_t all_there) {
      if (all_there > 0) run.measure(metric, static_cast<double>(of), static_cast<double>(all_there) / 100);
    };
    run.count("edges", static_cast<double>(all.edges));
    part("unequal", all.unequal, all.points);
    part("below", all.below, all.edges);
    part("torn", all.torn, all.edges);
    if (all.samples == 0) return;
    run.measure("largest", all.largest, 0.01);
    run.measure("rms", std::sqrt(all.squares / static_cast<double>(all.samples)), 0.01);
  }

  /// Those with the largest gaps, if these are there at any factor.
  static void name_edges(const Scene& scene, const MapSeams& of, const SeamGap& gap, const Run& run) {
    std::vector<std::size_t> order(of.seams.edges.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t e) { return gap.largest_of[e]; });
    for (std::size_t i = 0; i < std::min(order.size(), named_edges) && gap.largest_of[order[i]] > 0; ++i) {
      const auto sides = of.seams.sides_of(of.seams.edges[order[i]]);
      run.note_at({.draw = of.draws[sides.front().mesh]}, "seam",
                  fmt::format("between {} and {} heights differ by {:.2g} of the map's range; equal at tessellation "
                              "levels up to {} (the factor is {})",
                              side_text(scene, of, sides.front()), side_text(scene, of, sides.back()),
                              gap.largest_of[order[i]], gap.factors[order[i]], gap.rule[order[i]]));
    }
  }

  /// What vertices at one position have, of the draws that were measured, those of a mesh together.
  static void measure_vertices(const Scene& scene, const SceneSeams& found, const Run& run) {
    std::vector<bool> is_measured(scene.draws.size(), false);
    for (const MapSeams& of : found.maps) {
      for (const DrawId id : of.draws) is_measured[id] = true;
    }
    DirectionGap all;
    InfluenceGap influences;
    for (const Mesh& mesh : scene.meshes) {
      std::vector<std::vector<glm::vec3>> positions, normals;
      std::vector<DrawId> draws;
      for (const DrawId id : mesh.draws) {
        if (!is_measured[id]) continue;
        is_measured[id] = false;  // a draw of several meshes counts once
        draws.push_back(id);
        const VertexStreams& vertices = *scene.draws[id].full().vertices;
        const VertexStream* stored = vertices.find("NORMAL");
        positions.push_back(decode_vec3(*vertices.find("POSITION")));
        normals.push_back(stored == nullptr ? std::vector<glm::vec3>{} : decode_vec3(*stored));
      }
      std::vector<DirectedPart> parts;
      std::vector<const VertexStreams*> streams;
      for (std::size_t i = 0; i < draws.size(); ++i) {
        parts.push_back({positions[i], normals[i], scene.draws[draws[i]].full().stream().indices.view()});
        streams.push_back(scene.draws[draws[i]].full().vertices.get());
      }
      const InfluenceGap own = influence_gap(streams);
      influences.shared += own.shared;
      influences.unequal += own.unequal;
      const DirectionGap gap = direction_gap(parts);
      all.shared += gap.shared;
      all.split += gap.split;
      all.largest = std::max(all.largest, gap.largest);
    }
    tell(influences, run);
    if (all.shared == 0) return;
    run.measure("split", static_cast<double>(all.split), static_cast<double>(all.shared) / 100);
    run.measure("direction", all.largest, 1);
  }

  static void tell(const InfluenceGap& gap, const Run& run) {
    if (gap.shared == 0) return;
    run.measure("weights", static_cast<double>(gap.unequal), static_cast<double>(gap.shared) / 100);
    if (gap.unequal == 0) return;
    run.note("weights-differ",
             fmt::format("at {} of {} positions vertices follow joints by different weights: the surface tears there "
                         "in poses, whatever the map says; give all vertices of a position the same weights",
                         gap.unequal, gap.shared));
  }

  SeamGapOptions options_;
};

}  // namespace

Plugin seam_gap_plugin() {
  OptionTable<SeamGapOptions> table;
  table.row(&SeamGapOptions::samples, "samples", "Points on each seam edge at which the gap is taken",
            {2, 100'000, "points"});
  table.row(&SeamGapOptions::bits, "bits", "How many bits of the heights have to agree on both sides", {1, 16, "bits"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "seam-gap",
      .summary = "Measures how far a displacement map's heights differ between the sides of the layout's seams",
      .reference = "own",
      .acts_on = {traits::displaced},
      .metrics =
          {
              {"unequal", "% of the points", "Points at the edges' factors whose sides differ as whole numbers"},
              {"largest", "% of the range", "Largest gap along the seams"},
              {"rms", "% of the range", "Root mean square gap along the seams"},
              {"below", "% of the edges", "Seam edges that gape at the largest factor that their texels allow"},
              {"torn", "% of the edges", "Seam edges that gape at an end, and so at every factor"},
              {"split", "% of the positions", "Positions of several vertices whose normals differ"},
              {"direction", "degrees", "Largest angle from such a normal to the position's direction"},
              {"weights", "% of the positions", "Positions of several vertices whose weights of joints differ"},
              {"edges", "edges", "Seam edges", true, false, true},
          },
  };
  bind_options(plugin, std::move(table),
               [](const SeamGapOptions& options) { return std::make_unique<SeamGapEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw
